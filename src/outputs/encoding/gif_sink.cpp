// GIF: 255 colours chosen from all frames, so frames wait in a log until the last is written. A
// killed run loses none of them.
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "encoding/film_packets.h"
#include "encoding/formats.h"
#include "encoding/frame_log.h"
#include "encoding/palette.h"
#include "encoding/video_encoder.h"
#include "error/error.h"
#include "image/alpha.h"
#include "image/png.h"
#include "system/files/atomic_file.h"
#include "system/files/free_space.h"

namespace poinsot {

namespace {

// One index is reserved for transparent or unchanged pixels.
constexpr std::uint8_t transparent_index = 255;
// Transparency is all or nothing: a pixel that fades out blends into white, and becomes transparent
// when almost invisible.
constexpr std::uint8_t hole_below_alpha = 16;

// The bytes in the file so far.
std::vector<std::uint8_t> contents_of(const AtomicFile& file) {
    struct stat status {};
    if (fstat(file.descriptor(), &status) != 0) throw_write_error(file.path(), errno);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::pread(file.descriptor(), bytes.data() + done, bytes.size() - done,
                                  static_cast<off_t>(done));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) throw_write_error(file.path(), n < 0 ? errno : EIO);
        done += static_cast<std::size_t>(n);
    }
    return bytes;
}

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

EncoderSettings gif_settings(const OutputPlan& plan) {
    EncoderSettings settings;
    settings.codec = "gif";
    settings.pixel_format = AV_PIX_FMT_PAL8;
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    return settings;
}

libav::Frame indexed_frame(const OutputPlan& plan) {
    libav::Frame frame = libav::make_frame();
    frame->format = AV_PIX_FMT_PAL8;
    frame->width = plan.width_px;
    frame->height = plan.height_px;
    libav::checked(av_frame_get_buffer(frame.get(), 0), plan.path, "video frame");
    return frame;
}

void set_palette(AVFrame& frame, const std::vector<Rgba8>& palette) {
    auto* entries = reinterpret_cast<std::uint32_t*>(frame.data[1]);
    std::fill_n(entries, AVPALETTE_COUNT, 0xff000000u);
    for (std::size_t i = 0; i < palette.size(); ++i)
        entries[i] = 0xff000000u | static_cast<std::uint32_t>(palette[i].r) << 16 |
                     static_cast<std::uint32_t>(palette[i].g) << 8 | palette[i].b;
    entries[transparent_index] = 0;
}

void take_packets(VideoEncoder& encoder, libav::Muxer& muxer, AVPacket* packet) {
    while (encoder.receive(*packet)) muxer.write(packet, encoder.context().time_base);
}

// Returns frame k of a log, with the film's size.
Image frame_of(FrameEntries& log, const OutputPlan& plan, std::int64_t k) {
    Image frame = decode_png(log.read(k), plan.path.string());
    if (frame.width() != plan.width_px || frame.height() != plan.height_px) log.refuse_entry();
    return frame;
}

// Returns the start of frame k in hundredths of a second, the unit of GIF.
std::int64_t hundredth_of(std::int64_t k, const FrameRate& rate) {
    return (200 * k * rate.denominator + rate.numerator) / (2 * rate.numerator);
}

