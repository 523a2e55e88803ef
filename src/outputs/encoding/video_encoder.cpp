#include "encoding/video_encoder.h"

#include <fmt/format.h>

#include <limits>

#include "error/error.h"

namespace poinsot {

using libav::checked;

VideoEncoder::VideoEncoder(const EncoderSettings& settings, std::filesystem::path path)
    : path_(std::move(path)) {
    const AVCodec* codec = avcodec_find_encoder_by_name(settings.codec);
    if (!codec)
        throw EnvironmentError(
            fmt::format("cannot write {}: this FFmpeg was built without the encoder {}",
                        path_.string(), settings.codec));
    context_.reset(avcodec_alloc_context3(codec));
    if (!context_) throw EnvironmentError("no memory for a video encoder");
    context_->width = settings.width_px;
    context_->height = settings.height_px;
    context_->pix_fmt = settings.pixel_format;
    context_->framerate = as_rational(settings.rate);
    context_->time_base = av_inv_q(context_->framerate);
    context_->sample_aspect_ratio = {1, 1};
    context_->thread_count = settings.n_threads;
    context_->color_range = AVCOL_RANGE_MPEG;
    context_->colorspace = AVCOL_SPC_BT709;
    context_->color_primaries = AVCOL_PRI_BT709;
    context_->color_trc = AVCOL_TRC_BT709;
    context_->chroma_sample_location = AVCHROMA_LOC_LEFT;
    // Without this flag the stream contains the library's version.
    context_->flags |= AV_CODEC_FLAG_BITEXACT;
    if (settings.header_in_container) context_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    libav::Options options;
    for (const auto& [key, value] : settings.options) options.set(key, value);
    checked(avcodec_open2(context_.get(), codec, options.get()), path_,
            fmt::format("opening {}", settings.codec));
    if (const AVDictionaryEntry* unknown =
            av_dict_get(*options.get(), "", nullptr, AV_DICT_IGNORE_SUFFIX))
        throw EnvironmentError(fmt::format("cannot write {}: {} does not know the option {}",
                                           path_.string(), settings.codec, unknown->key));
}

void VideoEncoder::send(const AVFrame& frame) {
    checked(avcodec_send_frame(context_.get(), &frame), path_, "encoding");
}

void VideoEncoder::send_end() {
    checked(avcodec_send_frame(context_.get(), nullptr), path_, "ending the encoding");
}

bool VideoEncoder::receive(AVPacket& packet) {
    const int result = avcodec_receive_packet(context_.get(), &packet);
    if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return false;
    checked(result, path_, "encoding");
    return true;
}

libav::Frame make_yuv_frame(AVPixelFormat format, int width_px, int height_px) {
    libav::Frame frame = libav::make_frame();
    frame->format = format;
    frame->width = width_px;
    frame->height = height_px;
    frame->color_range = AVCOL_RANGE_MPEG;
    frame->colorspace = AVCOL_SPC_BT709;
    frame->color_primaries = AVCOL_PRI_BT709;
    frame->color_trc = AVCOL_TRC_BT709;
    frame->chroma_location = AVCHROMA_LOC_LEFT;
    frame->sample_aspect_ratio = {1, 1};
    if (av_frame_get_buffer(frame.get(), 0) < 0)
        throw EnvironmentError("no memory for a video frame");
    return frame;
}

void check_film(const OutputPlan& plan) {
    constexpr std::int64_t largest = std::numeric_limits<int>::max();
    if (plan.width_px <= 0 || plan.height_px <= 0)
        throw InputError(fmt::format("a film needs at least one pixel; {}×{} has none",
                                     plan.width_px, plan.height_px));
    if (plan.rate.numerator <= 0 || plan.rate.denominator <= 0 || plan.rate.numerator > largest ||
        plan.rate.denominator > largest)
        throw InputError(fmt::format("a film needs a frame rate above 0; {}/{} is not one",
                                     plan.rate.numerator, plan.rate.denominator));
}

void check_frame(const Image& frame, const OutputPlan& plan) {
    if (frame.width() != plan.width_px || frame.height() != plan.height_px)
        throw InputError(fmt::format("a frame of {}×{} pixels was given to {}, which is {}×{}",
                                     frame.width(), frame.height(), plan.path.string(),
                                     plan.width_px, plan.height_px));
}

void check_any_frame(std::int64_t n_written, const OutputPlan& plan) {
    if (n_written == 0) throw InputError(fmt::format("{} was given no frame", plan.path.string()));
}

AVRational as_rational(const FrameRate& rate) {
    return {static_cast<int>(rate.numerator), static_cast<int>(rate.denominator)};
}

void silence_libav() { av_log_set_level(AV_LOG_QUIET); }

}  // namespace poinsot
