// H.264 in MP4. The film under way is a fragmented MP4 aside, every fragment of which is on disk as
// soon as it is whole; finish() copies its packets, unchanged, into an MP4 with its index in front.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "error/error.h"
#include "image/alpha.h"
#include "image/atomic_file.h"
#include "output/formats.h"
#include "output/video_encoder.h"
#include "output/video_remux.h"
#include "output/yuv.h"

namespace poinsot {

namespace {

// What a quality name asks of x264.
struct Quality {
    std::string_view name;
    const char* preset;
    const char* crf;
};
constexpr std::array<Quality, 4> kQualities = {{
    {"draft", "ultrafast", "23"},
    {"lecture", "veryfast", "18"},
    {"print", "medium", "18"},
    {"reference", "slow", "14"},
}};

const Quality& quality_named(const std::string& name) {
    for (const Quality& quality : kQualities)
        if (quality.name == name) return quality;
    throw InputError(fmt::format(
        "there is no quality \"{}\"; there are draft, lecture, print and reference", name));
}

// x264 decides otherwise with another number of threads, so the number must not come from the
// machine.
constexpr int kThreads = 3;

EncoderSettings settings_for(const OutputPlan& plan) {
    const Quality& quality = quality_named(plan.quality);
    EncoderSettings settings;
    settings.codec = "libx264";
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    settings.n_threads = plan.encoder_threads > 0 ? plan.encoder_threads : kThreads;
    settings.header_in_container = true;
    settings.options = {
        {"preset", quality.preset}, {"crf", quality.crf}, {"x264-params", "cpu-independent=1"}};
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

class Mp4Sink : public FrameSink {
 public:
    explicit Mp4Sink(const OutputPlan& plan)
        : plan_(plan),
          settings_(settings_for(plan)),
          converter_(plan.width_px),
          frame_(make_yuv_frame(AV_PIX_FMT_YUV420P, plan.width_px, plan.height_px)),
          packet_(libav::make_packet()),
          part_(plan.path, aside_path_of(plan.path, ".part.mp4")),
          muxer_("mp4", part_.descriptor(), plan.path, part_.aside()) {
        encoder_.emplace(settings_, plan.path);
        libav::checked(
            avcodec_parameters_from_context(muxer_.stream()->codecpar, &encoder_->context()),
            plan.path, "stream parameters");
        muxer_.stream()->time_base = encoder_->context().time_base;
        muxer_.stream()->avg_frame_rate = as_rational(plan.rate);
        muxer_.context()->flags |= AVFMT_FLAG_FLUSH_PACKETS;
        av_dict_set(&muxer_.context()->metadata, "poinsot", plan.metadata.c_str(), 0);
        libav::Options options;
        options.set("movflags", "frag_keyframe+empty_moov+default_base_moof+use_metadata_tags");
        options.set("frag_duration", "500000");
        muxer_.write_header(options);
    }

    void write(const Image& frame) override {
        if (frame.width() != plan_.width_px || frame.height() != plan_.height_px)
            throw InputError(fmt::format("a frame of {}×{} pixels in a film of {}×{}",
                                         frame.width(), frame.height(), plan_.width_px,
                                         plan_.height_px));
        libav::checked(av_frame_make_writable(frame_.get()), plan_.path, "video frame");
        const bool opaque = is_opaque(frame);
        if (!opaque) flatten_on_white(frame, flat_);
        converter_.convert(opaque ? frame : flat_,
                           {frame_->data[0], frame_->data[1], frame_->data[2], frame_->linesize[0],
                            frame_->linesize[1], frame_->linesize[2]});
        frame_->pts = n_written_++;
        encoder_->send(*frame_);
        take_packets();
    }

    void finish() override {
        encoder_->send_end();
        take_packets();
        muxer_.write_trailer();
        AtomicFile whole(plan_.path);
        remux_to_faststart(part_, whole);
        whole.commit();
    }

 private:
    void take_packets() {
        while (encoder_->receive(*packet_)) {
            packet_->duration = 1;
            muxer_.write(packet_.get(), encoder_->context().time_base);
        }
    }

    OutputPlan plan_;
    EncoderSettings settings_;
    YuvConverter converter_;
    libav::Frame frame_;
    libav::Packet packet_;
    Image flat_;
    AtomicFile part_;
    libav::Muxer muxer_;
    std::optional<VideoEncoder> encoder_;
    std::int64_t n_written_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan) {
    check_mp4(plan);
    silence_libav();
    return std::make_unique<Mp4Sink>(plan);
}

}  // namespace poinsot
