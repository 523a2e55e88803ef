#include "image/crc32.h"

#include <libdeflate.h>

namespace poinsot {

std::uint32_t crc32_after(std::uint32_t crc, std::span<const std::uint8_t> bytes) {
    return libdeflate_crc32(crc, bytes.data(), bytes.size());
}

}  // namespace poinsot
