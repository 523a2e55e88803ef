// Films with transparency: VP9 in WebM, smaller than H.264, and ProRes 4444 in QuickTime, for video
// editors. Encoded in independent chunks, like MP4; the packets, which are in order of display,
// wait in a log until the last frame is written.
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
#include "output/film_file_hash.h"
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

// As with x264, the bytes of VP9 depend on the number of threads.
constexpr int usual_threads = 2;

// What the formats of this file differ in.
struct AlphaFormat {
    const char* container;
    AVCodecID codec, subtitles;
    std::uint32_t codec_tag;  // 0: the container's own
    // Whether each film has an alpha plane, opaque or not; otherwise its first frame determines it.
    bool always_alpha;
    // The container's option that writes the index at the front, so that players can seek while
    // they load.
    const char *option, *value;
    void (*set_up)(EncoderSettings& settings, const OutputPlan& plan, bool alpha);
};

void set_up_vp9(EncoderSettings& settings, const OutputPlan& plan, bool alpha) {
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
void set_up_prores(EncoderSettings& settings, const OutputPlan&, bool) {
    settings.codec = "prores_ks";
    settings.pixel_format = AV_PIX_FMT_YUVA444P10LE;
    settings.options = {{"profile", "4444"},
                        {"global_quality", std::to_string(FF_QP2LAMBDA)},
                        {"alpha_bits", "8"},
                        {"vendor", "apl0"}};
}

constexpr AlphaFormat webm{.container = "webm",
                           .codec = AV_CODEC_ID_VP9,
                           .subtitles = AV_CODEC_ID_WEBVTT,
                           .codec_tag = 0,
                           .always_alpha = false,
                           .option = "cues_to_front",
                           .value = "1",
                           .set_up = set_up_vp9};
constexpr AlphaFormat mov{.container = "mov",
                          .codec = AV_CODEC_ID_PRORES,
                          .subtitles = AV_CODEC_ID_MOV_TEXT,
                          .codec_tag = MKTAG('a', 'p', '4', 'h'),
                          .always_alpha = true,
                          .option = "movflags",
                          .value = "faststart+use_metadata_tags",
                          .set_up = set_up_prores};

EncoderSettings settings_of(const AlphaFormat& format, const OutputPlan& plan, bool alpha) {
    EncoderSettings settings;
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    settings.n_threads = plan.encoder_threads > 0 ? plan.encoder_threads : usual_threads;
    format.set_up(settings, plan, alpha);
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

bool has_alpha(const AlphaFormat& format, FrameEntries& log) {
    return format.always_alpha || (log.n_entries() > 0 && n_beside_of(entry_of(log, 0)) > 0);
}

void describe_stream(AVStream& stream, const AlphaFormat& format, const OutputPlan& plan,
                     bool alpha) {
    AVCodecParameters& parameters = *stream.codecpar;
    parameters.codec_type = AVMEDIA_TYPE_VIDEO;
    parameters.codec_id = format.codec;
    parameters.codec_tag = format.codec_tag;
    parameters.format = settings_of(format, plan, alpha).pixel_format;
    // QuickTime's depth, by which editors find the alpha plane.
    if (alpha) parameters.bits_per_coded_sample = 32;
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
    if (alpha && format.codec == AV_CODEC_ID_VP9)
        av_dict_set(&stream.metadata, "alpha_mode", "1", 0);
}

Contents contents_of_film(FrameEntries& log, std::int64_t n_frames) {
    PacketHash hash(frames_a_chunk);
    for (std::int64_t k = 0; k < n_frames; ++k) {
        const auto entry = entry_of(log, k);
        const std::size_t n_side_bytes = n_beside_of(entry);
        hash.add(entry.subspan(entry_head + n_side_bytes), entry.subspan(entry_head, n_side_bytes));
    }
    return {.n_frames = n_frames, .packets = hash.of_film()};
}

// Assembles the film from the first entries of the log.
void write_film(const AlphaFormat& format, FrameEntries& log, const OutputPlan& plan,
                std::int64_t n_frames) {
    const Contents contents = contents_of_film(log, n_frames);
    const std::string record = record_before_hash(plan, contents);
    AtomicFile file(plan.path);
    libav::Muxer muxer(format.container, file.descriptor(), plan.path, file.aside());
    describe_stream(*muxer.stream(), format, plan, has_alpha(format, log));
    set_language(muxer, *muxer.stream(), plan);
    av_dict_set(&muxer.context()->metadata, "poinsot", record.c_str(), 0);
    add_chapters(*muxer.context(), first_chapters(plan.chapters, n_frames), plan.rate);
    SubtitleTrack subtitles(muxer, format.subtitles, plan, n_frames);
    libav::Options options;
    options.set(format.option, format.value);
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
    put_file_hash(file, plan, contents);
    file.commit();
}

// If the film's first frame determines whether the film has alpha, a later part receives this from
// its plan.
class AlphaFilmSink : public FrameSink {
 public:
    AlphaFilmSink(const AlphaFormat& format, const OutputPlan& plan)
        : format_(&format),
          plan_(plan),
          converter_(plan.width_px),
          packet_(libav::make_packet()),
          log_(plan, description_of(settings_of(format, plan, false)), frames_a_chunk),
          n_before_(plan.part ? plan.part->n_before : 0),
          n_kept_(log_.n_entries()),
          alpha_(has_alpha(format, log_)),
          n_written_(n_kept_) {}

    std::int64_t n_frames_kept() const override { return n_kept_; }

    void write(const Image& frame) override {
        write_telling(frame, [] {});
    }

    void write_telling(const Image& frame, const WasRead& was_read) override {
        check_frame(frame, plan_);
        if (n_written_ == 0 && !format_->always_alpha)
            alpha_ = plan_.has_alpha.value_or(!is_opaque(frame));
        if (n_written_ % frames_a_chunk == 0) end_chunk();
        if (!encoder_) start_chunk();
        libav::checked(av_frame_make_writable(frame_.get()), plan_.path, "video frame");
        fill_frame(frame);
        was_read();
        frame_->pts = n_before_ + n_written_++;
        encoder_->send(*frame_);
        take_packets();
    }

    void finish() override {
        check_any_frame(n_written_, plan_);
        end_chunk();
        if (plan_.part) return log_.become_part();
        write_film(*format_, log_, plan_, n_shown_of(plan_, log_.n_entries()));
        log_.discard();
    }

 private:
    void start_chunk() {
        const EncoderSettings settings = settings_of(*format_, plan_, alpha_);
        encoder_.emplace(settings, plan_.path);
        if (!frame_)
            frame_ = make_yuv_frame(settings.pixel_format, plan_.width_px, plan_.height_px);
    }

    void fill_frame(const Image& picture) {
        std::uint8_t* const* planes = frame_->data;
        const int* strides = frame_->linesize;
        if (frame_->format == AV_PIX_FMT_YUVA444P10LE) {
            convert_to_10_bits(picture, {planes[0], planes[1], planes[2], planes[3]},
                               {strides[0], strides[1], strides[2], strides[3]});
            return;
        }
        const bool flattened = !alpha_ && !is_opaque(picture);
        if (flattened) flatten_on_white(picture, flat_);
        converter_.convert(flattened ? flat_ : picture,
                           {planes[0], planes[1], planes[2], strides[0], strides[1], strides[2]});
        if (alpha_) copy_alpha(picture, planes[3], strides[3]);
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

    const AlphaFormat* format_;
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

std::unique_ptr<FrameSink> open_film(const AlphaFormat& format, const OutputPlan& plan) {
    check_film(plan);
    quality_named(plan.quality);
    silence_libav();
    return std::make_unique<AlphaFilmSink>(format, plan);
}

void join_film(const AlphaFormat& format, FrameEntries& entries, const OutputPlan& plan) {
    silence_libav();
    write_film(format, entries, plan, entries.n_entries());
}

std::int64_t recover(const AlphaFormat& format, const fs::path& path, const Tell& tell) {
    silence_libav();
    FrameLog log = FrameLog::left_of(path);
    OutputPlan plan = log.plan();
    plan.tell = tell;
    check_film(plan);
    write_film(format, log, plan, plan.n_frames);
    log.discard();
    return plan.n_frames;
}

}  // namespace

std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan) { return open_film(webm, plan); }
std::unique_ptr<FrameSink> open_mov(const OutputPlan& plan) { return open_film(mov, plan); }

void join_webm(FrameEntries& entries, const OutputPlan& plan) { join_film(webm, entries, plan); }
void join_mov(FrameEntries& entries, const OutputPlan& plan) { join_film(mov, entries, plan); }

std::int64_t recover_webm(const fs::path& path, const Tell& tell) {
    return recover(webm, path, tell);
}
std::int64_t recover_mov(const fs::path& path, const Tell& tell) {
    return recover(mov, path, tell);
}

}  // namespace poinsot
