// A file read as a whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poinsot {

// Throw EnvironmentError: `cannot read PATH: REASON`.
std::string read_text(const std::filesystem::path& path);
std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path);

// The same of a file that need not be there, and is empty then.
std::string read_text_if_there(const std::filesystem::path& path);

}  // namespace poinsot
