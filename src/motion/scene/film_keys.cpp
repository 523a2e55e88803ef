// Keys of the film: its frames, their size and rate.
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/frame_rate.h"
#include "scene/loop_text.h"
#include "scene/scene_key_rows.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr int most_pixels = 65536;  // of the largest still, which is drawn in bands
constexpr Bounds sides = within(1, most_pixels);

void read_loop(const GivenValue& given, SceneDraft& draft) {
    draft.scene.film.loop = given.text();
    if (draft.scene.film.loop == "period" || loop_ratio_of(draft.scene.film.loop)) return;
    given.refuse(fmt::format("\"{}\"", printable(draft.scene.film.loop)),
                 "give turns over periods, each 1 to 1000, as in \"5/3\", or \"period\"");
}

// fps as a number, or as a ratio in a string.
void read_fps(const GivenValue& given, SceneDraft& draft) {
    const bool as_text = given.value().type == TomlValue::Type::text;
    const auto rate = as_text ? rate_of_text(given.text()) : rate_of_decimal(given.number());
    if (!rate) {
        given.refuse(as_text ? fmt::format("\"{}\"", printable(given.text()))
                             : fmt::format("{}", given.number()),
                     "give video frames a second from 0.001 to 1000, with at most three decimals "
                     "or as a ratio of whole numbers up to a million, as 30, 29.97 or "
                     "\"30000/1001\"");
    }
    draft.scene.film.fps_numerator = rate->first;
    draft.scene.film.fps_denominator = rate->second;
}

// size as [width, height], or as "1920x1080".
void read_size(const GivenValue& given, SceneDraft& draft) {
    const TomlValue& value = given.value();
    std::array<std::int64_t, 2> size{};
    std::string written;
    if (value.type == TomlValue::Type::text) {
        written = printable(given.text());
        const std::string text = given.text();
        std::string_view rest = text;
        const bool has_width = take_count(rest, size[0], 'x');
        const auto height = number_of<std::int64_t>(rest);
        size[1] = height.value_or(0);
        if (!has_width || !height || rest.starts_with('-')) {
            given.refuse(fmt::format("\"{}\"", written),
                         "give width and height in pixels, as in \"1920x1080\"");
        }
    } else {
        if (value.type != TomlValue::Type::array || value.items.size() != 2) given.refuse_type();
        for (std::size_t i = 0; i < 2; ++i) {
            if (value.items[i].type != TomlValue::Type::integer) given.refuse_type();
            size[i] = value.items[i].integer;
        }
        written = fmt::format("{}x{}", size[0], size[1]);
    }
    for (const std::int64_t n_pixels : size) {
        if (!sides.hold(static_cast<double>(n_pixels))) {
            given.refuse(written, fmt::format("give a width and a height{} pixels", sides.words()));
        }
    }
    draft.scene.film.width_px = static_cast<int>(size[0]);
    draft.scene.film.height_px = static_cast<int>(size[1]);
}

std::string rate_text(const Scene& scene, std::size_t) {
    const FilmSpec& film = scene.film;
    const std::string rate = text_of_rate({film.fps_numerator, film.fps_denominator});
    return film.fps_denominator == 1 ? rate : toml_text(std::string_view(rate));
}

std::string size_text(const Scene& scene, std::size_t) {
    return fmt::format("[{}, {}]", scene.film.width_px, scene.film.height_px);
}

template <typename Value>
constexpr auto film(Value FilmSpec::*member) {
    return in(&Scene::film, member);
}

}  // namespace

std::span<const SceneKey> film_keys() {
    using namespace key_rows;
    constexpr ValueType rate{
        .kind = ValueType::Kind::number, .bounds = within(0.001, 1000.0), .unit = "1/s"};
    constexpr ValueType width_and_height{.kind = ValueType::Kind::integer,
                                         .bounds = sides,
                                         .unit = "pixels",
                                         .size = ValueType::Size{2, 2}};
    static const SceneKey rows[] = {
        // The instants that become video frames.
        number("film.start_s", film(&FilmSpec::start_s), no_bounds, "s", "0.0",
               "time of the motion at which the film begins"),
        number("film.duration_s", film(&FilmSpec::duration_s), positive, "s", "12.0",
               "time span of the motion that the film shows")
            .default_is("ten seconds of film"),
        number("film.length_s", film(&FilmSpec::length_s), positive, "s", "20.0",
               "length of the film, instead of duration_s; in seconds of film, like the times of "
               "keyframes and fades"),
        number("film.still_s", film(&FilmSpec::still_s), no_bounds, "s", "9.5",
               "time of the motion that `still` draws without --time")
            .default_is("the time at which the arrows are farthest apart in the picture"),
        text("film.loop", film(&FilmSpec::loop), R"("5/3")",
             "\"p/q\": changes the start so that the herpolhode closes after q polhode periods and "
             "p turns about L, and shows one such loop; \"period\": shows one polhode period, for "
             "a co-precessing camera (camera.motion)")
            .default_is("no loop")
            .read_by(read_loop),
        one_of("film.loop_changes", film(&FilmSpec::loop_changes), loop_values(),
               R"("omega_body_2")", "component of start.omega_rad_s that the loop changes")
            .default_is("the component that needs the smallest change"),
        row("film.fps", rate, R"("30000/1001")", "video frames per second; 29.97 means 30000/1001")
            .or_text("a ratio as a string", "[0-9]")
            .read_by(read_fps)
            .written_by(rate_text),
        row("film.size", width_and_height, "[1920, 1080]",
            "width and height of the picture, at most 16384 for a film; also as \"1920x1080\"")
            .or_text("a string", "^[0-9]+x[0-9]+$")
            .read_by(read_size)
            .written_by(size_text),
        number("film.speed", film(&FilmSpec::speed), positive, "", "1.0",
               "seconds of motion per second of film"),
        text("film.quality", film(&FilmSpec::quality), R"("lecture")",
             "quality of curves, pixels and encoding")
            .from_list("qualities"),
    };
    return rows;
}

}  // namespace poinsot
