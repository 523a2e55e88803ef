// What the formats have in common.
#pragma once

#include "output/frame_sink.h"

namespace poinsot {

// Frames between two starts of an encoder. x264 sets a key frame every 250 anyway, libvpx every
// 128; with 120 an MP4 is a tenth larger, and an interrupted film goes on from 4 s before, at 30
// frames a second. A GIF's pictures depend on those before them by the palette alone, which is the
// whole's.
inline constexpr std::int64_t frames_a_chunk = 120;

// The text that a file made as planned carries.
std::string text_of(const OutputPlan& plan, const Contents& contents);

// How many frames of those that came a film made as planned has.
std::int64_t n_shown_of(const OutputPlan& plan, std::int64_t n_frames);

// The number of the first frame that comes.
std::int64_t first_number(const OutputPlan& plan);

}  // namespace poinsot
