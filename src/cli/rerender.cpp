// poinsot rerender FILE -o OUT: the picture or film that a file describes, drawn again.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>

#include "cli/command.h"
#include "cli/jobs.h"
#include "cli/requests.h"
#include "error/error.h"
#include "image/pixel_check.h"
#include "image/png.h"
#include "output/film_metadata.h"
#include "production/output_place.h"
#include "production/picture.h"
#include "production/record.h"
#include "scene/load_scene.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

// What keeps this machine from drawing as the one that made the file, in words for the user.
void note_differences(const Record& then, const Record& now) {
    const auto note = [](std::string_view what, const std::string& was, const std::string& is) {
        if (was == is) return;
        say(fmt::format("note: made with {} {}, this is {}: the bytes may differ", what,
                        printable(was), printable(is)));
    };
    note("poinsot", then.version, now.version);
    note("the renderer", then.renderer, now.renderer);
    note("Mesa", then.mesa, now.mesa);
    note("the fonts", then.fonts, now.fonts);
}

// One frame of a sequence carries the record of the whole, whose histories it shows.
void redraw_frame(const std::filesystem::path& file, const Record& record, const Session& session,
                  const Options& options, Easel& easel) {
    // A picture of an older poinsot does not say which of the frames it is.
    const auto frame = record.frame ? record.frame : frame_of_name(file);
    const auto [first, last] = *record.frames;
    if (!frame || *frame < first || *frame > last)
        throw InputError(fmt::format(
            "{}: is one of the frames {}-{} of a sequence, and its name does not say which; let "
            "the name end in the frame's number",
            printable(file.string()), first, last));
    const FilmPlan film = film_plan(session);
    PictureMaker pictures(session, easel,
                          {.first_time_s = film.time_of(0), .last_time_s = film.time_of(last)});
    Image image;
    pictures.draw(film.moment_of(*frame), image);
    Record again = record_of(session, pictures, options.portable);
    again.frames = record.frames;
    PngOptions png;
    png.texts[kMetadataName] =
        told(to_text(again), {.frame = *frame, .pixels = pixel_check(image)});
    write_png(options.output, image, png);
}

int run(const Options& given) {
    const std::filesystem::path file = given.arguments.at(0);
    const Record record = read_record(file);
    Options options = given;
    if (options.output.empty())
        throw InputError("poinsot rerender: say with -o where the new file is to go");
    const bool one_frame = record.frames && file.extension() == ".png";
    const auto frame = record.frame ? record.frame : frame_of_name(file);
    const std::filesystem::path output =
        numbered_output(options.output, one_frame ? frame.value_or(0) : 0, record.scene_name);
    options.output = output.string();
    std::error_code not_there;
    if (std::filesystem::equivalent(file, output, not_there))
        throw InputError(fmt::format("{}: is the file that is to be drawn again; name another",
                                     printable(output.string())));
    const bool is_picture = file.extension() == ".png";
    if (is_picture != (output.extension() == ".png"))
        throw InputError(fmt::format("{}: {} is drawn again as one of its kind; choose a name {}",
                                     printable(output.string()), printable(file.string()),
                                     is_picture ? "in .png" : "in .mp4, .webm or .gif"));

    // The record's scene is read as a file of its name in this folder would be.
    Scene scene =
        parse_scene(record.scene_toml, record.scene_name + ".toml", {},
                    options.allow_outside ? OutsideFiles::allowed : OutsideFiles::refused);
    scene.notes.clear();
    if (mesh_hash_of(scene) != record.mesh_hash)
        throw InputError(fmt::format(
            "{}: {} is not the mesh it was drawn with; put that one back", printable(file.string()),
            printable(scene.body.mesh.empty() ? scene.object.mesh : scene.body.mesh)));
    options.portable = record.portable;
    options.time_s = record.time_s.value_or(0.0);
    Session session = session_of(std::move(scene), {&*options.time_s, 1});
    options.frames = record.run ? record.run : record.frames;
    options.print.dpi = record.dpi;
    options.print.type_pt = record.type_pt;
    options.print.bit_depth = record.bit_depth;
    Easel easel(context_choice_of(options), options.print);
    int code = 0;
    if (record.time_s) {
        StillWriter writer;
        Still(std::move(session), options).draw(easel, writer);
        writer.finish();
    } else if (is_picture) {
        redraw_frame(file, record, session, options, easel);
    } else {
        // Of a film that was recovered, the frames that it has of the run that was interrupted.
        const auto [first, last] = *record.frames;
        code = make_film(session, options, easel, record.run ? last - first + 1 : 0);
    }
    if (!options.quiet) note_differences(record, read_record(output));
    return code;
}

constexpr std::array<std::string_view, 4> options_taken{"output", "quiet", "backend",
                                                        "allow-outside"};

}  // namespace

const Command rerender_command{
    "rerender",    "FILE", 1, 1, "draw again what a picture or film says it shows",
    options_taken, run};

}  // namespace poinsot
