#include "production/jobs/open_session.h"

#include <algorithm>

#include "error/error.h"
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

Session open_session(const SceneRequest& request, const ProgressSink& progress) {
    const Scene scene = load_scene(request.file, request.overrides, request.outside);
    refuse_two_sizes(request);
    return session_of(scene, {installed_fonts(), request.print, request.times_s}, progress);
}

}  // namespace poinsot
