// The suffix of a file's name.
#pragma once

#include <filesystem>
#include <string>

namespace poinsot {

// The suffix of a path in lower case, as ".png": suffixes are case-insensitive. Only A to Z are
// converted.
std::string suffix_of(const std::filesystem::path& path);

}  // namespace poinsot
