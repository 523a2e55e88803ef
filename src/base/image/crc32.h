// CRC-32 (ISO 3309), the checksum of PNG chunks and of ZIP entries.
#pragma once

#include <cstdint>
#include <span>

namespace poinsot {

// The CRC of bytes that follow others with this CRC; 0 for none.
std::uint32_t crc32_after(std::uint32_t crc, std::span<const std::uint8_t> bytes);

}  // namespace poinsot
