// One run of a libavcodec video encoder: frames in, packets out in decoding order.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "encoding/frame_sink.h"
#include "encoding/libav.h"

namespace poinsot {

struct EncoderSettings {
    const char* codec = "libx264";
    AVPixelFormat pixel_format = AV_PIX_FMT_YUV420P;
    int width_px = 0, height_px = 0;
    FrameRate rate;
    int n_threads = 1;
    std::vector<std::pair<const char*, std::string>> options;  // the codec's own
    bool header_in_container = false;  // parameter sets go to the container, not the stream
};

class VideoEncoder {
 public:
    // path names the output in messages. Throws EnvironmentError.
    VideoEncoder(const EncoderSettings& settings, std::filesystem::path path);

    const AVCodecContext& context() const { return *context_; }

    // Sends a frame, or the end. Throw EnvironmentError. The frame may be changed after the call.
    void send(const AVFrame& frame);
    void send_end();
    // Receives a packet; false if none is ready.
    bool receive(AVPacket& packet);

 private:
    std::filesystem::path path_;
    libav::CodecContext context_;
};

// Returns a video frame with memory for its pixels and the colour tags of BT.709, limited range,
// left chroma.
libav::Frame make_yuv_frame(AVPixelFormat format, int width_px, int height_px);

// Throw InputError for a plan that no film can have: an empty picture, a rate that is not positive.
void check_film(const OutputPlan& plan);

// Throws InputError if the frame's size differs from the plan's.
void check_frame(const Image& frame, const OutputPlan& plan);

// Throws InputError if nothing was written: a film has at least one frame.
void check_any_frame(std::int64_t n_written, const OutputPlan& plan);

// The rate as FFmpeg's rational.
AVRational as_rational(const FrameRate& rate);

// Turns off FFmpeg's own messages on stderr; our errors contain them.
void silence_libav();

}  // namespace poinsot
