// Unique ids of geometry and masks, with which a renderer caches its uploads.
#pragma once

#include <cstdint>

namespace poinsot {

// Returns an id that no other geometry or mask of this process has. Its value does not influence
// any pixel.
std::uint64_t next_identity();

}  // namespace poinsot
