#include "production/sidecars/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/stage/live_values.h"
#include "production/sidecars/sidecar_place.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/markup.h"
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

// The beginning of the file of any film.
constexpr const char* any_subtitles_head = "WEBVTT\n\nNOTE poinsot: ";

// The first lines, which identify the file as the film's.
std::string subtitles_head(const std::filesystem::path& film) {
    return fmt::format("{}{}\n", any_subtitles_head, escaped_cue(film.filename().string()));
}

void remove_stale(const std::filesystem::path& film) {
    const std::filesystem::path path = subtitles_path(film);
    std::error_code ignored;
    if (begins_with(path, subtitles_head(film))) std::filesystem::remove(path, ignored);
}

}  // namespace

std::filesystem::path subtitles_path(const std::filesystem::path& film) {
    std::string stem = film.stem().string();
    if (suffix_of(film) != ".mp4") stem += film.extension().string();
    return film.parent_path() / (stem + ".vtt");
}

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

void check_subtitles_place(const std::filesystem::path& film) {
    check_sidecar(subtitles_path(film), any_subtitles_head, "captions");
}

void write_subtitles(const std::filesystem::path& film, std::span<const FilmSubtitle> subtitles) {
    if (subtitles.empty()) return remove_stale(film);
    check_subtitles_place(film);
    std::string text = subtitles_head(film);
    for (const FilmSubtitle& subtitle : subtitles)
        text += fmt::format("\n{} --> {}{}\n{}\n", stamp(subtitle.begin_ms), stamp(subtitle.end_ms),
                            subtitle.at_top ? " line:0" : "", escaped_cue(subtitle.text));
    write_whole(subtitles_path(film), text);
}

}  // namespace poinsot
