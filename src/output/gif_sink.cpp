// GIF: 255 colours chosen from all frames, so frames wait aside until the last has come.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "error/error.h"
#include "image/alpha.h"
#include "image/atomic_file.h"
#include "image/png.h"
#include "output/formats.h"
#include "output/palette.h"
#include "output/video_encoder.h"

namespace poinsot {

namespace {

// One index stays free for what is transparent or as it was in the frame before.
constexpr std::uint8_t kTransparentIndex = 255;
// A pixel is there or not: what fades out does so into white, and ends where it is all but gone.
constexpr std::uint8_t kHoleBelowAlpha = 16;

void append_comment(AtomicFile& file, const std::string& text) {
    // GIF89a §24: an extension of blocks of at most 255 bytes, before the trailer's one byte.
    constexpr std::uint8_t trailer = 0x3b;
    std::vector<std::uint8_t> bytes = {0x21, 0xfe};
    for (std::size_t at = 0; at < text.size(); at += 255) {
        const std::string block = text.substr(at, 255);
        bytes.push_back(static_cast<std::uint8_t>(block.size()));
        bytes.insert(bytes.end(), block.begin(), block.end());
    }
    bytes.insert(bytes.end(), {0, trailer});
    if (::lseek(file.descriptor(), -1, SEEK_END) < 0) throw_write_error(file.path(), errno);
    file.write(bytes);
}

class GifSink : public FrameSink {
 public:
    explicit GifSink(const OutputPlan& plan)
        : plan_(plan),
          file_(plan.path),
          waiting_(plan.path, aside_path_of(plan.path, ".frames")),
          spooler_(PngOptions{.texts = {}, .pixels_per_metre = 0, .deflate_level = 1}) {}

    void write(const Image& frame) override {
        check_frame(frame, plan_);
        // What is half transparent shows its colour on white.
        const bool opaque = is_opaque(frame);
        if (!opaque) flatten_keeping_holes(frame);
        const Image& shown = opaque ? frame : flat_;
        count_.add(shown);
        const auto bytes = spooler_.encode(shown);
        waiting_.write(bytes);
        sizes_.push_back(bytes.size());
    }

    void finish() override {
        check_any_frame(static_cast<std::int64_t>(sizes_.size()), plan_);
        encode_all();
        if (!plan_.metadata.empty()) append_comment(file_, plan_.metadata);
        file_.commit();
        waiting_.discard();
    }

 private:
    void flatten_keeping_holes(const Image& frame) {
        flatten_on_white(frame, flat_);
        for (std::size_t i = 3; i < frame.bytes().size(); i += 4)
            flat_.bytes()[i] = frame.bytes()[i] < kHoleBelowAlpha ? 0 : 255;
    }

    EncoderSettings settings() const {
        EncoderSettings settings;
        settings.codec = "gif";
        settings.pixel_format = AV_PIX_FMT_PAL8;
        settings.width_px = plan_.width_px;
        settings.height_px = plan_.height_px;
        settings.rate = plan_.rate;
        return settings;
    }

    void encode_all() {
        const std::vector<Rgba8> palette = palette_for(count_, kTransparentIndex);
        Ditherer ditherer(palette, kTransparentIndex);
        VideoEncoder encoder(settings(), plan_.path);
        libav::Muxer muxer("gif", file_.descriptor(), plan_.path, file_.aside());
        libav::checked(
            avcodec_parameters_from_context(muxer.stream()->codecpar, &encoder.context()),
            plan_.path, "stream parameters");
        muxer.stream()->time_base = encoder.context().time_base;
        libav::Options options;
        muxer.write_header(options);
        const libav::Frame frame = indexed_frame();
        if (::lseek(waiting_.descriptor(), 0, SEEK_SET) != 0) throw_write_error(plan_.path, errno);
        for (std::size_t k = 0; k < sizes_.size(); ++k) {
            libav::checked(av_frame_make_writable(frame.get()), plan_.path, "video frame");
            set_palette(*frame, palette);
            ditherer.apply(next_waiting(sizes_[k]), frame->data[0], frame->linesize[0]);
            frame->pts = static_cast<std::int64_t>(k);
            encoder.send(*frame);
            take_packets(encoder, muxer);
        }
        encoder.send_end();
        take_packets(encoder, muxer);
        muxer.write_trailer();
    }

    libav::Frame indexed_frame() const {
        libav::Frame frame = libav::make_frame();
        frame->format = AV_PIX_FMT_PAL8;
        frame->width = plan_.width_px;
        frame->height = plan_.height_px;
        libav::checked(av_frame_get_buffer(frame.get(), 0), plan_.path, "video frame");
        return frame;
    }

    static void set_palette(AVFrame& frame, const std::vector<Rgba8>& palette) {
        auto* entries = reinterpret_cast<std::uint32_t*>(frame.data[1]);
        std::fill_n(entries, AVPALETTE_COUNT, 0xff000000u);
        for (std::size_t i = 0; i < palette.size(); ++i)
            entries[i] = 0xff000000u | static_cast<std::uint32_t>(palette[i].r) << 16 |
                         static_cast<std::uint32_t>(palette[i].g) << 8 | palette[i].b;
        entries[kTransparentIndex] = 0;
    }

    Image next_waiting(std::size_t size) {
        buffer_.resize(size);
        std::size_t done = 0;
        while (done < size) {
            const ssize_t n = ::read(waiting_.descriptor(), buffer_.data() + done, size - done);
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) throw_write_error(plan_.path, n < 0 ? errno : EIO);
            done += static_cast<std::size_t>(n);
        }
        return decode_png(buffer_, plan_.path.string());
    }

    void take_packets(VideoEncoder& encoder, libav::Muxer& muxer) {
        while (encoder.receive(*packet_)) muxer.write(packet_.get(), encoder.context().time_base);
    }

    OutputPlan plan_;
    AtomicFile file_;
    AtomicFile waiting_;  // the frames so far, as PNG files one after another; never committed
    PngEncoder spooler_;
    ColourCount count_;
    std::vector<std::size_t> sizes_;
    std::vector<std::uint8_t> buffer_;
    Image flat_;
    libav::Packet packet_ = libav::make_packet();
};

}  // namespace

std::unique_ptr<FrameSink> open_gif(const OutputPlan& plan) {
    check_film(plan);
    // Times are in hundredths of a second, and players take less than two of them for a mistake.
    if (plan.rate.per_second() > 50)
        throw InputError(
            fmt::format("a GIF shows at most 50 frames a second, not {:g}; lower fps, "
                        "or write MP4 or WebM",
                        plan.rate.per_second()));
    if (plan.width_px > 65535 || plan.height_px > 65535)
        throw InputError("a GIF is at most 65535 pixels wide and high");
    silence_libav();
    return std::make_unique<GifSink>(plan);
}

}  // namespace poinsot
