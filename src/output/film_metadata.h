// The text that an output carries about itself, read back.
#pragma once

#include <filesystem>
#include <string>

namespace poinsot {

// The name under which files carry OutputPlan::metadata.
inline constexpr const char* metadata_name = "poinsot";

// What OutputPlan::metadata was when the film was written; empty if it carries none. Throws
// InputError if the file is missing or is no film.
std::string film_metadata(const std::filesystem::path& film);

}  // namespace poinsot
