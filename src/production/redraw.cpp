#include "production/redraw.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "error/error.h"
#include "image/pixel_check.h"
#include "image/png.h"
#include "output/film_metadata.h"
#include "production/film_job.h"
#include "production/output_place.h"
#include "production/record.h"
#include "production/still_job.h"
#include "production/vectors/journal.h"
#include "system/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// What keeps this machine from drawing as the one that made the file, in words for the user.
void note_differences(const Record& then, const Record& now, const Telling& telling) {
    const auto note = [&](std::string_view what, const std::string& was, const std::string& is) {
        if (was == is) return;
        telling.say(fmt::format("note: made with {} {}, this is {}: the bytes may differ", what,
                                printable(was), printable(is)));
    };
    note("poinsot", then.version, now.version);
    note("the renderer", then.renderer, now.renderer);
    if (!then.processor.empty()) note("the processor", then.processor, now.processor);
    note("Mesa", then.mesa, now.mesa);
    note("the fonts", then.fonts, now.fonts);
}

// One frame of a sequence carries the record of the whole, whose histories it shows.
void redraw_frame(const RedrawRequest& request, const Record& record, const Session& session,
                  Easel& easel) {
    // A picture of an older poinsot does not say which of the frames it is.
    const auto frame = record.frame ? record.frame : frame_of_name(request.file);
    const auto [first, last] = *record.frames;
    if (!frame || *frame < first || *frame > last)
        throw InputError(fmt::format(
            "{}: is one of the frames {}-{} of a sequence, and its name does not say which; let "
            "the name end in the frame's number",
            printable(request.file.string()), first, last));
    const FilmPlan film = film_plan(session);
    PictureMaker pictures(session, easel,
                          {.first_time_s = film.time_of(0), .last_time_s = film.time_of(last)});
    Image image;
    pictures.draw(film.moment_of(*frame), image);
    Record again = record_of(session, pictures, easel.is_portable());
    again.frames = record.frames;
    PngOptions png;
    png.texts[metadata_name] =
        told(to_text(again), {.frame = *frame, .pixels = pixel_check(image)});
    write_png(request.output, image, png);
}

// The request, its output with the scene's name and the frame's number put in.
RedrawRequest with_its_names(RedrawRequest request, const Record& record) {
    const bool one_frame = record.frames && suffix_of(request.file) == ".png";
    const auto frame = record.frame ? record.frame : frame_of_name(request.file);
    request.output =
        numbered_output(request.output, one_frame ? frame.value_or(0) : 0, record.scene_name);
    std::error_code not_there;
    if (std::filesystem::equivalent(request.file, request.output, not_there))
        throw InputError(fmt::format("{}: is the file that is to be drawn again; name another",
                                     printable(request.output.string())));
    return request;
}

// The record's scene, read as a file of its name in this folder would be.
Scene scene_of(const RedrawRequest& request, const Record& record) {
    Scene scene = parse_scene(record.scene_toml, record.scene_name + ".toml", {}, request.outside);
    scene.notes.clear();
    if (mesh_hash_of(scene) == record.mesh_hash) return scene;
    std::string files = scene.body.mesh.empty() ? scene.object.mesh : scene.body.mesh;
    for (const FacePictureSpec& picture : scene.object.pictures)
        files += (files.empty() ? "" : ", ") + picture.file;
    throw InputError(fmt::format("{}: {} is not what it was drawn with; put that back",
                                 printable(request.file.string()), printable(files)));
}

StillRequest still_request_of(const RedrawRequest& request, const Record& record) {
    StillRequest still{.output = request.output.string(), .time_s = record.time_s};
    still.print.dpi = record.dpi;
    still.print.type_pt = record.type_pt;
    if (!record.journal.empty()) set_least_sizes(journal_named(record.journal), still.print);
    still.bit_depth = record.bit_depth;
    if (!record.shading.empty()) still.vectors.shading = record.shading;
    if (!record.lettering.empty()) still.vectors.text = record.lettering;
    return still;
}

}  // namespace

void redraw(const RedrawRequest& asked, const Telling& telling) {
    const Record record = read_record(asked.file);
    if (!record.sheet.empty())
        throw InputError(fmt::format(
            "{}: is a sheet of many pictures, whose record holds the scene of the first and the "
            "values of all; draw it again by still --sweep --sheet, with what explain prints",
            printable(asked.file.string())));
    const RedrawRequest request = with_its_names(asked, record);
    const bool is_picture = suffix_of(request.file) == ".png";
    const bool is_page = is_vector_name(request.file);
    if (is_picture != (suffix_of(request.output) == ".png") ||
        (is_page && suffix_of(request.file) != suffix_of(request.output)))
        throw InputError(fmt::format("{}: {} is drawn again as one of its kind; choose a name {}",
                                     printable(request.output.string()),
                                     printable(request.file.string()),
                                     is_page      ? "in " + suffix_of(request.file)
                                     : is_picture ? "in .png"
                                                  : "in .mp4, .webm or .gif"));

    const double time_s = record.time_s.value_or(0.0);
    Session session = session_of(scene_of(request, record), {&time_s, 1}, telling);
    Easel easel({.backend = request.backend,
                 .portability = record.portable ? Portability::portable : Portability::native});
    if (record.time_s) {
        StillWriter writer;
        StillJob(std::move(session), still_request_of(request, record))
            .draw(easel, writer, telling);
        writer.finish();
    } else if (is_picture) {
        redraw_frame(request, record, session, easel);
    } else {
        // Of a film that was recovered, the frames that it has of the run that was interrupted.
        const auto [first, last] = *record.frames;
        FilmRequest film{request.output.string(), record.run ? record.run : record.frames};
        if (record.run) film.n_shown = last - first + 1;
        FilmJob(session, film).make(easel, telling);
    }
    note_differences(record, read_record(request.output), telling);
}

}  // namespace poinsot
