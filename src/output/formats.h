// Definitions that several formats share.
#pragma once

#include "output/frame_sink.h"

namespace poinsot {

// Frames in a chunk, which is encoded independently. x264 sets a key frame every 250 frames anyway,
// libvpx every 128; with 120 an MP4 is a tenth larger, and an interrupted film loses at most 4 s at
// 30 frames a second. The pictures of a GIF depend on earlier ones only through the palette, which
// is computed for the whole film.
inline constexpr std::int64_t frames_a_chunk = 120;

// Returns the metadata text of a file made from this plan.
std::string text_of(const OutputPlan& plan, const Contents& contents);

// Returns the number of frames in a film made from this plan, of those that were written to it.
std::int64_t n_shown_of(const OutputPlan& plan, std::int64_t n_frames);

// Returns the number of the first frame to be written.
std::int64_t first_number(const OutputPlan& plan);

}  // namespace poinsot
