#include "output/film_part.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "error/error.h"
#include "output/chapters.h"
#include "output/formats.h"
#include "output/video_encoder.h"

extern "C" {
#include <libavutil/parseutils.h>
}

namespace poinsot {

namespace {

namespace fs = std::filesystem;
using libav::checked;

// Names of what the container carries: the plan's text, and, aside only, the encoder's settings,
// the chapters, and the frame rate, which fragments do not say.
constexpr const char* kMetadataKey = "poinsot";
constexpr const char* kSettingsKey = "poinsot_settings";
constexpr const char* kRateKey = "poinsot_rate";
constexpr const char* kChaptersKey = "poinsot_chapters";
std::string text_of(const AVDictionary* dictionary, const char* key) {
    const AVDictionaryEntry* entry = av_dict_get(dictionary, key, nullptr, 0);
    return entry ? entry->value : "";
}

std::uint64_t big_endian(std::span<const std::uint8_t> bytes) {
    std::uint64_t value = 0;
    for (const std::uint8_t byte : bytes) value = value << 8 | byte;
    return value;
}

std::int64_t size_of(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0 ? status.st_size : 0;
}

// How far a part reaches with whole fragments: a cut through one would make FFmpeg refuse them all.
// A fragment is a box that describes ("moof") and one that holds the packets ("mdat").
std::int64_t n_whole_bytes(int descriptor) {
    const std::int64_t n_bytes = size_of(descriptor);
    std::int64_t at = 0, n_whole = 0;
    std::array<std::uint8_t, 16> head{};
    while (::pread(descriptor, head.data(), head.size(), at) == static_cast<ssize_t>(head.size())) {
        // ISO/IEC 14496-12 §4.2: size, type, and, where the size is 1, a 64-bit size.
        auto size = static_cast<std::int64_t>(big_endian(std::span(head).first<4>()));
        if (size == 1) size = static_cast<std::int64_t>(big_endian(std::span(head).last<8>()));
        if (size < 8 || size > n_bytes - at) break;
        at += size;
        const std::string_view type(reinterpret_cast<const char*>(head.data()) + 4, 4);
        if (type == "moov" || type == "mdat") n_whole = at;
    }
    return n_whole;
}

fs::path renewed_path(const fs::path& path) { return aside_path_of(path, ".renewed.mp4"); }

// The packets of a film part, in decoding order, as far as they are whole.
class PartReader {
 public:
    explicit PartReader(const AtomicFile& file)
        : io_(file.descriptor(), libav::DescriptorIo::Direction::read,
              n_whole_bytes(file.descriptor())) {
        if (::lseek(file.descriptor(), 0, SEEK_SET) != 0) throw_write_error(file.path(), errno);
        context_ = avformat_alloc_context();
        if (!context_) throw EnvironmentError("no memory for a film");
        context_->pb = io_.context();
        // On failure FFmpeg frees the context itself.
        if (avformat_open_input(&context_, nullptr, av_find_input_format("mp4"), nullptr) < 0 ||
            context_->nb_streams != 1 ||
            av_parse_ratio(&rate_, text(kRateKey).c_str(), std::numeric_limits<int>::max(), 0,
                           nullptr) < 0 ||
            rate_.num <= 0 || rate_.den <= 0)
            avformat_close_input(&context_);
    }
    ~PartReader() { avformat_close_input(&context_); }
    PartReader(const PartReader&) = delete;
    PartReader& operator=(const PartReader&) = delete;

    bool valid() const { return context_ != nullptr; }
    const AVStream& stream() const { return *context_->streams[0]; }
    AVRational rate() const { return rate_; }
    std::string text(const char* key) const { return text_of(context_->metadata, key); }

    // False after the last whole packet. Times count from the first packet, the first picture
    // shown.
    bool read(AVPacket* packet) {
        av_packet_unref(packet);
        if (av_read_frame(context_, packet) < 0) return false;
        if (packet->flags & AV_PKT_FLAG_CORRUPT) return false;
        if (start_ == AV_NOPTS_VALUE) start_ = packet->pts;
        packet->pts -= start_;
        packet->dts -= start_;
        return true;
    }

    std::int64_t frame_of(const AVPacket& packet) const {
        return av_rescale_q(packet.pts, stream().time_base, av_inv_q(rate_));
    }

