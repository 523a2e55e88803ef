#include "production/films/redraw.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "encoding/film_metadata.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_xxh64.h"
#include "production/films/film_job.h"
#include "production/records/record.h"
#include "production/stills/output_place.h"
#include "production/stills/prepared_still.h"
#include "production/stills/recorded_still.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Differences between this machine and the one that made the file, as messages.
std::vector<std::string> differences(const Record& then, const Record& now) {
    std::vector<std::string> notes;
    const auto note = [&](std::string_view what, const std::string& was, const std::string& is) {
        if (was == is) return;
        notes.push_back(fmt::format("note: made with {} {}, here it is {}: the bytes may differ",
                                    what, printable(was), printable(is)));
    };
    note("poinsot", then.version, now.version);
    note("the renderer", then.renderer, now.renderer);
    if (!then.processor.empty()) note("the processor", then.processor, now.processor);
    note("Mesa", then.mesa, now.mesa);
    note("the fonts", then.fonts, now.fonts);
    return notes;
}

void refuse_sheet(const std::filesystem::path& file, const Record& record) {
    if (record.sheet.empty()) return;
    throw InputError(fmt::format(
        "{}: is a sheet of several pictures; its record has the scene of the first and the values "
        "of all: draw it again with still --sweep --sheet and the values that explain prints",
        printable(file.string())));
}

// The number of a picture in its sequence. Records of older versions do not contain it.
std::int64_t frame_of_picture(const std::filesystem::path& file, const Record& record) {
    const auto frame = record.frame ? record.frame : frame_of_name(file);
    const auto [first, last] = *record.frames;
    if (!frame || *frame < first || *frame > last)
        throw InputError(
            fmt::format("{}: is one of the frames {}-{} of a sequence, but its name does not tell "
                        "which; end the name with the frame's number",
                        printable(file.string()), first, last));
    return *frame;
}

// Redraws one frame of a sequence; its record is that of the whole sequence, since it shows its
// history.
void redraw_frame(const RedrawRequest& request, const Record& record, const Session& session,
                  LazyRenderer& renderer) {
    const std::int64_t frame = frame_of_picture(request.file, record);
    const OutputPlace place(request.output.string(), session.scene, ".png");
    const FilmPlan film = film_plan(session);
    PictureMaker pictures(session, renderer, whole_film(film));
    Image image;
    pictures.draw(film.moment_of(frame), image);
    Record again = record_of(session, pictures, renderer.is_portable());
    again.frames = record.frames;
    PngOptions png;
    png.texts[metadata_name] =
        sealed_metadata(to_text(again), {.frame = frame, .pixels = pixels_xxh64(image)});
    write_png(place.path(), image, png);
}

// The request with the scene's name and the frame's number inserted into its output.
RedrawRequest with_its_names(RedrawRequest request, const Record& record) {
    const bool one_frame = record.frames && suffix_of(request.file) == ".png";
    const auto frame = record.frame ? record.frame : frame_of_name(request.file);
    request.output =
        numbered_output(request.output, one_frame ? frame.value_or(0) : 0, record.scene_name);
    std::error_code not_there;
    if (std::filesystem::equivalent(request.file, request.output, not_there))
        throw InputError(fmt::format("{}: is the file that you draw again; name another output",
                                     printable(request.output.string())));
    return request;
}

// The session of the record's scene; checks that the files it names are unchanged.
Session session_of_record(const RedrawRequest& request, const Record& record, const Task& task) {
    const Scene scene = scene_of(record, request.outside);
    if (mesh_hash_of(scene) != record.mesh_hash) {
        std::string files = scene.body.mesh.empty() ? scene.object.mesh : scene.body.mesh;
        for (const FacePictureSpec& picture : scene.object.pictures)
            files += (files.empty() ? "" : ", ") + picture.file;
        if (scene.measured.given()) files += (files.empty() ? "" : ", ") + scene.measured.file;
        throw InputError(
            fmt::format("{} has changed since the file was drawn; restore the earlier version",
                        printable(files)));
    }
    Session session = session_of(scene, needs_of(record), task);
    // The record's scene has the values that were chosen then.
    session.as_read = record.as_read;
    return session;
}

ContextChoice context_for(const RedrawRequest& request, const Record& record) {
    return {.backend = request.backend,
            .portability = record.portable ? Portability::portable : Portability::native};
}

// The record of a redrawn file, except for fields known only after drawing.
Record record_to_come(const RedrawRequest& request, const Record& record, const Task& task) {
    refuse_sheet(request.file, record);
    Session session = session_of_record(request, record, task);
    StillRequest still = request_of(record);
    still.output = request.file.string();
    Record now;
    if (record.time_s) {
        now = record_of(prepare_still(std::move(session), still));
    } else {
        if (suffix_of(request.file) == ".png") frame_of_picture(request.file, record);
        const FilmJob film(session, {.frames = record.run ? record.run : record.frames});
        const PreparedPicture staging(session, whole_film(film.film()), PrintChoices{});
        now = record_of(session, staging.stage, "");
    }
    if (is_vector_name(request.file) && !has_pixels(still.vectors)) {
        record_without_context(now);
    } else {
        LazyRenderer renderer(context_for(request, record));
        record_context(renderer.context().info(), renderer.is_portable(), now);
    }
    return now;
}

}  // namespace

RedrawCheck check_redraw(const RedrawRequest& request, const Record& record, const Task& task) {
    try {
        const Record now = record_to_come(request, record, task);
        if (now.version == record.version && now.scene_toml != record.scene_toml)
            return {"its scene changes when this program reads and writes it", {}};
        return {"", differences(record, now)};
    } catch (const Error& error) {
        // The message starts with the file's name already.
        std::string what = error.what();
        const std::string name = printable(request.file.string()) + ": ";
        return {what.starts_with(name) ? what.substr(name.size()) : what, {}};
    }
}

void redraw(const RedrawRequest& asked, const Task& task) {
    const Record record = read_record(asked.file);
    refuse_sheet(asked.file, record);
    const RedrawRequest request = with_its_names(asked, record);
    const bool is_picture = suffix_of(request.file) == ".png";
    const bool is_page = is_vector_name(request.file);
    if (is_picture != (suffix_of(request.output) == ".png") ||
        (is_page && suffix_of(request.file) != suffix_of(request.output)))
        throw InputError(
            fmt::format("{}: the kind of file differs from that of {}; choose a name {}",
                        printable(request.output.string()), printable(request.file.string()),
                        is_page      ? "in " + suffix_of(request.file)
                        : is_picture ? "in .png"
                                     : "in " + film_suffixes()));

    Session session = [&] {
        try {
            return session_of_record(request, record, task);
        } catch (const SceneError&) {
            throw;
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", printable(request.file.string()), error.what()));
        }
    }();
    LazyRenderer renderer(context_for(request, record));
    if (record.time_s) {
        StillWriter writer;
        StillRequest still = request_of(record);
        still.output = request.output.string();
        draw_still(prepare_still(std::move(session), still), renderer, writer, task);
        writer.finish();
    } else if (is_picture) {
        redraw_frame(request, record, session, renderer);
    } else {
        // Of a recovered film: the recovered frames of the interrupted run.
        const auto [first, last] = *record.frames;
        const FilmRequest film{.output = request.output.string(),
                               .frames = record.run ? record.run : record.frames,
                               .n_shown = record.run ? last - first + 1 : 0,
                               .is_slide = record.film_frames.has_value()};
        FilmJob(session, film).make(renderer, task);
    }
    for (const std::string& note : differences(record, read_record(request.output))) task.say(note);
}

}  // namespace poinsot
