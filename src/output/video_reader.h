// Films read back as pictures: for tests, comparison and drawing again what a film describes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "output/frame_sink.h"

namespace poinsot {

// What a film's container and stream say of it. Names are FFmpeg's: "h264", "yuv420p", "bt709".
struct VideoInfo {
    int width_px = 0, height_px = 0;
    FrameRate rate;
    std::int64_t n_frames = 0;
    double duration_s = 0;
    std::string container, codec, pixel_format;
    std::string range, matrix, primaries, transfer, chroma_location;
    std::map<std::string, std::string> texts;
    std::vector<FilmChapter> chapters;
};

// Move-only.
class VideoReader {
 public:
    // Throws: InputError if the file is missing, is no film, or is larger than pictures may be.
    explicit VideoReader(const std::filesystem::path& path);
    ~VideoReader();
    VideoReader(VideoReader&&) noexcept;
    VideoReader& operator=(VideoReader&&) noexcept;

    const VideoInfo& info() const;

    // The next frame, in order of showing; false at the end. Colours are converted as the film's
    // tags say, chroma interpolated.
    // Throws: InputError if the film is broken here.
    bool read(Image& frame);

    // Frame k, from 0: found from the key frame before it. Leaves read() to go on with k + 1.
    // Throws: InputError if there is no such frame.
    Image frame(std::int64_t k);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace poinsot
