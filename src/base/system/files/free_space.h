// Checks early whether the output of a long run will fit on the disk.
#pragma once

#include <cstdint>
#include <filesystem>

namespace poinsot {

// Estimates the size of the remaining frames from the first n_done of n_frames. Throws
// EnvironmentError if less than half of the estimate is free on the disk of this path.
void check_free_space(const std::filesystem::path& path, std::uint64_t n_bytes_done,
                      std::int64_t n_done, std::int64_t n_frames);

}  // namespace poinsot
