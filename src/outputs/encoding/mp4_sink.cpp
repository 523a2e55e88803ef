// H.264 in MP4.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "encoding/formats.h"
#include "encoding/quality.h"

namespace poinsot {

namespace {

// mbtree would lower the quality of a frame alone in its chunk, to which no later frame refers. The
// film stops at this frame, so its quality matters most.
void set_up_x264(EncoderSettings& settings, const OutputPlan& plan, bool /*alpha*/, bool alone) {
    const X264Effort& effort = quality_named(plan.quality).x264;
    settings.codec = "libx264";
    settings.header_in_container = true;
    settings.options = {{"preset", effort.preset},
                        {"crf", effort.crf},
                        {"x264-params", fmt::format("cpu-independent=1:{}{}", effort.parameters,
                                                    alone ? ":mbtree=0" : "")}};
}

// Each unit is preceded by its length in MP4, and by a start code in an encoder's packets, which a
// muxer opened for MP4 expects. Source: ISO/IEC 14496-15 §5.3.3; Rec. ITU-T H.264 Annex B.
void append_with_lengths(std::span<const std::uint8_t> packet, std::vector<std::uint8_t>& out) {
    constexpr std::array<std::uint8_t, 3> start_code{0, 0, 1};
    const auto next = [&](auto from) {
        return std::search(from, packet.end(), start_code.begin(), start_code.end());
    };
    for (auto at = next(packet.begin()); at != packet.end();) {
        const auto begin = at + start_code.size();
        at = next(begin);
        // A unit ends with a set bit; zeros after it belong to the next start code.
        auto end = at;
        while (end != begin && *(end - 1) == 0) --end;
        const auto length = static_cast<std::uint32_t>(end - begin);
        for (int shift = 24; shift >= 0; shift -= 8)
            out.push_back(static_cast<std::uint8_t>(length >> shift));
        out.insert(out.end(), begin, end);
    }
}

void put_start_codes(std::span<std::uint8_t> rest) {
    while (rest.size() >= 4) {
        std::size_t length = 0;
        for (const std::uint8_t byte : rest.first(4)) length = length << 8 | byte;
        std::copy_n("\0\0\0\1", 4, rest.begin());
        rest = rest.subspan(std::min(rest.size(), 4 + length));
    }
}

constexpr PacketFilm mp4{.container = "mp4",
                         .codec = AV_CODEC_ID_H264,
                         .subtitles = AV_CODEC_ID_MOV_TEXT,
                         .alpha = FilmAlpha::never,
                         .option = "movflags",
                         .value = "faststart+use_metadata_tags",
                         .n_threads = 3,
                         .states_square_pixels = false,
                         .needs_even_size = true,
                         .set_up = set_up_x264,
                         .pack = append_with_lengths,
                         .unpack = put_start_codes};

}  // namespace

std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan) { return open_film(mp4, plan); }

void join_mp4(FrameEntries& entries, const OutputPlan& plan) { join_film(mp4, entries, plan); }

std::int64_t recover_mp4(const std::filesystem::path& path, const SealMetadata& seal) {
    return recover_film(mp4, path, seal);
}

}  // namespace poinsot
