// H.264 in MP4, encoded in independent chunks, so that a film that is interrupted and resumed at
// the end of a chunk is byte-identical to an uninterrupted one. The packets wait in a log until the
// last frame is written.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
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
using Bytes = std::vector<std::uint8_t>;

// x264's output depends on the number of threads, so this number must not depend on the machine.
constexpr int usual_threads = 3;

// `alone`: for a frame in a chunk of its own. mbtree would lower the quality of a frame that no
// later frame refers to. The film stops at this frame, so its quality matters most.
EncoderSettings x264_settings(const OutputPlan& plan, bool alone = false) {
    const X264Effort& effort = quality_named(plan.quality).x264;
    EncoderSettings settings;
    settings.codec = "libx264";
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    settings.n_threads = plan.encoder_threads > 0 ? plan.encoder_threads : usual_threads;
    settings.header_in_container = true;
    settings.options = {{"preset", effort.preset},
                        {"crf", effort.crf},
                        {"x264-params", fmt::format("cpu-independent=1:{}{}", effort.parameters,
                                                    alone ? ":mbtree=0" : "")}};
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

// Everything that the packets depend on, besides the frames; the parameter sets, which contain the
// encoder's version, come last.
constexpr std::string_view header_key = " header=";

std::string description_of(const EncoderSettings& settings, const AVCodecContext& encoder,
                           bool ends_alone) {
    std::string text = fmt::format("{} threads={}", settings.codec, settings.n_threads);
    if (ends_alone) text += " ends-alone";
    for (const auto& [key, value] : settings.options) text += fmt::format(" {}={}", key, value);
    text += header_key;
    for (int i = 0; i < encoder.extradata_size; ++i)
        text += fmt::format("{:02x}", encoder.extradata[i]);
    return text;
}

Bytes header_of(std::string_view description) {
    const std::size_t at = description.rfind(header_key);
    Bytes header;
    if (at == std::string_view::npos) return header;
    for (std::string_view digits = description.substr(at + header_key.size()); digits.size() >= 2;
         digits.remove_prefix(2)) {
        std::uint8_t byte = 0;
        std::from_chars(digits.data(), digits.data() + 2, byte, 16);
        header.push_back(byte);
    }
    return header;
}

// Each unit is preceded by its length in MP4, and by a start code in an encoder's packets, which a
// muxer opened for MP4 expects. Source: ISO/IEC 14496-15 §5.3.3; Rec. ITU-T H.264 Annex B.
void append_with_lengths(std::span<const std::uint8_t> packet, Bytes& out) {
    constexpr std::array<std::uint8_t, 3> start_code{0, 0, 1};
    const auto next = [&](auto from) {
        return std::search(from, packet.end(), start_code.begin(), start_code.end());
    };
    for (auto at = next(packet.begin()); at != packet.end();) {
        const auto begin = at + start_code.size();
        at = next(begin);
        // A unit ends with a set bit; zeros after it belong to the next start code.
        auto end = at;
        while (end != begin && *(end - 1) == 0) --end;
        const auto length = static_cast<std::uint32_t>(end - begin);
        for (int shift = 24; shift >= 0; shift -= 8)
            out.push_back(static_cast<std::uint8_t>(length >> shift));
        out.insert(out.end(), begin, end);
    }
}

void put_start_codes(std::span<std::uint8_t> rest) {
    while (rest.size() >= 4) {
        std::size_t length = 0;
        for (const std::uint8_t byte : rest.first(4)) length = length << 8 | byte;
        std::copy_n("\0\0\0\1", 4, rest.begin());
        rest = rest.subspan(std::min(rest.size(), 4 + length));
    }
}

// A packet as an entry of the log: whether it is a key frame, its display and decoding times in
// frames, and its units with their lengths, as in the film.
constexpr std::size_t entry_head = 17;

void append_time(std::int64_t time, Bytes& out) {
    for (int i = 0; i < 8; ++i)
        out.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(time) >> 8 * i));
}

std::int64_t time_at(std::span<const std::uint8_t> entry, std::size_t at) {
    std::uint64_t time = 0;
    for (std::size_t i = 0; i < 8; ++i) time |= std::uint64_t{entry[at + i]} << 8 * i;
    return static_cast<std::int64_t>(time);
}

std::int64_t shown_at(std::span<const std::uint8_t> entry) { return time_at(entry, 1); }

void pack(const AVPacket& packet, Bytes& entry) {
    entry.assign({static_cast<std::uint8_t>(packet.flags & AV_PKT_FLAG_KEY)});
    append_time(packet.pts, entry);
    append_time(packet.dts, entry);
    append_with_lengths({packet.data, static_cast<std::size_t>(packet.size)}, entry);
}

