// Films of packets in a container: MP4, WebM and QuickTime. They are encoded in independent chunks,
// so that a film that is interrupted and resumed at the end of a chunk is byte-identical to an
// uninterrupted one. The packets wait in a log until the last frame is written.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "encoding/film_file_hash.h"
#include "encoding/film_packets.h"
#include "encoding/film_texts.h"
#include "encoding/formats.h"
#include "encoding/quality.h"
#include "encoding/yuv.h"
#include "error/error.h"
#include "image/alpha.h"
#include "system/files/atomic_file.h"
#include "system/files/free_space.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;
using Entry = std::span<const std::uint8_t>;

EncoderSettings settings_of(const PacketFilm& format, const OutputPlan& plan, bool alpha,
                            bool alone = false) {
    EncoderSettings settings;
    settings.width_px = plan.width_px;
    settings.height_px = plan.height_px;
    settings.rate = plan.rate;
    settings.n_threads = plan.encoder_threads > 0 ? plan.encoder_threads : format.n_threads;
    format.set_up(settings, plan, alpha, alone);
    return settings;
}

void check_plan(const PacketFilm& format, const OutputPlan& plan) {
    check_film(plan);
    quality_named(plan.quality);
    if (format.needs_even_size && (plan.width_px % 2 != 0 || plan.height_px % 2 != 0))
        throw InputError(fmt::format(
            "an MP4 film needs an even width and height, and {}×{} is not; take {}×{}, or write "
            "PNG frames or WebM",
            plan.width_px, plan.height_px, plan.width_px + plan.width_px % 2,
            plan.height_px + plan.height_px % 2));
}

// Everything that the packets depend on, besides the frames and the plan's size and rate; the
// encoder's header, which the container stores, comes last. The option auto-alt-ref depends on the
// frames alone.
constexpr std::string_view header_key = " header=";

std::string description_of(const EncoderSettings& settings, const OutputPlan& plan, Entry header) {
    std::string text =
        fmt::format("{} {} threads={}", settings.codec, av_version_info(), settings.n_threads);
    if (plan.ends_alone) text += " ends-alone";
    for (const auto& [key, value] : settings.options)
        if (std::string_view(key) != "auto-alt-ref") text += fmt::format(" {}={}", key, value);
    text += header_key;
    for (const std::uint8_t byte : header) text += fmt::format("{:02x}", byte);
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

// A packet as an entry of the log: whether it is a key frame, its display and decoding times in
// frames, the length of its side data (the alpha plane's packet, as FFmpeg passes it to Matroska),
// the side data, and the packet as in the film.
constexpr std::size_t shown_at = 1, decoded_at = 9, n_side_at = 17, entry_head = 25;

void append_number(std::int64_t number, Bytes& out) {
    for (int i = 0; i < 8; ++i)
        out.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> 8 * i));
}

std::int64_t number_at(Entry entry, std::size_t at) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < 8; ++i) number |= std::uint64_t{entry[at + i]} << 8 * i;
    return static_cast<std::int64_t>(number);
}

void pack(const PacketFilm& format, const AVPacket& packet, Bytes& entry) {
    std::size_t n_side_bytes = 0;
    const std::uint8_t* const side_data =
        av_packet_get_side_data(&packet, AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, &n_side_bytes);
    entry.assign({static_cast<std::uint8_t>(packet.flags & AV_PKT_FLAG_KEY)});
    append_number(packet.pts, entry);
    append_number(packet.dts, entry);
    append_number(static_cast<std::int64_t>(n_side_bytes), entry);
    if (side_data != nullptr) entry.insert(entry.end(), side_data, side_data + n_side_bytes);
    const Entry data{packet.data, static_cast<std::size_t>(packet.size)};
    if (format.pack != nullptr)
        format.pack(data, entry);
    else
        entry.insert(entry.end(), data.begin(), data.end());
}

Entry side_of(Entry entry) {
    return entry.subspan(entry_head, static_cast<std::size_t>(number_at(entry, n_side_at)));
}
Entry data_of(Entry entry) { return entry.subspan(entry_head + side_of(entry).size()); }

// Returns entry k of a log after checking its head.
Entry entry_of(FrameEntries& log, std::int64_t k) {
    const Entry entry = log.read(k);
    if (entry.size() < entry_head ||
        static_cast<std::uint64_t>(number_at(entry, n_side_at)) > entry.size() - entry_head)
        log.refuse_entry();
    return entry;
}

