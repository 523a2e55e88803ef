// The frames of a film, or of a sequence of PNG pictures, one after the other.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "encoding/video_reader.h"
#include "image/frame_rate.h"
#include "image/png.h"

namespace poinsot {

// Whether a name is that of a film that can be read: those that poinsot writes, .mkv and .avi.
bool is_film_name(const std::filesystem::path& file);

// Whether a name is that of a sequence: "turn_####.png". If there is a picture of exactly this
// name, it is meant.
bool is_sequence_name(const std::filesystem::path& file);

// Holds one frame at a time. Move-only.
class FrameStream {
 public:
    // Throws InputError for a file that is not a film, for a sequence without pictures and for one
    // with a gap.
    explicit FrameStream(const std::filesystem::path& path);

    // Reads the next frame; false at the end. Throws InputError where the film or a picture is
    // broken.
    bool read(StoredPicture& frame);

    // When the frame that was read last is shown; none for a sequence, which has no times.
    std::optional<double> time_s() const;

    // None for a sequence, and for a film that does not say it.
    std::optional<FrameRate> rate() const;
    // How the film says it is shown; none for a sequence.
    const VideoInfo* info() const;
    // From the film's header, or the number of pictures; a broken film may have fewer.
    std::int64_t n_frames() const;
    // Of one frame of a film, in pixels; 0 for a sequence, whose frames say it themselves.
    std::int64_t frame_pixels() const;
    // A file that carries the record: the film, or the first picture.
    std::filesystem::path file() const;

 private:
    std::filesystem::path path_;
    std::optional<VideoReader> film_;
    std::vector<std::int64_t> numbers_;  // of a sequence
    std::size_t next_ = 0;
};

}  // namespace poinsot
