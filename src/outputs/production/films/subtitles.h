// A film's captions as WebVTT subtitles beside it, for reading, translation and screen readers.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "encoding/frame_sink.h"
#include "production/session/session.h"

namespace poinsot {

// "film.vtt" for "film.mp4", "film.webm.vtt" for "film.webm".
std::filesystem::path subtitles_path(const std::filesystem::path& film);

// The captions shown in frames first … last of the film, with times relative to the first of them;
// formulas as plain text, live numbers with their values when the caption appears.
std::vector<FilmSubtitle> subtitles_of(const Session& session, const FilmPlan& film,
                                       std::int64_t first, std::int64_t last);

// The beginning of the subtitles of any film.
inline constexpr const char* any_subtitles_head = "WEBVTT\n\nNOTE poinsot: ";

// The first lines, which identify the subtitles as those of a film of this file name; and the whole
// text. Source: W3C, WebVTT.
std::string subtitles_head(const std::string& film);
std::string subtitles_text(const std::string& film, std::span<const FilmSubtitle> subtitles);

// Throws InputError if the subtitles file exists and poinsot did not write it; as check_aside.
void check_subtitles_place(const std::filesystem::path& film);

// Writes the film's subtitles file atomically; without subtitles, removes the file that an earlier
// film of the same name left. Throws EnvironmentError, and as check_subtitles_place does.
void write_subtitles(const std::filesystem::path& film, std::span<const FilmSubtitle> subtitles);

}  // namespace poinsot
