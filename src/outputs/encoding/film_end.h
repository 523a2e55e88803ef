// Finds the end of a film in its file from the container's structure, to detect bytes appended
// after it, which players and demuxers ignore. Included by the code that verifies films.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace poinsot {

// Returns the offset in bytes of the first byte after the film: the file's size where nothing
// follows, less where something does, more where the file is truncated. Empty for a container that
// does not store its end. Throws InputError for a GIF that is invalid; EnvironmentError if the file
// cannot be read.
std::optional<std::uintmax_t> end_of_film(const std::filesystem::path& film);

}  // namespace poinsot
