// VP9 in WebM: smaller than H.264, and with transparency. Encoded in independent chunks, like MP4;
// the packets wait in a log until the last frame is written.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "error/error.h"
#include "image/alpha.h"
#include "output/film_packets.h"
#include "output/film_texts.h"
#include "output/formats.h"
#include "output/frame_log.h"
#include "output/quality.h"
#include "output/video_encoder.h"
#include "output/yuv.h"
#include "system/files/atomic_file.h"
#include "system/files/free_space.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// As with x264, the bytes depend on the number of threads.
constexpr int usual_threads = 2;

EncoderSettings vp9_settings(const OutputPlan& plan, bool alpha) {
    const Vp9Effort& effort = quality_named(plan.quality).vp9;
    EncoderSettings settings;
    settings.codec = "libvpx-vp9";
    settings.pixel_format = alpha ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    settings.n_threads = plan.encoder_threads > 0 ? plan.encoder_threads : usual_threads;
    // Frames that are not shown cannot carry alpha.
    settings.options = {{"deadline", effort.deadline},
                        {"cpu-used", effort.speed},
                        {"crf", effort.crf},
                        {"b", "0"},
                        {"row-mt", "1"},
                        {"lag-in-frames", "16"},
                        {"auto-alt-ref", alpha ? "0" : "1"}};
    return settings;
}

// Everything that the packets depend on, besides the plan's size and rate: the settings and the
// library's version.
std::string description_of(const EncoderSettings& settings) {
    std::string text =
        fmt::format("{} {} threads={}", settings.codec, av_version_info(), settings.n_threads);
    for (const auto& [key, value] : settings.options)
        if (std::string_view(key) != "auto-alt-ref") text += fmt::format(" {}={}", key, value);
    return text;
}

// A packet as an entry of the log: whether it is a key frame, the length of its side data (the
// alpha plane's packet, as FFmpeg passes it to Matroska), the side data, and the packet.
constexpr std::size_t entry_head = 5;

void pack(const AVPacket& packet, std::vector<std::uint8_t>& entry) {
    std::size_t n_side_bytes = 0;
    const std::uint8_t* const side_data =
        av_packet_get_side_data(&packet, AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, &n_side_bytes);
    entry.assign({static_cast<std::uint8_t>(packet.flags & AV_PKT_FLAG_KEY)});
    for (int i = 0; i < 4; ++i) entry.push_back(static_cast<std::uint8_t>(n_side_bytes >> 8 * i));
    if (side_data != nullptr) entry.insert(entry.end(), side_data, side_data + n_side_bytes);
    entry.insert(entry.end(), packet.data, packet.data + packet.size);
}

std::size_t n_beside_of(std::span<const std::uint8_t> entry) {
    std::size_t n_side_bytes = 0;
    for (std::size_t i = 0; i < 4; ++i) n_side_bytes |= std::size_t{entry[i + 1]} << 8 * i;
    return n_side_bytes;
}

// Returns entry k of a log after checking its head.
std::span<const std::uint8_t> entry_of(FrameEntries& log, std::int64_t k) {
    const auto entry = log.read(k);
    if (entry.size() < entry_head || n_beside_of(entry) > entry.size() - entry_head)
        log.refuse_entry();
    return entry;
}

void unpack(std::span<const std::uint8_t> entry, AVPacket& packet, const fs::path& path) {
    const std::size_t n_side_bytes = n_beside_of(entry);
    const auto data = entry.subspan(entry_head + n_side_bytes);
    libav::checked(av_new_packet(&packet, static_cast<int>(data.size())), path, "packet");
    std::copy(data.begin(), data.end(), packet.data);
    packet.flags |= entry[0] & AV_PKT_FLAG_KEY;
    if (n_side_bytes == 0) return;
    std::uint8_t* const side_data =
        av_packet_new_side_data(&packet, AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, n_side_bytes);
    if (side_data == nullptr) throw EnvironmentError("no memory for a video packet");
    std::copy_n(entry.data() + entry_head, n_side_bytes, side_data);
}

bool has_alpha(FrameEntries& log) {
    return log.n_entries() > 0 && n_beside_of(entry_of(log, 0)) > 0;
}

void describe_stream(AVStream& stream, const OutputPlan& plan, bool alpha) {
    AVCodecParameters& parameters = *stream.codecpar;
    parameters.codec_type = AVMEDIA_TYPE_VIDEO;
    parameters.codec_id = AV_CODEC_ID_VP9;
    parameters.format = alpha ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
    parameters.width = plan.width_px;
    parameters.height = plan.height_px;
    parameters.sample_aspect_ratio = {1, 1};
    parameters.field_order = AV_FIELD_PROGRESSIVE;
    parameters.color_range = AVCOL_RANGE_MPEG;
    parameters.color_space = AVCOL_SPC_BT709;
    parameters.color_primaries = AVCOL_PRI_BT709;
    parameters.color_trc = AVCOL_TRC_BT709;
    parameters.chroma_location = AVCHROMA_LOC_LEFT;
    stream.time_base = av_inv_q(as_rational(plan.rate));
    stream.avg_frame_rate = as_rational(plan.rate);
    if (alpha) av_dict_set(&stream.metadata, "alpha_mode", "1", 0);
}

