// poinsot still SCENE -o OUT.png: one picture.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/banded_still.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/jobs.h"
#include "cli/output_place.h"
#include "cli/picture.h"
#include "cli/print_size.h"
#include "cli/record.h"
#include "cli/scenes.h"
#include "cli/session.h"
#include "error/error.h"
#include "error/nearest.h"
#include "image/png.h"
#include "output/film_metadata.h"

namespace poinsot {

int make_still(const Session& session, const Options& options, Easel& easel, StillWriter& writer) {
    print_notes(session.scene, options.quiet);
    const FilmPlan film = film_plan(session);
    const auto asked_s = options.time_s ? options.time_s : session.scene.film.still_s;
    const FilmMoment moment =
        asked_s ? moment_of_time(film.clock, *asked_s) : film.moment_of(film.n_frames - 1);
    const double time_s = moment.time_s;
    if (!std::isfinite(time_s)) {
        throw InputError("--time is not a finite number; give an instant in seconds");
    }

    const OutputPlace place(options, session.scene, ".png");
    const std::filesystem::path& path = place.path();
    if (path.extension() != ".png") {
        throw InputError(fmt::format("{}: a still is a PNG; end its name in .png", path.string()));
    }

    if (options.print.bit_depth != 8 && options.print.bit_depth != 16) {
        throw InputError(
            fmt::format("--depth {}: a component has 8 or 16 bits", options.print.bit_depth));
    }

    // The histories shown begin with the film and end with the instant.
    PictureMaker pictures(session, easel,
                          {.first_time_s = std::min(film.start_s, time_s), .last_time_s = time_s});
    Record record = record_of(session, pictures, options.portable);
    record.time_s = time_s;
    PngOptions png;
    if (const auto paper = print_size_of(options.print, session.scene.film.width_px,
                                         session.scene.film.height_px)) {
        png.pixels_per_metre = paper->pixels_per_metre;
        record.dpi = options.print.dpi.value_or(default_dpi);
        record.type_pt = options.print.type_pt.value_or(default_type_pt);
    }
    record.bit_depth = options.print.bit_depth;
    png.texts[kMetadataName] = to_text(record);
    std::string words;
    if (!options.quiet) {
        words = fmt::format("{}\n{}\n", printable(path.string()),
                            in_words(pictures.bound(), session.scene.accuracy_px));
    }
    if (record.bit_depth == 16 || wants_bands(pictures)) {
        writer.finish();
        watch_for_interrupts();
        write_in_bands(pictures, moment, path, png, record.bit_depth);
        fmt::print(stderr, "{}", words);
    } else {
        Image image;
        pictures.draw(moment, image);
        writer.write(path, std::move(image), std::move(png), std::move(words));
    }
    return 0;
}

namespace {

int run(const Options& options) {
    const bool alone = options.arguments.size() == 1;
    StillWriter writer;
    std::optional<Easel> easel(options);
    const int code = for_each_scene(options, [&](const Options& own) {
        const Session session = open_session(own);
        constexpr std::int64_t small_px = 1 << 24;
        if (alone &&
            std::int64_t{session.scene.film.width_px} * session.scene.film.height_px <= small_px)
            easel->compile_quickly();
        return make_still(session, own, *easel, writer);
    });
    easel.reset();  // which takes as long as compressing half a picture
    writer.finish();
    return code;
}

constexpr auto options_taken = std::to_array<std::string_view>(
    {"output", "set", "size", "width-mm", "height-mm", "dpi", "type-pt", "depth", "quality",
     "theme", "time", "quiet", "backend", "portable", "allow-outside"});

}  // namespace

const Command still_command{"still",       "SCENE", 1, any_number, "make one picture of each scene",
                            options_taken, run};

}  // namespace poinsot