// Assembles the film from the frames in the log, whose colours have been counted.
void write_gif(FrameEntries& log, const ColourCount& count, const OutputPlan& plan) {
    AtomicFile file(plan.path);
    const std::vector<Rgba8> palette = palette_for(count, transparent_index);
    Ditherer ditherer(palette, transparent_index);
    VideoEncoder encoder(gif_settings(plan), plan.path);
    libav::Muxer muxer("gif", file.descriptor(), plan.path, file.aside());
    libav::checked(avcodec_parameters_from_context(muxer.stream()->codecpar, &encoder.context()),
                   plan.path, "stream parameters");
    muxer.stream()->time_base = encoder.context().time_base;
    libav::Options options;
    // The muxer guesses the duration of the last frame, and FFmpeg 7 guesses differently.
    const std::int64_t n = log.n_entries();
    options.set("final_delay",
                std::to_string(hundredth_of(n, plan.rate) - hundredth_of(n - 1, plan.rate)));
    muxer.write_header(options);
    const libav::Frame frame = indexed_frame(plan);
    const libav::Packet packet = libav::make_packet();
    for (std::int64_t k = 0; k < n; ++k) {
        libav::checked(av_frame_make_writable(frame.get()), plan.path, "video frame");
        set_palette(*frame, palette);
        ditherer.apply(frame_of(log, plan, k), frame->data[0], frame->linesize[0]);
        frame->pts = k;
        encoder.send(*frame);
        take_packets(encoder, muxer, packet.get());
    }
    encoder.send_end();
    take_packets(encoder, muxer, packet.get());
    muxer.write_trailer();
    // A device or a pipe can neither be read again nor changed to add a comment.
    if (!plan.metadata.empty() && !file.aside().empty()) {
        EncodedMetadata encoded{.n_frames = n};
        encoded.packets = gif_packets(contents_of(file), plan.path.string()).of_film();
        append_comment(file, text_of(plan, encoded));
    }
    file.commit();
}

ColourCount colours_of(FrameEntries& log, const OutputPlan& plan) {
    ColourCount count;
    for (std::int64_t k = 0; k < log.n_entries(); ++k) count.add(frame_of(log, plan, k));
    return count;
}

class GifSink : public FrameSink {
 public:
    explicit GifSink(const OutputPlan& plan)
        : plan_(plan),
          log_(plan, "PNG frames of holes and opaque pixels", 1),
          n_kept_(log_.n_entries()),
          count_(plan.part ? ColourCount() : colours_of(log_, plan_)),
          spooler_(PngOptions{.texts = {}, .pixels_per_metre = 0, .deflate_level = 1}) {}

    std::int64_t n_frames_kept() const override { return n_kept_; }

    void write(const Image& frame) override {
        check_frame(frame, plan_);
        // Translucent pixels show their colour on white.
        const bool opaque = is_opaque(frame);
        if (!opaque) flatten_keeping_holes(frame);
        const Image& shown = opaque ? frame : flat_;
        if (!plan_.part) count_.add(shown);
        log_.append(spooler_.encode(shown));
        if (log_.n_entries() == n_kept_ + 1)
            check_free_space(plan_.path, log_.n_bytes(), log_.n_entries(), plan_.n_frames);
    }

    void finish() override {
        check_any_frame(log_.n_entries(), plan_);
        if (plan_.part) return log_.become_part();
        write_gif(log_, count_, plan_);
        log_.discard();
    }

 private:
    void flatten_keeping_holes(const Image& frame) {
        flatten_on_white(frame, flat_);
        for (std::size_t i = 3; i < frame.bytes().size(); i += 4)
            flat_.bytes()[i] = frame.bytes()[i] < hole_below_alpha ? 0 : 255;
    }

    OutputPlan plan_;
    FrameLog log_;  // the frames so far, as PNG files
    std::int64_t n_kept_;
    ColourCount count_;
    PngEncoder spooler_;
    Image flat_;
};

}  // namespace

std::unique_ptr<FrameSink> open_gif(const OutputPlan& plan) {
    check_film(plan);
    if (plan.width_px > 65535 || plan.height_px > 65535)
        throw InputError("a GIF is at most 65535 pixels wide and high");
    silence_libav();
    return std::make_unique<GifSink>(plan);
}

void join_gif(FrameEntries& entries, const OutputPlan& plan) {
    silence_libav();
    write_gif(entries, colours_of(entries, plan), plan);
}

std::int64_t recover_gif(const std::filesystem::path& path, const SealMetadata& seal) {
    silence_libav();
    FrameLog log = FrameLog::left_of(path);
    OutputPlan plan = log.plan();
    plan.seal = seal;
    check_film(plan);
    write_gif(log, colours_of(log, plan), plan);
    log.discard();
    return plan.n_frames;
}

}  // namespace poinsot
