// Paths between files.
#pragma once

#include <filesystem>

namespace poinsot {

// The path of a file seen from a folder, with links followed: "../scenes/a.toml". Absolute where
// there is none.
std::filesystem::path seen_from(const std::filesystem::path& folder,
                                const std::filesystem::path& file);

}  // namespace poinsot
