// File names of numbered frames: "turn_####.png" → "turn_0007.png".
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace poinsot {

// Whether the file name (not its folders) holds a run of '#'.
bool has_frame_number(const std::filesystem::path& pattern);

// Replaces the first run of '#' in the file name by the number with at least that many digits.
// Precondition: has_frame_number(pattern), number ≥ 0.
std::filesystem::path frame_name(const std::filesystem::path& pattern, std::int64_t number);

// Whether a file name (without its folders) is that of a frame of the pattern. Precondition:
// has_frame_number(pattern).
bool is_frame_of(const std::filesystem::path& file, const std::filesystem::path& pattern);

// Returns the numbers of the existing pictures of a pattern, in ascending order.
std::vector<std::int64_t> frames_there(const std::filesystem::path& pattern);

}  // namespace poinsot
