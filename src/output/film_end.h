// Where the film in a file ends by its container's own account, so that bytes appended behind it,
// which players and demuxers pass over, can be told. Included by what verifies films.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace poinsot {

// The offset in bytes of the first one that is no part of the film: the file's size where nothing
// follows, less where something does, more where the file is cut short. Nothing for a container
// that does not say where it ends. Throws InputError for a GIF that is none; EnvironmentError if
// the file cannot be read.
std::optional<std::uintmax_t> end_of_film(const std::filesystem::path& film);

}  // namespace poinsot
