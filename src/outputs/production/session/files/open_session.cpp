#include "production/session/files/open_session.h"

#include <algorithm>

#include "error/error.h"
#include "system/interrupt.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {

namespace {

void refuse_two_sizes(const SceneRequest& request) {
    if (!request.print.width_mm && !request.print.height_mm) return;
    if (is_given(request.overrides, "film.size"))
        throw InputError(
            "--size and --width-mm or --height-mm both set the picture's size; leave one out");
}

}  // namespace

std::string text_of(const SceneRequest& request) {
    return request.text ? *request.text : text_of_file(request.file);
}

Scene scene_of(const SceneRequest& request) {
    return parse_scene(text_of(request), request.file, request.overrides,
                       files_of_folder(request.outside));
}

Session open_session(const SceneRequest& request, const Task& task) {
    const StopsWhen stops(task.stop);
    const Scene scene = scene_of(request);
    refuse_two_sizes(request);
    return session_of(scene, {installed_fonts(), request.print, request.times_s, request.draws},
                      task);
}

}  // namespace poinsot
