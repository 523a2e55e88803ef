// Reads the pictures of films: for tests, comparison and rendering again from a film's record.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "encoding/frame_sink.h"
#include "image/image.h"

namespace poinsot {

// Rows of 16.16, 16.16 and 2.30 bits. Source: ISO/IEC 14496-12 §8.3.2.
using DisplayMatrix = std::array<std::int32_t, 9>;
inline constexpr DisplayMatrix upright{1 << 16, 0, 0, 0, 1 << 16, 0, 0, 0, 1 << 30};

// Data of a film's container and stream. Names are FFmpeg's: "h264", "yuv420p", "bt709".
struct VideoInfo {
    int width_px = 0, height_px = 0;
    // How players show the pictures: the matrix that turns, mirrors or stretches them, as the file
    // stores it, and the width of a pixel over its height.
    DisplayMatrix display = upright;
    std::int64_t pixel_width = 1, pixel_height = 1;
    bool is_shown = true;  // false: the track of the pictures is switched off
    FrameRate rate;
    std::int64_t n_frames = 0;
    double duration_s = 0;  // of the pictures
    std::string container, codec, pixel_format;
    std::string range, matrix, primaries, transfer, chroma_location;
    std::map<std::string, std::string> texts;
    std::vector<FilmChapter> chapters;
};

// Move-only.
class VideoReader {
 public:
    // Throws: InputError if the file is missing, is not a film, or its pictures are too large.
    explicit VideoReader(const std::filesystem::path& path);
    ~VideoReader();
    VideoReader(VideoReader&&) noexcept;
    VideoReader& operator=(VideoReader&&) noexcept;

    const VideoInfo& info() const;

    // Reads the next frame, in order of display; false at the end. Colours are converted according
    // to the film's tags, chroma interpolated. Throws: InputError if the film is corrupt here.
    bool read(Image& frame);

    // When the frame that was read last is shown; none in a film that does not say it.
    std::optional<double> time_s() const;

    // Returns frame k, from 0, decoded from the preceding key frame. read() continues with k + 1.
    // Throws: InputError if there is no such frame.
    Image frame(std::int64_t k);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace poinsot
