// Functions for the tests of all film formats: making a small film, and reading a file's bytes.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "encoding/frame_sink.h"
#include "encoding/video_reader.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/synthetic.h"
#include "refusal.h"
#include "system/faults.h"

namespace poinsot {

inline OutputPlan small_plan(const std::filesystem::path& path, std::int64_t n_frames = 5) {
    OutputPlan plan;
    plan.path = path;
    plan.width_px = 64;
    plan.height_px = 48;
    plan.n_frames = n_frames;
    plan.quality = "draft";
    plan.metadata = "scene = \"ω\"";
    return plan;
}

// A film of several chunks, with chapters, that is continued after an interruption.
inline OutputPlan film_plan(const std::filesystem::path& path, std::int64_t n_frames = 400) {
    OutputPlan plan = small_plan(path, n_frames);
    plan.chapters = {{"The ellipsoid", 0, 90}, {"ρ = n/√I\n1 2 3", 90, n_frames}};
    plan.resume = true;
    return plan;
}

inline Image frame_of(const OutputPlan& plan, std::int64_t k) {
    return synthetic_frame(plan.width_px, plan.height_px, static_cast<int>(k));
}

inline void write_film(const OutputPlan& plan) {
    const auto sink = format_for(plan.path).open(plan);
    for (std::int64_t k = 0; k < plan.n_frames; ++k)
        if (!sink->has_frame(k)) sink->write(frame_of(plan, k));
    sink->finish();
}

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::vector<Image> frames_of(const std::filesystem::path& path) {
    VideoReader reader(path);
    std::vector<Image> frames;
    for (Image frame; reader.read(frame);) frames.push_back(frame);
    return frames;
}

// Mean difference in levels over R, G and B; pixels that are transparent in both are skipped.
inline double mean_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.bytes().size(); ++i)
        if (i % 4 != 3 && (a.bytes()[i | 3] > 0 || b.bytes()[i | 3] > 0))
            sum += std::abs(int{a.bytes()[i]} - int{b.bytes()[i]});
    return sum / (0.75 * static_cast<double>(a.bytes().size()));
}

}  // namespace poinsot
