// Numbers that name geometry and masks, so that a renderer may keep what it has uploaded.
#pragma once

#include <cstdint>

namespace poinsot {

// A number that no other geometry or mask of this process has. Which one it is never reaches a
// pixel.
std::uint64_t next_identity();

}  // namespace poinsot
