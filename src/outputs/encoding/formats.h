// Definitions that several formats share. Included only inside output/.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "encoding/frame_log.h"
#include "encoding/frame_sink.h"
#include "encoding/video_encoder.h"

namespace poinsot {

// Frames in a chunk, which is encoded independently. x264 sets a key frame every 250 frames anyway,
// libvpx every 128; with 120 an MP4 is a tenth larger, and an interrupted film loses at most 4 s at
// 30 frames a second. The pictures of a GIF depend on earlier ones only through the palette, which
// is computed for the whole film.
inline constexpr std::int64_t frames_a_chunk = 120;

// Returns the metadata text of a file made from this plan.
std::string text_of(const OutputPlan& plan, const EncodedMetadata& encoded);

// Returns the number of frames in a film made from this plan, of those that were written to it.
std::int64_t n_shown_of(const OutputPlan& plan, std::int64_t n_frames);

// Returns the number of the first frame to be written.
std::int64_t first_number(const OutputPlan& plan);

// Whether a film has an alpha plane: never, if its first frame is not opaque, or always.
enum class FilmAlpha { never, of_first_frame, always };

// The differences between films of packets in a container, MP4, WebM and QuickTime; see
// packet_film.cpp.
struct PacketFilm {
    const char* container;
    AVCodecID codec, subtitles;
    std::uint32_t codec_tag = 0;  // 0: the container's own
    FilmAlpha alpha;
    // The container's option that writes the index at the front, so that players can seek while
    // they load.
    const char *option, *value;
    // The bytes of an encoder depend on this number, so it must not depend on the machine.
    int n_threads;
    bool states_square_pixels = true;
    bool needs_even_size = false;
    // `alone`: for a frame in a chunk of its own, see OutputPlan::ends_alone.
    void (*set_up)(EncoderSettings& settings, const OutputPlan& plan, bool alpha, bool alone);
    // Convert an encoder's packet to that of the container, and back in place for the muxer, which
    // expects an encoder's. Null: they are equal.
    void (*pack)(std::span<const std::uint8_t> packet, std::vector<std::uint8_t>& out) = nullptr;
    void (*unpack)(std::span<std::uint8_t> packet) = nullptr;
};

// As open, join and recover of a row of output_formats.
std::unique_ptr<FrameSink> open_film(const PacketFilm& format, const OutputPlan& plan);
void join_film(const PacketFilm& format, FrameEntries& entries, const OutputPlan& plan);
std::int64_t recover_film(const PacketFilm& format, const std::filesystem::path& path,
                          const SealMetadata& seal);

}  // namespace poinsot
