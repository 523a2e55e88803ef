// Where the tests find what lies in the repository.
#pragma once

#include <filesystem>
#include <vector>

namespace poinsot {

// The repository's root.
std::filesystem::path source_folder();

// The scenes of the repository, by name.
std::vector<std::filesystem::path> supplied_scenes();

}  // namespace poinsot
