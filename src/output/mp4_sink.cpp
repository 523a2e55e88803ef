// H.264 in MP4, encoded in chunks that know nothing of each other, so that a film that was
// interrupted and goes on from a chunk's end is the same as one that was not.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "error/error.h"
#include "image/alpha.h"
#include "output/film_part.h"
#include "output/formats.h"
#include "output/video_encoder.h"
#include "output/yuv.h"
#include "system/room.h"

namespace poinsot {

namespace {

// What a quality name asks of x264: points of the front that tests/bench/x264_search.py finds. At
// the likeness of the preset medium at crf 18 (SSIM 0.9969, default scene, 1920×1080) and with
// their presets' lookahead, "lecture" takes 0.46 of its CPU time and 1.11 of its size, "print" 0.67
// and 0.99, "reference" 1.31 and 0.93. psy would add the grain that drawings lack; aq-mode 2 spends
// a tenth more than aq-mode 1 for the same likeness. A short lookahead bounds memory and what a
// kill can take, which stays under a second from 24 frames a second on: 10 frames instead of 20
// make a print film 1 % smaller and its SSIM 0.00015 less. A lookahead thread of its own, before
// which sync-lookahead frames wait (4 by default), changes no byte: with 2 a lecture film takes 6 %
// less time and 20 MiB more, those below and above it gain nothing.
struct Quality {
    std::string_view name;
    const char *preset, *crf, *x264;
};
constexpr std::array<Quality, 4> kQualities = {{
    {"draft", "ultrafast", "23", "psy=0:sync-lookahead=0"},
    {"lecture", "veryfast", "18", "psy=0:aq-mode=1:trellis=1:sync-lookahead=2"},
    {"print", "fast", "17", "psy=0:aq-mode=1:rc-lookahead=10:sync-lookahead=0"},
    {"reference", "slow", "14", "psy=0:aq-mode=1:rc-lookahead=10:sync-lookahead=0"},
}};

// x264 decides otherwise with another number of threads, so the number must not come from the
// machine.
constexpr int kThreads = 3;

// Frames between two starts of the encoder. x264 sets a key frame every 250 anyway; with 120 a film
// is a tenth larger, and an interrupted one goes on from 4 s before, at 30 frames a second.
constexpr std::int64_t kChunkFrames = 120;

EncoderSettings settings_for(const OutputPlan& plan) {
    const Quality& quality = quality_named(kQualities, plan.quality);
    EncoderSettings settings;
    settings.codec = "libx264";
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    settings.n_threads = plan.encoder_threads > 0 ? plan.encoder_threads : kThreads;
    settings.header_in_container = true;
    settings.options = {{"preset", quality.preset},
                        {"crf", quality.crf},
                        {"x264-params", fmt::format("cpu-independent=1:{}", quality.x264)}};
    return settings;
}

void check_mp4(const OutputPlan& plan) {
    check_film(plan);
    if (plan.width_px % 2 != 0 || plan.height_px % 2 != 0)
        throw InputError(fmt::format(
            "an MP4 film needs an even width and height, and {}×{} is not; take {}×{}, or write "
            "PNG frames or WebM",
            plan.width_px, plan.height_px, plan.width_px + plan.width_px % 2,
            plan.height_px + plan.height_px % 2));
}

// Everything that the packets depend on, besides the frames; the parameter sets stand for the
// encoder's version.
std::string description_of(const EncoderSettings& settings, const OutputPlan& plan,
                           const AVCodecContext& encoder) {
    std::string text = fmt::format("{} {}×{} {}/{} from {} threads={}", settings.codec,
                                   settings.width_px, settings.height_px, settings.rate.numerator,
                                   settings.rate.denominator, plan.first_frame, settings.n_threads);
    for (const auto& [key, value] : settings.options) text += fmt::format(" {}={}", key, value);
    text += " header=";
    for (int i = 0; i < encoder.extradata_size; ++i)
        text += fmt::format("{:02x}", encoder.extradata[i]);
    return text;
}

class Mp4Sink : public FrameSink {
 public:
    explicit Mp4Sink(const OutputPlan& plan)
        : plan_(plan),
          settings_(settings_for(plan)),
          converter_(plan.width_px),
          frame_(make_yuv_frame(AV_PIX_FMT_YUV420P, plan.width_px, plan.height_px)),
          packet_(libav::make_packet()),
          encoder_(std::in_place, settings_, plan.path),
          part_(plan, encoder_->context(), description_of(settings_, plan, encoder_->context()),
                kChunkFrames),
          n_written_(part_.n_frames_kept()) {}

    std::int64_t n_frames_kept() const override { return part_.n_frames_kept(); }

    void write(const Image& frame) override {
        write_telling(frame, [] {});
    }

    void write_telling(const Image& frame, const WasRead& was_read) override {
        check_frame(frame, plan_);
        if (n_in_chunk_ == kChunkFrames) start_chunk();
        libav::checked(av_frame_make_writable(frame_.get()), plan_.path, "video frame");
        const bool opaque = is_opaque(frame);
        if (!opaque) flatten_on_white(frame, flat_);
        converter_.convert(opaque ? frame : flat_,
                           {frame_->data[0], frame_->data[1], frame_->data[2], frame_->linesize[0],
                            frame_->linesize[1], frame_->linesize[2]});
        was_read();
        frame_->pts = n_written_++;
        ++n_in_chunk_;
        encoder_->send(*frame_);
        take_packets();
    }

    void finish() override {
        check_any_frame(n_written_, plan_);
        encoder_->send_end();
        take_packets();
        part_.finish(n_written_);
    }

 private:
    void start_chunk() {
        encoder_->send_end();
        take_packets();
        encoder_.reset();  // first, so that there are never two
        encoder_.emplace(settings_, plan_.path);
        n_in_chunk_ = 0;
        check_room(plan_.path, part_.n_bytes(), n_written_, plan_.n_frames);
    }

    void take_packets() {
        while (encoder_->receive(*packet_)) part_.write(packet_.get());
    }

    OutputPlan plan_;
    EncoderSettings settings_;
    YuvConverter converter_;
    libav::Frame frame_;
    libav::Packet packet_;
    Image flat_;
    std::optional<VideoEncoder> encoder_;
    FilmPart part_;
    std::int64_t n_written_;
    std::int64_t n_in_chunk_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan) {
    check_mp4(plan);
    silence_libav();
    return std::make_unique<Mp4Sink>(plan);
}

}  // namespace poinsot
