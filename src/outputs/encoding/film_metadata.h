// Reads back the metadata that an output carries.
#pragma once

#include <filesystem>
#include <string>

namespace poinsot {

// The name under which files carry OutputPlan::metadata.
inline constexpr const char* metadata_name = "poinsot";

// Returns the OutputPlan::metadata with which the film was written; empty if the film carries none.
// Throws InputError if the file is missing or is not a film.
std::string film_metadata(const std::filesystem::path& film);

}  // namespace poinsot
