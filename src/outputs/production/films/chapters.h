// A scene's chapters as frames of its film, and the JSON file beside the film for presentation
// tools.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "encoding/frame_sink.h"
#include "production/session/session.h"

namespace poinsot {

// The chapters in the frames first … last, numbered relative to `first`.
std::vector<FilmChapter> chapters_of(const Scene& scene, const FilmPlan& film, std::int64_t first,
                                     std::int64_t last);

// "film.chapters.json" for "film.mp4", "film.webm.chapters.json" for "film.webm"; for a sequence
// the name without its frame number.
std::filesystem::path chapters_path(const std::filesystem::path& film);

// Throws InputError if this file exists and poinsot did not write it; as check_aside.
void check_chapters_place(const std::filesystem::path& film);

// Removes this file if an earlier film of the same name left it.
void remove_stale_chapters(const std::filesystem::path& film);

// Writes this file atomically. Throws EnvironmentError, and as check_chapters_place does.
void write_chapters(const OutputPlan& plan, const FilmPlan& film);

// The file's text after the film's name, which is known only when the parts of a film are joined;
// and the file of a film whose parts carry this text.
std::string chapters_text_of(const OutputPlan& plan, const FilmPlan& film);
void write_chapters(const std::filesystem::path& film, const std::string& text);

}  // namespace poinsot
