// Compression as in PNG files, RFC 1950.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace poinsot {

// The smallest stream that libdeflate finds; the same on every machine. Throws EnvironmentError if
// there is no memory.
std::vector<std::uint8_t> zlib_stream(std::span<const std::uint8_t> raw);

}  // namespace poinsot