 private:
    libav::DescriptorIo io_;
    AVFormatContext* context_ = nullptr;
    AVRational rate_{0, 1};
    std::int64_t start_ = AV_NOPTS_VALUE;
};

// How many first packets show exactly the frames 0 … n−1, n being the return value and, with a step
// above 1, a multiple of it that a key frame follows or the film ends with.
std::int64_t n_frames_without_gap(const AtomicFile& file, std::int64_t step) {
    PartReader reader(file);
    const libav::Packet packet = libav::make_packet();
    std::int64_t n_read = 0, last_shown = -1, n_whole = 0;
    while (reader.valid() && reader.read(packet.get())) {
        last_shown = std::max(last_shown, reader.frame_of(*packet));
        ++n_read;
        if (last_shown + 1 == n_read && n_read % step == 0) n_whole = n_read;
    }
    return n_whole;
}

// H.264 in MP4 says each unit's length before it; an encoder's packets, which a muxer opened for
// them expects, have a start code there. Both take four bytes. Source: ISO/IEC 14496-15 §5.3.3;
// Rec. ITU-T H.264 Annex B.
void put_start_codes(AVPacket* packet, const fs::path& path) {
    checked(av_packet_make_writable(packet), path, "copying");
    std::span<std::uint8_t> rest(packet->data, static_cast<std::size_t>(packet->size));
    while (rest.size() >= 4) {
        const std::uint64_t length = big_endian(rest.first(4));
        std::copy_n("\0\0\0\1", 4, rest.begin());
        rest = rest.subspan(std::min<std::size_t>(rest.size(), 4 + length));
    }
}

enum class Units { with_lengths, with_start_codes };

void copy_packets(const AtomicFile& from, libav::Muxer& to, std::int64_t n_packets, Units units,
                  const fs::path& path) {
    PartReader reader(from);
    const libav::Packet packet = libav::make_packet();
    for (std::int64_t i = 0; i < n_packets; ++i) {
        if (!reader.valid() || !reader.read(packet.get()))
            throw EnvironmentError(
                fmt::format("cannot write {}: what lies aside cannot be read back", path.string()));
        // Not every packet of a part says how long it lasts.
        packet->duration =
            av_rescale_q(1, av_inv_q(reader.stream().avg_frame_rate), reader.stream().time_base);
        if (units == Units::with_start_codes) put_start_codes(packet.get(), path);
        to.write(packet.get(), reader.stream().time_base);
    }
}

// Copies the first frames of a part into a file with its index in front.
void copy_to_whole(const AtomicFile& part, const AtomicFile& whole, std::int64_t n_frames,
                   const Retell& retell) {
    const fs::path& path = whole.path();
    PartReader reader(part);
    if (!reader.valid())
        throw EnvironmentError(
            fmt::format("cannot write {}: what lies aside cannot be read back", path.string()));
    libav::Muxer muxer("mp4", whole.descriptor(), path, whole.aside());
    AVStream* stream = muxer.stream();
    checked(avcodec_parameters_copy(stream->codecpar, reader.stream().codecpar), path,
            "stream parameters");
    stream->codecpar->codec_tag = 0;
    stream->time_base = reader.stream().time_base;
    stream->avg_frame_rate = reader.rate();
    const std::string text = reader.text(kMetadataKey);
    av_dict_set(&muxer.context()->metadata, kMetadataKey,
                (retell ? retell(text, n_frames) : text).c_str(), 0);
    const auto chapters = parse_chapters(reader.text(kChaptersKey));
    add_chapters(*muxer.context(), first_chapters(chapters, n_frames),
                 {reader.rate().num, reader.rate().den});
    libav::Options options;
    options.set("movflags", "faststart+use_metadata_tags");
    options.set("video_track_timescale", fmt::format("{}", stream->time_base.den));
    muxer.write_header(options);
    copy_packets(part, muxer, n_frames, Units::with_lengths, path);
    muxer.write_trailer();
}

}  // namespace

fs::path film_part_path(const fs::path& path) { return aside_path_of(path, ".part.mp4"); }

FilmPart::FilmPart(const OutputPlan& plan, const AVCodecContext& encoder,
                   const std::string& settings, std::int64_t n_chunk_frames)
    : plan_(plan),
      time_base_(encoder.time_base),
      file_(plan.path, film_part_path(plan.path), plan.resume) {
    // Killed while keep_chunks was at work, a run has left this one too.
    std::error_code ignored;
    fs::remove(renewed_path(plan.path), ignored);
    if (plan_.resume) keep_chunks(encoder, settings, n_chunk_frames);
    if (n_frames_kept_ == 0) {
        if (::lseek(file_.descriptor(), 0, SEEK_SET) != 0 || ftruncate(file_.descriptor(), 0) != 0)
            throw_write_error(plan_.path, errno);
        muxer_ = open_muxer(file_, encoder, settings);
    }
}

FilmPart::~FilmPart() {
    // FFmpeg's buffers go before the file does.
    muxer_.reset();
    bool worth_keeping = false;
    try {
        worth_keeping =
            plan_.resume && file_.descriptor() >= 0 && n_frames_without_gap(file_, 1) > 0;
    } catch (const Error&) {
        // What cannot be read back is not.
        worth_keeping = false;
    }
    if (worth_keeping)
        file_.release();
    else
        file_.discard();
}

std::unique_ptr<libav::Muxer> FilmPart::open_muxer(const AtomicFile& file,
                                                   const AVCodecContext& encoder,
                                                   const std::string& settings) const {
    auto muxer = std::make_unique<libav::Muxer>("mp4", file.descriptor(), plan_.path, file.aside());
    checked(avcodec_parameters_from_context(muxer->stream()->codecpar, &encoder), plan_.path,
            "stream parameters");
    muxer->stream()->time_base = encoder.time_base;
    muxer->stream()->avg_frame_rate = as_rational(plan_.rate);
    muxer->context()->flags |= AVFMT_FLAG_FLUSH_PACKETS;
    av_dict_set(&muxer->context()->metadata, kMetadataKey, plan_.metadata.c_str(), 0);
    av_dict_set(&muxer->context()->metadata, kSettingsKey, settings.c_str(), 0);
    av_dict_set(&muxer->context()->metadata, kRateKey,
                fmt::format("{}/{}", plan_.rate.numerator, plan_.rate.denominator).c_str(), 0);
    av_dict_set(&muxer->context()->metadata, kChaptersKey, chapters_text(plan_.chapters).c_str(),
                0);
    libav::Options options;
    // A fragment a frame: a kill takes nothing that the encoder has given out.
    options.set("movflags", "frag_every_frame+empty_moov+default_base_moof+use_metadata_tags");
    muxer->write_header(options);
    return muxer;
}

// The chunks kept are copied into a new part, so that a run killed meanwhile finds the old one.
void FilmPart::keep_chunks(const AVCodecContext& encoder, const std::string& settings,
                           std::int64_t n_chunk_frames) {
    {
        const PartReader reader(file_);
        if (!reader.valid()) return;
        const bool same =
            reader.text(kMetadataKey) == plan_.metadata && reader.text(kSettingsKey) == settings;
        if (!same) return;
    }
    const std::int64_t n_kept = n_frames_without_gap(file_, n_chunk_frames);
    if (n_kept == 0) return;
    AtomicFile renewed(plan_.path, renewed_path(plan_.path));
    std::unique_ptr<libav::Muxer> muxer = open_muxer(renewed, encoder, settings);
    copy_packets(file_, *muxer, n_kept, Units::with_start_codes, plan_.path);
    muxer->flush_fragment();
    renewed.replace(file_);
    file_ = std::move(renewed);
    muxer_ = std::move(muxer);
    n_frames_kept_ = n_kept;
}

void FilmPart::write(AVPacket* packet) {
    packet->duration = 1;
    muxer_->write(packet, time_base_);
}

std::uint64_t FilmPart::n_bytes() const {
    return static_cast<std::uint64_t>(size_of(file_.descriptor()));
}

void FilmPart::finish(std::int64_t n_frames) {
    muxer_->write_trailer();
    AtomicFile whole(plan_.path);
    copy_to_whole(file_, whole, n_frames, {});
    whole.commit();
    muxer_.reset();
    file_.discard();
}

std::int64_t recover_mp4(const fs::path& path, const Retell& retell) {
    const fs::path part_path = film_part_path(path);
    std::error_code ignored;
    if (!fs::exists(part_path, ignored))
        throw InputError(fmt::format("there is no unfinished film of {}", path.string()));
    silence_libav();
    AtomicFile part(path, part_path, true);
    const std::int64_t n_frames = n_frames_without_gap(part, 1);
    if (n_frames == 0)
        throw InputError(fmt::format("no frame of {} had been finished", path.string()));
    AtomicFile whole(path);
    copy_to_whole(part, whole, n_frames, retell);
    whole.commit();
    part.discard();
    return n_frames;
}

}  // namespace poinsot
