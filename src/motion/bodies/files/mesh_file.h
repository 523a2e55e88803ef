// Reads the bytes of a mesh file.
#pragma once

#include <filesystem>
#include <string>

namespace poinsot {

// Throws InputError for a file that is missing, empty, too large, of another type or not a regular
// file.
std::string bytes_of_mesh_file(const std::filesystem::path& file);

}  // namespace poinsot
