// VP9 in WebM: smaller than H.264, and with transparency. No chunks: a WebM film starts again from
// its first frame.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "error/error.h"
#include "image/alpha.h"
#include "image/atomic_file.h"
#include "output/chapters.h"
#include "output/formats.h"
#include "output/video_encoder.h"
#include "output/yuv.h"

namespace poinsot {

namespace {

// What a quality name asks of libvpx. Speed 8 exists in its realtime mode only.
struct Quality {
    std::string_view name;
    const char *deadline, *speed, *crf;
};
constexpr std::array<Quality, 4> kQualities = {{
    {"draft", "realtime", "8", "36"},
    {"lecture", "realtime", "6", "28"},
    {"print", "good", "4", "24"},
    {"reference", "good", "2", "16"},
}};

// As with x264, the bytes depend on the number of threads.
constexpr int kThreads = 2;

EncoderSettings settings_for(const OutputPlan& plan, bool alpha) {
    const Quality& quality = quality_named(kQualities, plan.quality);
    EncoderSettings settings;
    settings.codec = "libvpx-vp9";
    settings.pixel_format = alpha ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    settings.n_threads = plan.encoder_threads > 0 ? plan.encoder_threads : kThreads;
    // Frames that are never shown cannot carry alpha.
    settings.options = {{"deadline", quality.deadline},
                        {"cpu-used", quality.speed},
                        {"crf", quality.crf},
                        {"b", "0"},
                        {"row-mt", "1"},
                        {"auto-alt-ref", alpha ? "0" : "1"}};
    return settings;
}

// Whether the film carries alpha is known from its first frame.
class WebmSink : public FrameSink {
 public:
    explicit WebmSink(const OutputPlan& plan)
        : plan_(plan), converter_(plan.width_px), packet_(libav::make_packet()), file_(plan.path) {}

    void write(const Image& frame) override {
        check_frame(frame, plan_);
        if (!encoder_) start(!is_opaque(frame));
        libav::checked(av_frame_make_writable(frame_.get()), plan_.path, "video frame");
        const bool flattened = !alpha_ && !is_opaque(frame);
        if (flattened) flatten_on_white(frame, flat_);
        converter_.convert(flattened ? flat_ : frame,
                           {frame_->data[0], frame_->data[1], frame_->data[2], frame_->linesize[0],
                            frame_->linesize[1], frame_->linesize[2]});
        if (alpha_) copy_alpha(frame, frame_->data[3], frame_->linesize[3]);
        frame_->pts = n_written_++;
        encoder_->send(*frame_);
        take_packets();
    }

    void finish() override {
        check_any_frame(n_written_, plan_);
        encoder_->send_end();
        take_packets();
        muxer_->write_trailer();
        file_.commit();
    }

 private:
    void start(bool alpha) {
        alpha_ = alpha;
        frame_ = make_yuv_frame(alpha ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P, plan_.width_px,
                                plan_.height_px);
        encoder_ = std::make_unique<VideoEncoder>(settings_for(plan_, alpha), plan_.path);
        muxer_ =
            std::make_unique<libav::Muxer>("webm", file_.descriptor(), plan_.path, file_.aside());
        AVStream* stream = muxer_->stream();
        libav::checked(avcodec_parameters_from_context(stream->codecpar, &encoder_->context()),
                       plan_.path, "stream parameters");
        stream->time_base = encoder_->context().time_base;
        stream->avg_frame_rate = as_rational(plan_.rate);
        if (alpha) av_dict_set(&stream->metadata, "alpha_mode", "1", 0);
        av_dict_set(&muxer_->context()->metadata, "poinsot", plan_.metadata.c_str(), 0);
        add_chapters(*muxer_->context(), plan_.chapters, plan_.rate);
        libav::Options options;
        // The index in front lets players seek while they load.
        options.set("cues_to_front", "1");
        muxer_->write_header(options);
    }

    void take_packets() {
        while (encoder_->receive(*packet_)) {
            packet_->duration = 1;
            muxer_->write(packet_.get(), encoder_->context().time_base);
        }
    }

    OutputPlan plan_;
    YuvConverter converter_;
    libav::Packet packet_;
    AtomicFile file_;
    libav::Frame frame_;
    std::unique_ptr<VideoEncoder> encoder_;
    std::unique_ptr<libav::Muxer> muxer_;
    Image flat_;
    bool alpha_ = false;
    std::int64_t n_written_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan) {
    check_film(plan);
    quality_named(kQualities, plan.quality);
    silence_libav();
    return std::make_unique<WebmSink>(plan);
}

}  // namespace poinsot