std::string text_of_film(FrameEntries& log, const OutputPlan& plan, std::int64_t n_frames) {
    PacketHash hash(frames_a_chunk);
    for (std::int64_t k = 0; k < n_frames; ++k) {
        const auto entry = entry_of(log, k);
        const std::size_t n_side_bytes = n_beside_of(entry);
        hash.add(entry.subspan(entry_head + n_side_bytes), entry.subspan(entry_head, n_side_bytes));
    }
    return text_of(plan, {.n_frames = n_frames, .packets = hash.of_film()});
}

// Assembles the film from the first entries of the log. VP9's packets are in order of display.
void write_webm(FrameEntries& log, const OutputPlan& plan, std::int64_t n_frames) {
    const std::string text = text_of_film(log, plan, n_frames);
    AtomicFile file(plan.path);
    libav::Muxer muxer("webm", file.descriptor(), plan.path, file.aside());
    describe_stream(*muxer.stream(), plan, has_alpha(log));
    av_dict_set(&muxer.context()->metadata, "poinsot", text.c_str(), 0);
    add_chapters(*muxer.context(), first_chapters(plan.chapters, n_frames), plan.rate);
    SubtitleTrack subtitles(muxer, AV_CODEC_ID_WEBVTT, plan, n_frames);
    libav::Options options;
    // With the index at the front, players can seek while they load.
    options.set("cues_to_front", "1");
    muxer.write_header(options);
    const libav::Packet packet = libav::make_packet();
    for (std::int64_t k = 0; k < n_frames; ++k) {
        subtitles.write_before(k + 1);
        unpack(entry_of(log, k), *packet, plan.path);
        packet->pts = packet->dts = k;
        packet->duration = 1;
        muxer.write(packet.get(), av_inv_q(as_rational(plan.rate)));
    }
    muxer.write_trailer();
    file.commit();
}

// The film's first frame determines whether the film carries alpha; a later part receives this from
// its plan.
class WebmSink : public FrameSink {
 public:
    explicit WebmSink(const OutputPlan& plan)
        : plan_(plan),
          converter_(plan.width_px),
          packet_(libav::make_packet()),
          log_(plan, description_of(vp9_settings(plan, false)), frames_a_chunk),
          n_before_(plan.part ? plan.part->n_before : 0),
          n_kept_(log_.n_entries()),
          alpha_(has_alpha(log_)),
          n_written_(n_kept_) {}

    std::int64_t n_frames_kept() const override { return n_kept_; }

    void write(const Image& frame) override {
        write_telling(frame, [] {});
    }

    void write_telling(const Image& frame, const WasRead& was_read) override {
        check_frame(frame, plan_);
        if (n_written_ == 0) alpha_ = plan_.has_alpha.value_or(!is_opaque(frame));
        if (n_written_ % frames_a_chunk == 0) end_chunk();
        if (!encoder_) start_chunk();
        libav::checked(av_frame_make_writable(frame_.get()), plan_.path, "video frame");
        const bool flattened = !alpha_ && !is_opaque(frame);
        if (flattened) flatten_on_white(frame, flat_);
        converter_.convert(flattened ? flat_ : frame,
                           {frame_->data[0], frame_->data[1], frame_->data[2], frame_->linesize[0],
                            frame_->linesize[1], frame_->linesize[2]});
        if (alpha_) copy_alpha(frame, frame_->data[3], frame_->linesize[3]);
        was_read();
        frame_->pts = n_before_ + n_written_++;
        encoder_->send(*frame_);
        take_packets();
    }

    void finish() override {
        check_any_frame(n_written_, plan_);
        end_chunk();
        if (plan_.part) return log_.become_part();
        write_webm(log_, plan_, n_shown_of(plan_, log_.n_entries()));
        log_.discard();
    }

 private:
    void start_chunk() {
        encoder_.emplace(vp9_settings(plan_, alpha_), plan_.path);
        if (!frame_)
            frame_ = make_yuv_frame(alpha_ ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P,
                                    plan_.width_px, plan_.height_px);
    }

    void end_chunk() {
        if (!encoder_) return;
        encoder_->send_end();
        take_packets();
        encoder_.reset();
        if (log_.n_entries() != n_written_)
            throw EnvironmentError(fmt::format("cannot write {}: the encoder has dropped a frame",
                                               plan_.path.string()));
        check_free_space(plan_.path, log_.n_bytes(), n_written_, plan_.n_frames);
    }

    void take_packets() {
        while (encoder_->receive(*packet_)) {
            pack(*packet_, entry_);
            log_.append(entry_);
        }
    }

    OutputPlan plan_;
    YuvConverter converter_;
    libav::Packet packet_;
    FrameLog log_;
    std::int64_t n_before_;  // frames of the film before the first one written here
    std::int64_t n_kept_;
    bool alpha_;
    std::int64_t n_written_;
    libav::Frame frame_;
    std::optional<VideoEncoder> encoder_;
    std::vector<std::uint8_t> entry_;
    Image flat_;
};

}  // namespace

std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan) {
    check_film(plan);
    quality_named(plan.quality);
    silence_libav();
    return std::make_unique<WebmSink>(plan);
}

void join_webm(FrameEntries& entries, const OutputPlan& plan) {
    silence_libav();
    write_webm(entries, plan, entries.n_entries());
}

std::int64_t recover_webm(const fs::path& path, const Tell& tell) {
    silence_libav();
    FrameLog log = FrameLog::left_of(path);
    OutputPlan plan = log.plan();
    plan.tell = tell;
    check_film(plan);
    write_webm(log, plan, plan.n_frames);
    log.discard();
    return plan.n_frames;
}

}  // namespace poinsot
