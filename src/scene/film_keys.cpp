// Keys of the film: its frames, their size and rate.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <string>

#include "scene/frame_rate.h"
#include "scene/given_value.h"
#include "scene/loop_text.h"
#include "scene/scene_draft.h"
#include "scene/scene_error.h"
#include "scene/scene_key_rows.h"
#include "scene/toml_text.h"

namespace poinsot {

namespace {

using std::size_t;

constexpr int most_pixels = 65536;  // of the largest still, which is rendered in bands

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
                     "give video frames a second from 0.001 to 1000, as 30, 29.97 or "
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
        int used = 0;
        const std::string text = given.text();
        const bool digits = text.find_first_not_of("0123456789x") == std::string::npos;
        const int n = std::sscanf(text.c_str(), "%9ldx%9ld%n", &size[0], &size[1], &used);
        if (!digits || n != 2 || used != static_cast<int>(text.size())) {
            given.refuse(fmt::format("\"{}\"", written),
                         "give width and height in pixels, as in \"1920x1080\"");
        }
    } else {
        if (value.type != TomlValue::Type::array || value.items.size() != 2) given.refuse_type();
        for (size_t i = 0; i < 2; ++i) {
            if (value.items[i].type != TomlValue::Type::integer) given.refuse_type();
            size[i] = value.items[i].integer;
        }
        written = fmt::format("{}x{}", size[0], size[1]);
    }
    for (const std::int64_t n_pixels : size) {
        if (n_pixels < 1 || n_pixels > most_pixels) {
            given.refuse(written,
                         fmt::format("give a width and a height from 1 to {} pixels", most_pixels));
        }
    }
    draft.scene.film.width_px = static_cast<int>(size[0]);
    draft.scene.film.height_px = static_cast<int>(size[1]);
}

const SceneKey film_rows[] = {
    // The instants that become video frames.
    {"film.start_s", "a number", "s", "0.0",
     "instant of the motion that the film begins with; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.start_s = g.number(); },
     [](const Scene& s, size_t) { return toml_text(s.film.start_s); }},
    {"film.duration_s", "a positive number", "s", "12.0",
     "stretch of the motion that is shown; default: ten seconds of film",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.duration_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.film.duration_s); }},
    {"film.length_s", "a positive number", "s", "20.0",
     "length of the film instead, in seconds of film: keyframes and fades count those",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.length_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.film.length_s); }},
    {"film.still_s", "a number", "s", "9.5",
     "instant of the motion that `still` draws if --time does not say; default: the film's last",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.still_s = g.number(); },
     [](const Scene& s, size_t) { return optional_text(s.film.still_s); }},
    {"film.loop", "a string", "", R"("5/3")",
     "\"p/q\": start so that the herpolhode closes after q polhode periods with p turns about L, "
     "and show that; \"period\": one polhode period, for a co-precessing camera; default: no loop",
     read_loop,
     [](const Scene& s, size_t) {
         return s.film.loop.empty() ? "" : toml_text(std::string_view(s.film.loop));
     }},
    {"film.loop_changes", "a string", "", R"("omega_2")",
     "component of start.omega_rad_s that the loop may change; default: the one that has to change "
     "least",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.film.loop_changes = g.one_of(loop_values());
     },
     [](const Scene& s, size_t) {
         return s.film.loop_changes.empty() ? "" : toml_text(std::string_view(s.film.loop_changes));
     },
     loop_values()},
    {"film.fps", "a number or a ratio in a string", "1/s", R"("30000/1001")",
     "video frames a second; 29.97 means 30000/1001; default 30", read_fps,
     [](const Scene& s, size_t) {
         const std::string rate = text_of_rate({s.film.fps_numerator, s.film.fps_denominator});
         return s.film.fps_denominator == 1 ? rate : toml_text(std::string_view(rate));
     }},
    {"film.size", "two integers or a string", "pixels", "[1920, 1080]",
     "width and height of the picture, from 1 to 65536 (a film: 16384), also \"1920x1080\"; "
     "default 1920x1080",
     read_size,
     [](const Scene& s, size_t) {
         return fmt::format("[{}, {}]", s.film.width_px, s.film.height_px);
     }},
    {"film.speed", "a positive number", "", "1.0", "seconds of motion a second of film; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.speed = g.positive(); },
     [](const Scene& s, size_t) { return toml_text(s.film.speed); }},
    {"film.quality", "a string", "", R"("lecture")",
     "how finely drawn and encoded, see `poinsot list qualities`; default lecture",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.quality = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.film.quality)); }},
};

}  // namespace

std::span<const SceneKey> film_keys() { return film_rows; }

}  // namespace poinsot
