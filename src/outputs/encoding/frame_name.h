// File names of numbered frames: "turn_####.png" → "turn_0007.png".
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image/frame_rate.h"

namespace poinsot {

// Whether the file name (not its folders) holds a run of '#'.
bool has_frame_number(const std::filesystem::path& pattern);

// Replaces the first run of '#' in the file name by the number with at least that many digits.
// Precondition: has_frame_number(pattern), number ≥ 0.
std::filesystem::path frame_name(const std::filesystem::path& pattern, std::int64_t number);

// Whether a file name (without its folders) is that of a frame of the pattern. Precondition:
// has_frame_number(pattern).
bool is_frame_of(const std::filesystem::path& file, const std::filesystem::path& pattern);

// "turn.mp4 (20.97 s of film)": a name with the duration of the film that it has.
std::string with_film_length(const std::string& name, std::int64_t n_frames, const FrameRate& rate);

// Returns the numbers of the existing pictures of a pattern, in ascending order.
std::vector<std::int64_t> frames_there(const std::filesystem::path& pattern);

}  // namespace poinsot