void unpack(std::span<const std::uint8_t> entry, AVPacket& packet, const fs::path& path) {
    const auto units = entry.subspan(entry_head);
    libav::checked(av_new_packet(&packet, static_cast<int>(units.size())), path, "packet");
    std::copy(units.begin(), units.end(), packet.data);
    put_start_codes({packet.data, units.size()});
    packet.flags |= entry[0] & AV_PKT_FLAG_KEY;
    packet.pts = shown_at(entry);
    packet.dts = time_at(entry, 9);
    packet.duration = 1;
}

// Returns entry k of a log after checking that it has a head.
std::span<const std::uint8_t> entry_of(FrameEntries& log, std::int64_t k) {
    const auto entry = log.read(k);
    if (entry.size() < entry_head) log.refuse_entry();
    return entry;
}

// Returns the largest n for which the first n packets show exactly the frames 0 … n−1.
std::int64_t n_frames_without_gap(FrameLog& log) {
    std::int64_t last_shown = -1, n_whole = 0;
    for (std::int64_t k = 0; k < log.n_entries(); ++k) {
        last_shown = std::max(last_shown, shown_at(entry_of(log, k)));
        if (last_shown == k) n_whole = k + 1;
    }
    return n_whole;
}

void describe_stream(AVStream& stream, const OutputPlan& plan, const Bytes& header) {
    AVCodecParameters& parameters = *stream.codecpar;
    parameters.codec_type = AVMEDIA_TYPE_VIDEO;
    parameters.codec_id = AV_CODEC_ID_H264;
    parameters.format = AV_PIX_FMT_YUV420P;
    parameters.width = plan.width_px;
    parameters.height = plan.height_px;
    parameters.field_order = AV_FIELD_PROGRESSIVE;
    parameters.color_range = AVCOL_RANGE_MPEG;
    parameters.color_space = AVCOL_SPC_BT709;
    parameters.color_primaries = AVCOL_PRI_BT709;
    parameters.color_trc = AVCOL_TRC_BT709;
    parameters.chroma_location = AVCHROMA_LOC_LEFT;
    // FFmpeg frees the memory owned by the parameters.
    parameters.extradata =
        static_cast<std::uint8_t*>(av_mallocz(header.size() + AV_INPUT_BUFFER_PADDING_SIZE));
    if (parameters.extradata == nullptr) throw EnvironmentError("no memory for a film");
    std::copy(header.begin(), header.end(), parameters.extradata);
    parameters.extradata_size = static_cast<int>(header.size());
    stream.time_base = av_inv_q(as_rational(plan.rate));
    stream.avg_frame_rate = as_rational(plan.rate);
}

Contents contents_of_mp4(FrameEntries& log, std::int64_t n_frames) {
    PacketHash hash(frames_a_chunk);
    for (std::int64_t k = 0; k < n_frames; ++k) hash.add(entry_of(log, k).subspan(entry_head));
    return {.n_frames = n_frames, .packets = hash.of_film()};
}

// Assembles the film from the first entries of the log, with its index at the front.
void write_mp4(FrameEntries& log, const OutputPlan& plan, std::int64_t n_frames) {
    const Contents contents = contents_of_mp4(log, n_frames);
    const std::string record = record_before_hash(plan, contents);
    AtomicFile file(plan.path);
    libav::Muxer muxer("mp4", file.descriptor(), plan.path, file.aside());
    describe_stream(*muxer.stream(), plan, header_of(log.settings()));
    set_language(muxer, *muxer.stream(), plan);
    av_dict_set(&muxer.context()->metadata, "poinsot", record.c_str(), 0);
    add_chapters(*muxer.context(), first_chapters(plan.chapters, n_frames), plan.rate);
    SubtitleTrack subtitles(muxer, AV_CODEC_ID_MOV_TEXT, plan, n_frames);
    libav::Options options;
    options.set("movflags", "faststart+use_metadata_tags");
    muxer.write_header(options);
    const libav::Packet packet = libav::make_packet();
    for (std::int64_t k = 0; k < n_frames; ++k) {
        subtitles.write_before(k + 1);
        unpack(entry_of(log, k), *packet, plan.path);
        muxer.write(packet.get(), av_inv_q(as_rational(plan.rate)));
    }
    muxer.write_trailer();
    put_file_hash(file, plan, contents);
    file.commit();
}

