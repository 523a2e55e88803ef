// A film under way: a fragmented MP4 aside, each fragment on disk as soon as it is whole, so that a
// killed run loses no more than the last. In the end its packets are copied, unchanged, into an MP4
// with its index in front.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "output/frame_sink.h"
#include "output/libav.h"
#include "system/atomic_file.h"

namespace poinsot {

class FilmPart {
 public:
    // The encoder gives the stream's parameters. settings says everything that its packets depend
    // on. With plan.resume, frames of an earlier part are kept if metadata and settings are the
    // same: as many whole chunks of n_chunk_frames as there are.
    // Throws EnvironmentError.
    FilmPart(const OutputPlan& plan, const AVCodecContext& encoder, const std::string& settings,
             std::int64_t n_chunk_frames);
    ~FilmPart();

    std::int64_t n_frames_kept() const { return n_frames_kept_; }

    // Takes over the packet's contents. Its times count frames. Throws EnvironmentError.
    void write(AVPacket* packet);

    std::uint64_t n_bytes() const;  // on disk so far

    // Makes the whole film, under its final name, of n_frames. Throws EnvironmentError.
    void finish(std::int64_t n_frames);

 private:
    std::unique_ptr<libav::Muxer> open_muxer(const AtomicFile& file, const AVCodecContext& encoder,
                                             const std::string& settings) const;
    void keep_chunks(const AVCodecContext& encoder, const std::string& settings,
                     std::int64_t n_chunk_frames);

    std::filesystem::path path_;
    OutputPlan plan_;
    AVRational time_base_;
    std::int64_t n_frames_kept_ = 0;
    AtomicFile file_;
    std::unique_ptr<libav::Muxer> muxer_;
};

// Where the film under way to a final name lies.
std::filesystem::path film_part_path(const std::filesystem::path& path);

}  // namespace poinsot