void unpack(const PacketFilm& format, Entry entry, AVPacket& packet, const fs::path& path) {
    const Entry data = data_of(entry), side = side_of(entry);
    libav::checked(av_new_packet(&packet, static_cast<int>(data.size())), path, "packet");
    std::copy(data.begin(), data.end(), packet.data);
    if (format.unpack != nullptr) format.unpack({packet.data, data.size()});
    packet.flags |= entry[0] & AV_PKT_FLAG_KEY;
    packet.pts = number_at(entry, shown_at);
    packet.dts = number_at(entry, decoded_at);
    packet.duration = 1;
    if (side.empty()) return;
    std::uint8_t* const side_data =
        av_packet_new_side_data(&packet, AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, side.size());
    if (side_data == nullptr) throw EnvironmentError("no memory for a video packet");
    std::copy(side.begin(), side.end(), side_data);
}

// Returns the largest n for which the first n packets show exactly the frames 0 … n−1.
std::int64_t n_frames_without_gap(FrameLog& log) {
    std::int64_t last_shown = -1, n_whole = 0;
    for (std::int64_t k = 0; k < log.n_entries(); ++k) {
        last_shown = std::max(last_shown, number_at(entry_of(log, k), shown_at));
        if (last_shown == k) n_whole = k + 1;
    }
    return n_whole;
}

bool has_alpha(const PacketFilm& format, FrameEntries& log) {
    return format.alpha == FilmAlpha::always ||
           (log.n_entries() > 0 && !side_of(entry_of(log, 0)).empty());
}

void describe_stream(AVStream& stream, const PacketFilm& format, const OutputPlan& plan, bool alpha,
                     const Bytes& header) {
    AVCodecParameters& parameters = *stream.codecpar;
    parameters.codec_type = AVMEDIA_TYPE_VIDEO;
    parameters.codec_id = format.codec;
    parameters.codec_tag = format.codec_tag;
    parameters.format = settings_of(format, plan, alpha).pixel_format;
    // QuickTime's depth, by which editors find the alpha plane.
    if (alpha) parameters.bits_per_coded_sample = 32;
    parameters.width = plan.width_px;
    parameters.height = plan.height_px;
    if (format.states_square_pixels) parameters.sample_aspect_ratio = {1, 1};
    parameters.field_order = AV_FIELD_PROGRESSIVE;
    parameters.color_range = AVCOL_RANGE_MPEG;
    parameters.color_space = AVCOL_SPC_BT709;
    parameters.color_primaries = AVCOL_PRI_BT709;
    parameters.color_trc = AVCOL_TRC_BT709;
    parameters.chroma_location = AVCHROMA_LOC_LEFT;
    if (!header.empty()) {
        // FFmpeg frees the memory owned by the parameters.
        parameters.extradata =
            static_cast<std::uint8_t*>(av_mallocz(header.size() + AV_INPUT_BUFFER_PADDING_SIZE));
        if (parameters.extradata == nullptr) throw EnvironmentError("no memory for a film");
        std::copy(header.begin(), header.end(), parameters.extradata);
        parameters.extradata_size = static_cast<int>(header.size());
    }
    stream.time_base = av_inv_q(as_rational(plan.rate));
    stream.avg_frame_rate = as_rational(plan.rate);
    if (alpha && format.codec == AV_CODEC_ID_VP9)
        av_dict_set(&stream.metadata, "alpha_mode", "1", 0);
}

EncodedMetadata metadata_of(FrameEntries& log, std::int64_t n_frames) {
    PacketHash hash(frames_a_chunk);
    for (std::int64_t k = 0; k < n_frames; ++k) {
        const Entry entry = entry_of(log, k);
        hash.add(data_of(entry), side_of(entry));
    }
    return {.n_frames = n_frames, .packets = hash.of_film()};
}

// Assembles the film from the first entries of the log, with its index at the front.
void write_film(const PacketFilm& format, FrameEntries& log, const OutputPlan& plan,
                std::int64_t n_frames) {
    const EncodedMetadata encoded = metadata_of(log, n_frames);
    const std::string record = record_before_hash(plan, encoded);
    AtomicFile file(plan.path);
    libav::Muxer muxer(format.container, file.descriptor(), plan.path, file.aside());
    describe_stream(*muxer.stream(), format, plan, has_alpha(format, log),
                    header_of(log.settings()));
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
        unpack(format, entry_of(log, k), *packet, plan.path);
        muxer.write(packet.get(), av_inv_q(as_rational(plan.rate)));
    }
    muxer.write_trailer();
    put_file_hash(file, plan, encoded);
    file.commit();
}

// If the film's first frame determines whether the film has alpha, a later part receives this from
// its plan.
class PacketFilmSink : public FrameSink {
 public:
    PacketFilmSink(const PacketFilm& format, const OutputPlan& plan)
        : format_(&format),
          plan_(plan),
          converter_(plan.width_px),
          packet_(libav::make_packet()),
          log_(plan, described(), frames_a_chunk),
          n_before_(plan.part ? plan.part->n_before : 0),
          last_frame_((plan.part ? plan.part->n_film_frames : plan.n_frames) - 1),
          n_kept_(log_.n_entries()),
          n_written_(n_kept_) {
        alpha_ = has_alpha(format, log_);
    }

