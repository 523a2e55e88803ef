// Where the tests find what lies in the repository.
#pragma once

#include <filesystem>

namespace poinsot {

// The repository's root.
std::filesystem::path source_folder();

}  // namespace poinsot
