// A film's captions as subtitles: WebVTT beside it, to be read, translated and heard.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "output/frame_sink.h"
#include "production/session.h"

namespace poinsot {

// "film.vtt" for "film.mp4", "film.webm.vtt" for "film.webm".
std::filesystem::path subtitles_path(const std::filesystem::path& film);

// The captions that stand in frames first … last of the film, with times from the first of those;
// formulas as plain text, live numbers as they are when the caption comes.
std::vector<FilmSubtitle> subtitles_of(const Session& session, const FilmPlan& film,
                                       std::int64_t first, std::int64_t last);

// Writes them as the film's file, whole or not at all; where there are none, removes the one that
// an earlier film of the same name has left. Throws EnvironmentError. Source: W3C, WebVTT.
void write_subtitles(const std::filesystem::path& film, std::span<const FilmSubtitle> subtitles);

}  // namespace poinsot