    std::int64_t n_frames_kept() const override { return n_kept_; }

    void write(const Image& frame) override {
        write_notifying(frame, [] {});
    }

    void write_notifying(const Image& frame, const PixelsConsumed& consumed) override {
        check_frame(frame, plan_);
        if (n_written_ == 0 && format_->alpha == FilmAlpha::of_first_frame)
            alpha_ = plan_.has_alpha.value_or(!is_opaque(frame));
        const std::int64_t number = n_before_ + n_written_;
        if (starts_chunk(number) && (n_in_chunk_ > 0 || is_alone(number))) end_chunk();
        if (!encoder_) start_chunk(is_alone(number));
        libav::checked(av_frame_make_writable(frame_.get()), plan_.path, "video frame");
        fill_frame(frame);
        consumed();
        frame_->pts = number;
        ++n_written_;
        ++n_in_chunk_;
        encoder_->send(*frame_);
        take_packets();
    }

    void finish() override {
        check_any_frame(n_written_, plan_);
        end_chunk();
        if (plan_.part) return log_.become_part();
        write_film(*format_, log_, plan_, n_shown_of(plan_, n_written_));
        log_.discard();
    }

 private:
    // The settings and, if the container stores it, the header of the encoder, which then encodes
    // the first chunk.
    std::string described() {
        const EncoderSettings settings = settings_of(*format_, plan_, false);
        Entry header;
        if (settings.header_in_container) {
            start_chunk(false);
            const AVCodecContext& context = encoder_->context();
            header = {context.extradata, static_cast<std::size_t>(context.extradata_size)};
            n_reordered_ = context.has_b_frames;
        }
        return description_of(settings, plan_, header);
    }

    bool is_alone(std::int64_t frame) const {
        return plan_.ends_alone && (frame == 0 || frame == last_frame_);
    }
    bool starts_chunk(std::int64_t frame) const {
        return frame % frames_a_chunk == 0 || is_alone(frame) || (frame > 0 && is_alone(frame - 1));
    }

    void start_chunk(bool alone) {
        const EncoderSettings settings = settings_of(*format_, plan_, alpha_, alone);
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

    // Closes the encoder, so that two never coexist.
    void end_chunk() {
        if (n_in_chunk_ > 0) {
            encoder_->send_end();
            take_packets();
        }
        encoder_.reset();
        n_in_chunk_ = 0;
        if (log_.n_entries() != n_written_)
            throw EnvironmentError(fmt::format("cannot write {}: the encoder has dropped a frame",
                                               plan_.path.string()));
        check_free_space(plan_.path, log_.n_bytes(), n_written_, plan_.n_frames);
    }

    void take_packets() {
        while (encoder_->receive(*packet_)) {
            // A short chunk ends before the encoder knows how far its frames are reordered.
            if (plan_.ends_alone) packet_->dts = n_before_ + log_.n_entries() - n_reordered_;
            pack(*format_, *packet_, entry_);
            log_.append(entry_);
        }
    }

    const PacketFilm* format_;
    OutputPlan plan_;
    bool alpha_ = false;
    int n_reordered_ = 0;  // frames by which decoding runs ahead of showing
    YuvConverter converter_;
    libav::Packet packet_;
    libav::Frame frame_;
    Image flat_;
    std::optional<VideoEncoder> encoder_;
    FrameLog log_;
    std::int64_t n_before_;  // frames of the film before the first one written here
    std::int64_t last_frame_;
    std::int64_t n_kept_;
    std::int64_t n_written_;
    std::int64_t n_in_chunk_ = 0;
    Bytes entry_;
};

}  // namespace

std::unique_ptr<FrameSink> open_film(const PacketFilm& format, const OutputPlan& plan) {
    check_plan(format, plan);
    silence_libav();
    return std::make_unique<PacketFilmSink>(format, plan);
}

void join_film(const PacketFilm& format, FrameEntries& entries, const OutputPlan& plan) {
    silence_libav();
    write_film(format, entries, plan, entries.n_entries());
}

std::int64_t recover_film(const PacketFilm& format, const fs::path& path,
                          const SealMetadata& seal) {
    silence_libav();
    FrameLog log = FrameLog::left_of(path);
    OutputPlan plan = log.plan();
    plan.seal = seal;
    check_plan(format, plan);
    const std::int64_t n_frames = n_frames_without_gap(log);
    if (n_frames == 0)
        throw InputError(fmt::format("no frame of {} had been finished", path.string()));
    write_film(format, log, plan, n_frames);
    log.discard();
    return n_frames;
}

}  // namespace poinsot
