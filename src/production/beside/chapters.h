// A scene's chapters as frames of its film, and the JSON beside the film that slide tools read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/frame_sink.h"
#include "production/session.h"

namespace poinsot {

// The chapters that lie in the frames first … last, counted from the first of those.
std::vector<FilmChapter> chapters_of(const Scene& scene, const FilmPlan& film, std::int64_t first,
                                     std::int64_t last);

// "film.chapters.json" for "film.mp4", "film.webm.chapters.json" for "film.webm"; for a sequence
// the name without its number.
std::filesystem::path chapters_path(const std::filesystem::path& film);

// Removes that file if an earlier film of the same name has left it.
void remove_stale_chapters(const std::filesystem::path& film);

// Writes that file, whole or not at all. Throws EnvironmentError.
void write_chapters(const OutputPlan& plan, const FilmPlan& film);

// What it says after the film's name, which is known only where the parts of a film are joined;
// and the file of a film whose parts have carried it.
std::string chapters_text_of(const OutputPlan& plan, const FilmPlan& film);
void write_chapters(const std::filesystem::path& film, const std::string& text);

}  // namespace poinsot