class Mp4Sink : public FrameSink {
 public:
    explicit Mp4Sink(const OutputPlan& plan)
        : plan_(plan),
          settings_(x264_settings(plan)),
          converter_(plan.width_px),
          frame_(make_yuv_frame(AV_PIX_FMT_YUV420P, plan.width_px, plan.height_px)),
          packet_(libav::make_packet()),
          encoder_(std::make_unique<VideoEncoder>(settings_, plan.path)),
          log_(plan, description_of(settings_, encoder_->context(), plan.ends_alone),
               frames_a_chunk),
          n_before_(plan.part ? plan.part->n_before : 0),
          last_frame_((plan.part ? plan.part->n_film_frames : plan.n_frames) - 1),
          n_reordered_(encoder_->context().has_b_frames),
          n_kept_(log_.n_entries()),
          n_written_(n_kept_) {}

    std::int64_t n_frames_kept() const override { return n_kept_; }

    void write(const Image& frame) override {
        write_telling(frame, [] {});
    }

    void write_telling(const Image& frame, const WasRead& was_read) override {
        check_frame(frame, plan_);
        const std::int64_t number = n_before_ + n_written_;
        if (starts_chunk(number) && (n_in_chunk_ > 0 || is_alone(number))) start_chunk(number);
        libav::checked(av_frame_make_writable(frame_.get()), plan_.path, "video frame");
        const bool opaque = is_opaque(frame);
        if (!opaque) flatten_on_white(frame, flat_);
        converter_.convert(opaque ? frame : flat_,
                           {frame_->data[0], frame_->data[1], frame_->data[2], frame_->linesize[0],
                            frame_->linesize[1], frame_->linesize[2]});
        was_read();
        frame_->pts = n_before_ + n_written_++;
        ++n_in_chunk_;
        encoder_->send(*frame_);
        take_packets();
    }

    void finish() override {
        check_any_frame(n_written_, plan_);
        end_chunk();
        if (plan_.part) return log_.become_part();
        write_mp4(log_, plan_, n_shown_of(plan_, n_written_));
        log_.discard();
    }

 private:
    bool is_alone(std::int64_t frame) const {
        return plan_.ends_alone && (frame == 0 || frame == last_frame_);
    }
    bool starts_chunk(std::int64_t frame) const {
        return frame % frames_a_chunk == 0 || is_alone(frame) || (frame > 0 && is_alone(frame - 1));
    }

    void start_chunk(std::int64_t frame) {
        if (n_in_chunk_ > 0) end_chunk();
        encoder_.reset();  // first, so that two never coexist
        encoder_ = std::make_unique<VideoEncoder>(
            is_alone(frame) ? x264_settings(plan_, true) : settings_, plan_.path);
        n_in_chunk_ = 0;
        check_free_space(plan_.path, log_.n_bytes(), n_written_, plan_.n_frames);
    }

    void end_chunk() {
        encoder_->send_end();
        take_packets();
        if (log_.n_entries() != n_written_)
            throw EnvironmentError(fmt::format("cannot write {}: the encoder has dropped a frame",
                                               plan_.path.string()));
    }

    void take_packets() {
        while (encoder_->receive(*packet_)) {
            // A short chunk ends before the encoder knows how far its frames are reordered.
            if (plan_.ends_alone) packet_->dts = n_before_ + log_.n_entries() - n_reordered_;
            pack(*packet_, entry_);
            log_.append(entry_);
        }
    }

    OutputPlan plan_;
    EncoderSettings settings_;
    YuvConverter converter_;
    libav::Frame frame_;
    libav::Packet packet_;
    Image flat_;
    std::unique_ptr<VideoEncoder> encoder_;
    FrameLog log_;
    std::int64_t n_before_;  // frames of the film before the first one written here
    std::int64_t last_frame_;
    int n_reordered_;  // frames by which decoding runs ahead of showing
    std::int64_t n_kept_;
    std::int64_t n_written_;
    Bytes entry_;
    std::int64_t n_in_chunk_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan) {
    check_mp4(plan);
    silence_libav();
    return std::make_unique<Mp4Sink>(plan);
}

void join_mp4(FrameEntries& entries, const OutputPlan& plan) {
    silence_libav();
    write_mp4(entries, plan, entries.n_entries());
}

std::int64_t recover_mp4(const fs::path& path, const Tell& tell) {
    silence_libav();
    FrameLog log = FrameLog::left_of(path);
    OutputPlan plan = log.plan();
    plan.tell = tell;
    check_mp4(plan);
    const std::int64_t n_frames = n_frames_without_gap(log);
    if (n_frames == 0)
        throw InputError(fmt::format("no frame of {} had been finished", path.string()));
    write_mp4(log, plan, n_frames);
    log.discard();
    return n_frames;
}

}  // namespace poinsot
