// poinsot still SCENE -o OUT.png: one picture.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/jobs.h"
#include "cli/requests.h"
#include "cli/scenes.h"
#include "error/error.h"
#include "image/pixel_check.h"
#include "image/png.h"
#include "output/film_metadata.h"
#include "production/banded_still.h"
#include "production/output_place.h"
#include "production/picture.h"
#include "production/print_size.h"
#include "production/record.h"
#include "production/session.h"
#include "system/interrupt.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

FilmMoment moment_asked(const Session& session, const Options& options) {
    const FilmPlan film = film_plan(session);
    const auto asked_s = options.time_s ? options.time_s : session.scene.film.still_s;
    const FilmMoment moment =
        asked_s ? moment_of_time(film.clock, *asked_s) : film.moment_of(film.n_frames - 1);
    // An instant that the motion cannot be asked for is refused where it is named.
    if (options.time_s) {
        try {
            session.motion.at(moment.time_s);
        } catch (const InputError& error) {
            throw InputError(fmt::format("--time {}: {}", *options.time_s, error.what()));
        }
    } else {
        at_key_of_error(session.scene, "motion",
                        session.scene.film.still_s ? "film.still_s" : "film",
                        [&] { return session.motion.at(moment.time_s); });
    }
    return moment;
}

// The options of a still that can be made with them.
const Options& accepted(const Options& options) {
    if (!options.output.empty() && std::filesystem::path(options.output).extension() != ".png")
        throw InputError(fmt::format("{}: a still is a PNG; end its name in .png", options.output));
    if (options.print.bit_depth != 8 && options.print.bit_depth != 16)
        throw InputError(
            fmt::format("--depth {}: a component has 8 or 16 bits", options.print.bit_depth));
    return options;
}

// The histories shown begin with the film and end with the instant.
PictureSpan span_of(const Session& session, double time_s) {
    return {.first_time_s = std::min(film_plan(session).start_s, time_s), .last_time_s = time_s};
}

}  // namespace

Still::Still(Session&& session, const Options& options)
    : session_(std::move(session)),
      options_(accepted(options)),
      moment_(moment_asked(session_, options)),
      staging_(session_, span_of(session_, moment_.time_s), options.print) {}

std::int64_t Still::n_pixels() const {
    return std::int64_t{session_.scene.film.width_px} * session_.scene.film.height_px;
}

void Still::draw(Easel& easel, StillWriter& writer) {
    print_notes(session_.scene, options_.quiet);
    print_type_notes(staging_.stage, options_.quiet);
    OutputPlace place(options_.output, session_.scene, ".png");
    PictureMaker pictures(std::move(staging_), easel);
    Record record = record_of(session_, pictures, options_.portable);
    record.time_s = moment_.time_s;
    PngOptions png;
    if (const auto paper = print_size_of(options_.print, session_.scene.film.width_px,
                                         session_.scene.film.height_px)) {
        png.pixels_per_metre = paper->pixels_per_metre;
        record.dpi = options_.print.dpi.value_or(default_dpi);
        record.type_pt = options_.print.type_pt.value_or(default_type_pt);
    }
    record.bit_depth = options_.print.bit_depth;
    std::string words;
    if (!options_.quiet) {
        words = fmt::format("{}\n{}", printable(place.path().string()),
                            in_words(pictures.bound(), session_.scene.accuracy_px));
    }
    if (record.bit_depth == 16 || wants_bands(pictures)) {
        writer.finish();
        watch_for_interrupts();
        const auto texts = [&record](const std::string& pixels) {
            record.pixels = pixels;
            return std::map<std::string, std::string>{{kMetadataName, sealed_text(record)}};
        };
        write_in_bands(pictures, moment_, place.path(), png, record.bit_depth, texts);
        say(words);
    } else {
        Image image;
        pictures.draw(moment_, image);
        record.pixels = pixel_check(image);
        png.texts[kMetadataName] = sealed_text(record);
        writer.write(std::move(place), std::move(image), std::move(png), std::move(words));
    }
}

namespace {

std::unique_ptr<Still> still_of(const Options& options) {
    return std::make_unique<Still>(open_session(scene_request_of(options)), options);
}

// Each scene is read and staged while the one before it is drawn.
int draw_all(const std::vector<Options>& scenes, Easel& easel, StillWriter& writer) {
    // Where no thread can be had, it is made when asked for.
    const auto begin = [&](std::size_t k) {
        return std::async([&own = scenes[k]] { return still_of(own); });
    };
    // Opened before there is another thread: it changes the environment that libraries read.
    easel.context();
    int worst = 0;
    std::future<std::unique_ptr<Still>> next = begin(0);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        std::future<std::unique_ptr<Still>> still = std::exchange(next, {});
        still.wait();
        if (k + 1 < scenes.size()) next = begin(k + 1);
        worst = std::max(worst, code_of_one([&] {
                             still.get()->draw(easel, writer);
                             return 0;
                         }));
    }
    return worst;
}

void draw_alone(const Options& options, Easel& easel, StillWriter& writer) {
    constexpr std::int64_t small_px = 1 << 24;
    const std::unique_ptr<Still> still = still_of(options);
    if (still->n_pixels() <= small_px) easel.compile_quickly();
    still->draw(easel, writer);
}

int run(const Options& options) {
    const std::vector<Options> scenes = options_by_scene(options, OutputKind::picture);
    StillWriter writer;
    std::optional<Easel> easel(std::in_place, context_choice_of(options), options.print);
    int code = 0;
    if (scenes.size() == 1)
        draw_alone(scenes.front(), *easel, writer);
    else
        code = draw_all(scenes, *easel, writer);
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
