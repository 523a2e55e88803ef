#include "production/beside/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "drawing/stage_data.h"
#include "drawing/type/live_text.h"
#include "system/atomic_file.h"
#include "system/file_kind.h"
#include "typeset/plain_text.h"

namespace poinsot {

namespace {

// hh:mm:ss.ttt
std::string stamp(double film_s) {
    const auto ms = static_cast<std::int64_t>(std::llround(1000.0 * std::max(0.0, film_s)));
    return fmt::format("{:02}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60,
                       ms % 1000);
}

// What may stand in a cue: no markup of its own, and no empty line, which would end it.
std::string cue_text(std::string_view plain) {
    std::string text;
    for (const char c : plain) {
        if (c == '&')
            text += "&amp;";
        else if (c == '<')
            text += "&lt;";
        else if (c == '>')
            text += "&gt;";
        else if (c == '\n' && (text.empty() || text.back() == '\n'))
            continue;
        else
            text += c;
    }
    return text;
}

// The first lines, by which the file is known for that of a film.
std::string head_of(const std::filesystem::path& film) {
    return fmt::format("WEBVTT\n\nNOTE poinsot: {}\n", cue_text(film.filename().string()));
}

void remove_stale(const std::filesystem::path& film) {
    const std::filesystem::path path = subtitles_path(film);
    if (kind_of_file(path) != FileKind::regular) return;
    std::ifstream file(path, std::ios::binary);
    std::string beginning(head_of(film).size(), '\0');
    file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    std::error_code ignored;
    if (file && beginning == head_of(film)) std::filesystem::remove(path, ignored);
}

}  // namespace

std::filesystem::path subtitles_path(const std::filesystem::path& film) {
    std::string stem = film.stem().string();
    if (suffix_of(film) != ".mp4") stem += film.extension().string();
    return film.parent_path() / (stem + ".vtt");
}

std::string subtitles_text(const Session& session, const FilmPlan& film, std::int64_t first,
                           std::int64_t last) {
    const Scene& scene = session.scene;
    const double first_s = film.moment_of(first).film_s;
    const double end_s = film.moment_of(last + 1).film_s;
    std::string text;
    for (std::size_t i = 0; i < scene.captions.size(); ++i) {
        const auto [comes_s, goes_s] = caption_span(scene, i);
        const double begin = std::max(comes_s, first_s);
        const double end = std::min(goes_s, end_s);
        if (!(begin < end)) continue;
        Instant instant;
        instant.time_s = film.clock.time_at(comes_s);
        instant.state = session.motion.at(instant.time_s);
        const std::string said =
            expand_live_text(scene.captions[i].text, StageData::live_values(scene, instant));
        text += fmt::format("\n{} --> {}{}\n{}\n", stamp(begin - first_s), stamp(end - first_s),
                            scene.captions[i].place == "top" ? " line:0" : "",
                            cue_text(plain_text(said)));
    }
    return text;
}

void write_subtitles(const std::filesystem::path& film, const std::string& text) {
    if (text.empty()) return remove_stale(film);
    write_whole(subtitles_path(film), head_of(film) + text);
}

}  // namespace poinsot
