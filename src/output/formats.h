// What the rows of the table of formats open. Known only to the table.
#pragma once

#include <memory>

#include "output/frame_sink.h"

namespace poinsot {

std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_gif(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_sequence(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_still(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_md5(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_null(const OutputPlan& plan);

std::int64_t recover_mp4(const std::filesystem::path& path, const Retell& retell);
std::int64_t recover_webm(const std::filesystem::path& path, const Retell& retell);
std::int64_t recover_gif(const std::filesystem::path& path, const Retell& retell);

}  // namespace poinsot
