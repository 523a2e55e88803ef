// Films with transparency: VP9 in WebM, smaller than H.264, and ProRes 4444 in QuickTime, for video
// editors.
#include <string>

#include "encoding/formats.h"
#include "encoding/quality.h"

namespace poinsot {

namespace {

void set_up_vp9(EncoderSettings& settings, const OutputPlan& plan, bool alpha, bool /*alone*/) {
    const Vp9Effort& effort = quality_named(plan.quality).vp9;
    settings.codec = "libvpx-vp9";
    settings.pixel_format = alpha ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
    // Frames that are not shown cannot carry alpha.
    settings.options = {{"deadline", effort.deadline},
                        {"cpu-used", effort.speed},
                        {"crf", effort.crf},
                        {"b", "0"},
                        {"row-mt", "1"},
                        {"lag-in-frames", "16"},
                        {"auto-alt-ref", alpha ? "0" : "1"}};
}

// The finest quantizer, for every quality: the next one exceeds the three levels within which a
// film over a background is the picture. The alpha plane is coded without loss; eight bits are what
// pictures have. Some editors accept only Apple's name as the encoder's.
void set_up_prores(EncoderSettings& settings, const OutputPlan& /*plan*/, bool /*alpha*/,
                   bool /*alone*/) {
    settings.codec = "prores_ks";
    settings.pixel_format = AV_PIX_FMT_YUVA444P10LE;
    settings.options = {{"profile", "4444"},
                        {"global_quality", std::to_string(FF_QP2LAMBDA)},
                        {"alpha_bits", "8"},
                        {"vendor", "apl0"}};
}

constexpr PacketFilm webm{.container = "webm",
                          .codec = AV_CODEC_ID_VP9,
                          .subtitles = AV_CODEC_ID_WEBVTT,
                          .alpha = FilmAlpha::of_first_frame,
                          .option = "cues_to_front",
                          .value = "1",
                          .n_threads = 2,
                          .set_up = set_up_vp9};
constexpr PacketFilm mov{.container = "mov",
                         .codec = AV_CODEC_ID_PRORES,
                         .subtitles = AV_CODEC_ID_MOV_TEXT,
                         .codec_tag = MKTAG('a', 'p', '4', 'h'),
                         .alpha = FilmAlpha::always,
                         .option = "movflags",
                         .value = "faststart+use_metadata_tags",
                         .n_threads = 2,
                         .set_up = set_up_prores};

}  // namespace

std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan) { return open_film(webm, plan); }
std::unique_ptr<FrameSink> open_mov(const OutputPlan& plan) { return open_film(mov, plan); }

void join_webm(FrameEntries& entries, const OutputPlan& plan) { join_film(webm, entries, plan); }
void join_mov(FrameEntries& entries, const OutputPlan& plan) { join_film(mov, entries, plan); }

std::int64_t recover_webm(const std::filesystem::path& path, const SealMetadata& seal) {
    return recover_film(webm, path, seal);
}
std::int64_t recover_mov(const std::filesystem::path& path, const SealMetadata& seal) {
    return recover_film(mov, path, seal);
}

}  // namespace poinsot
