// Whether a long run will fit on its disk, asked as soon as that can be estimated.
#pragma once

#include <cstdint>
#include <filesystem>

namespace poinsot {

// Given what the first n_done of n_frames took, throws EnvironmentError if not even half of what
// the rest will need by that measure is free where the path lies.
void check_room(const std::filesystem::path& path, std::uint64_t n_bytes_done, std::int64_t n_done,
                std::int64_t n_frames);

}  // namespace poinsot
