// What the rows of the table of formats open. Known only to the table.
#pragma once

#include <memory>

#include "output/frame_sink.h"

namespace poinsot {

// Frames between two starts of an encoder. x264 sets a key frame every 250 anyway, libvpx every
// 128; with 120 an MP4 is a tenth larger, and an interrupted film goes on from 4 s before, at 30
// frames a second. A GIF's pictures depend on those before them by the palette alone, which is the
// whole's.
inline constexpr std::int64_t kChunkFrames = 120;

// The text that a file made as planned carries.
std::string text_of(const OutputPlan& plan, const Contents& contents);

// How many frames of those that came a film made as planned has.
std::int64_t n_shown_of(const OutputPlan& plan, std::int64_t n_frames);

// The number of the first frame that comes.
std::int64_t first_number(const OutputPlan& plan);

std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_gif(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_sequence(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_still(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_md5(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_null(const OutputPlan& plan);

std::int64_t recover_mp4(const std::filesystem::path& path, const Tell& tell);
std::int64_t recover_webm(const std::filesystem::path& path, const Tell& tell);
std::int64_t recover_gif(const std::filesystem::path& path, const Tell& tell);

void join_mp4(FrameEntries& entries, const OutputPlan& plan);
void join_webm(FrameEntries& entries, const OutputPlan& plan);
void join_gif(FrameEntries& entries, const OutputPlan& plan);
void join_md5(FrameEntries& entries, const OutputPlan& plan);

}  // namespace poinsot
