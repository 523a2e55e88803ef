// Which subtitles a film has, and their text. No file: a page has them, too.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/stage/live_values.h"
#include "production/films/subtitles.h"
#include "system/seal.h"
#include "text/markup.h"
#include "text/printable.h"
#include "typeset/plain_text.h"

namespace poinsot {

namespace {

// hh:mm:ss.ttt
std::string stamp(std::int64_t ms) {
    return fmt::format("{:02}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60,
                       ms % 1000);
}

// Removes empty lines, which would end a cue.
std::string without_empty_lines(std::string_view text) {
    std::string lines;
    for (const char c : text)
        if (c != '\n' || (!lines.empty() && lines.back() != '\n')) lines += c;
    return lines;
}

}  // namespace

std::vector<FilmSubtitle> subtitles_of(const Session& session, const FilmPlan& film,
                                       std::int64_t first, std::int64_t last) {
    const Scene& scene = session.scene;
    const double first_s = film.moment_of(first).film_s;
    const double end_s = film.moment_of(last + 1).film_s;
    const auto milliseconds = [first_s](double film_s) {
        return static_cast<std::int64_t>(std::llround(1000.0 * std::max(0.0, film_s - first_s)));
    };
    std::vector<FilmSubtitle> subtitles;
    for (std::size_t i = 0; i < scene.captions.size(); ++i) {
        const auto [comes_s, goes_s] = caption_span(scene, i);
        const double begin_s = std::max(comes_s, first_s);
        const double gone_s = std::min(goes_s, end_s);
        if (!(begin_s < gone_s)) continue;
        FrameInput instant;
        instant.time_s = film.clock.time_at(comes_s);
        instant.state = session.motion.at(instant.time_s);
        const std::string said = live_text(scene, scene.captions[i].text, instant);
        subtitles.push_back({without_empty_lines(plain_text(said)), milliseconds(begin_s),
                             milliseconds(gone_s), scene.captions[i].place == "top"});
    }
    return subtitles;
}

std::string subtitles_head(const std::string& film) {
    return fmt::format("{}{}\n", any_subtitles_head, escaped_cue(printable(film, any_length)));
}

std::string subtitles_text(const std::string& film, std::span<const FilmSubtitle> subtitles) {
    std::string text = fmt::format("{}sha256 {}\n", subtitles_head(film), blank_seal);
    for (const FilmSubtitle& subtitle : subtitles)
        text += fmt::format("\n{} --> {}{}\n{}\n", stamp(subtitle.begin_ms), stamp(subtitle.end_ms),
                            subtitle.at_top ? " line:0" : "", escaped_cue(subtitle.text));
    return sealed(std::move(text));
}

}  // namespace poinsot
