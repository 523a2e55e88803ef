#include "encoding/video_reader.h"

#include <fmt/format.h>

#include <cstring>
#include <span>
#include <string_view>

#include "encoding/libav.h"
#include "encoding/video_encoder.h"
#include "error/error.h"
#include "image/png.h"
#include "system/files/file_kind.h"

namespace poinsot {

namespace {

struct FreeScaler {
    void operator()(SwsContext* context) const { sws_freeContext(context); }
};

std::string text_of(const char* text) { return text ? text : ""; }

double seconds_of(const AVRational& time_base) {
    return static_cast<double>(time_base.num) / static_cast<double>(time_base.den);
}

}  // namespace

struct VideoReader::Impl {
    explicit Impl(const std::filesystem::path& file);

    void check(int result, const char* what) const;
    void open_decoder();
    void describe();
    std::int64_t count_packets();
    bool decode();
    std::int64_t number_of_frame() const;
    void convert(Image& image);
    void seek(std::int64_t k);

    std::filesystem::path path;
    libav::DemuxContext demuxer;
    AVStream* stream = nullptr;
    libav::CodecContext decoder;
    libav::Frame decoded = libav::make_frame();
    libav::Packet packet = libav::make_packet();
    std::unique_ptr<SwsContext, FreeScaler> scaler;
    VideoInfo info;
};

VideoReader::Impl::Impl(const std::filesystem::path& file) : path(file) {
    const FileKind kind = kind_of_file(path);
    if (kind != FileKind::regular)
        throw InputError(fmt::format("{}: cannot be read: {}", path.string(), in_words(kind)));
    demuxer = libav::open_film(path);
    AVFormatContext* const context = demuxer.get();
    const int index = av_find_best_stream(context, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    check(index, "its pictures");
    stream = context->streams[index];
    open_decoder();
    describe();
}

void VideoReader::Impl::check(int result, const char* what) const {
    if (result >= 0) return;
    throw InputError(fmt::format("{} cannot be read as a film: {}: {}", path.string(), what,
                                 libav::error_text(result)));
}

void VideoReader::Impl::open_decoder() {
    const AVCodec* codec = avcodec_find_decoder(stream->codecpar->codec_id);
    // FFmpeg's own VP9 decoder ignores alpha.
    if (av_dict_get(stream->metadata, "alpha_mode", nullptr, 0))
        if (const AVCodec* with_alpha = avcodec_find_decoder_by_name("libvpx-vp9"))
            codec = with_alpha;
    if (!codec)
        throw InputError(fmt::format("{} cannot be read as a film: no decoder for {}",
                                     path.string(), avcodec_get_name(stream->codecpar->codec_id)));
    decoder.reset(avcodec_alloc_context3(codec));
    if (!decoder) throw EnvironmentError("no memory for a video decoder");
    check(avcodec_parameters_to_context(decoder.get(), stream->codecpar), "its parameters");
    if (decoder->width > largest_png_side_px || decoder->height > largest_png_side_px)
        throw InputError(fmt::format("{} is {}×{} pixels; at most {} a side are read",
                                     path.string(), decoder->width, decoder->height,
                                     largest_png_side_px));
    check(avcodec_open2(decoder.get(), codec, nullptr), "its decoder");
}

// Whether a value is a valid colour name of FFmpeg: a file may contain any number, which is checked
// before it is converted to the enumeration.
template <typename Name>
bool is_known(const Name& stored, int n_names) {
    static_assert(sizeof(Name) == sizeof(int));
    int number = 0;
    std::memcpy(&number, &stored, sizeof number);
    return 0 <= number && number < n_names;
}

// Where FFmpeg keeps what belongs to a stream.
DisplayMatrix display_of(const AVStream& stream) {
#if LIBAVCODEC_VERSION_INT >= AV_VERSION_INT(60, 31, 102)
    const std::span<const AVPacketSideData> all(
        stream.codecpar->coded_side_data,
        static_cast<std::size_t>(stream.codecpar->nb_coded_side_data));
#else
    const std::span<const AVPacketSideData> all(stream.side_data,
                                                static_cast<std::size_t>(stream.nb_side_data));
#endif
    DisplayMatrix matrix = upright;
    for (const AVPacketSideData& data : all)
        if (data.type == AV_PKT_DATA_DISPLAYMATRIX && data.size >= sizeof matrix)
            std::memcpy(matrix.data(), data.data, sizeof matrix);
    return matrix;
}

void VideoReader::Impl::describe() {
    const AVCodecParameters& parameters = *stream->codecpar;
    info.width_px = parameters.width;
    info.height_px = parameters.height;
    const AVRational rate = av_guess_frame_rate(demuxer.get(), stream, nullptr);
    info.rate = {rate.num, rate.den};
    info.n_frames = stream->nb_frames > 0 ? stream->nb_frames : count_packets();
    info.display = display_of(*stream);
    const AVRational aspect = av_guess_sample_aspect_ratio(demuxer.get(), stream, nullptr);
    if (aspect.num > 0 && aspect.den > 0)
        info.pixel_width = aspect.num, info.pixel_height = aspect.den;
    // FFmpeg says so of files of the ISO format, by the flag of ISO/IEC 14496-12 §8.3.2.
    const bool is_iso = std::string_view(demuxer->iformat->name).starts_with("mov,");
    info.is_shown = !is_iso || (stream->disposition & AV_DISPOSITION_DEFAULT) != 0;
    // Matroska has a duration for the whole file only.
    info.duration_s = stream->duration != AV_NOPTS_VALUE
                          ? static_cast<double>(stream->duration) * seconds_of(stream->time_base)
                          : static_cast<double>(demuxer->duration) / AV_TIME_BASE;
    info.container = demuxer->iformat->name;
    info.codec = avcodec_get_name(parameters.codec_id);
    info.pixel_format = text_of(av_get_pix_fmt_name(decoder->pix_fmt));
    if (is_known(parameters.color_range, AVCOL_RANGE_NB))
        info.range = text_of(av_color_range_name(parameters.color_range));
    if (is_known(parameters.color_space, AVCOL_SPC_NB))
        info.matrix = text_of(av_color_space_name(parameters.color_space));
    if (is_known(parameters.color_primaries, AVCOL_PRI_NB))
        info.primaries = text_of(av_color_primaries_name(parameters.color_primaries));
    if (is_known(parameters.color_trc, AVCOL_TRC_NB))
        info.transfer = text_of(av_color_transfer_name(parameters.color_trc));
    if (is_known(parameters.chroma_location, AVCHROMA_LOC_NB))
        info.chroma_location = text_of(av_chroma_location_name(parameters.chroma_location));
    const AVDictionaryEntry* entry = nullptr;
    while ((entry = av_dict_get(demuxer->metadata, "", entry, AV_DICT_IGNORE_SUFFIX)))
        info.texts[entry->key] = entry->value;
    // Chapters' times, in whole frames.
    const AVRational frame_s = av_inv_q(stream->avg_frame_rate);
    for (const AVChapter* chapter : std::span(demuxer->chapters, demuxer->nb_chapters)) {
        const AVDictionaryEntry* title = av_dict_get(chapter->metadata, "title", nullptr, 0);
        info.chapters.push_back({title == nullptr ? "" : title->value,
                                 av_rescale_q(chapter->start, chapter->time_base, frame_s),
                                 av_rescale_q(chapter->end, chapter->time_base, frame_s)});
    }
}

std::int64_t VideoReader::Impl::count_packets() {
    std::int64_t n_packets = 0;
    while (av_read_frame(demuxer.get(), packet.get()) >= 0) {
        if (packet->stream_index == stream->index) ++n_packets;
        av_packet_unref(packet.get());
    }
    seek(0);
    return n_packets;
}

bool VideoReader::Impl::decode() {
    for (;;) {
        const int result = avcodec_receive_frame(decoder.get(), decoded.get());
        if (result == AVERROR_EOF) return false;
        if (result != AVERROR(EAGAIN)) {
            check(result, "decoding");
            return true;
        }
        const int read = av_read_frame(demuxer.get(), packet.get());
        if (read == AVERROR_EOF) {
            check(avcodec_send_packet(decoder.get(), nullptr), "decoding");
            continue;
        }
        check(read, "reading");
        if (packet->stream_index == stream->index)
            check(avcodec_send_packet(decoder.get(), packet.get()), "decoding");
        av_packet_unref(packet.get());
    }
}

std::int64_t VideoReader::Impl::number_of_frame() const {
    const std::int64_t start = stream->start_time == AV_NOPTS_VALUE ? 0 : stream->start_time;
    return av_rescale_q(decoded->best_effort_timestamp - start, stream->time_base,
                        av_inv_q(as_rational(info.rate)));
}

void VideoReader::Impl::convert(Image& image) {
    if (decoded->width != info.width_px || decoded->height != info.height_px)
        throw InputError(fmt::format("{} changes its picture size within the film", path.string()));
    if (image.width() != decoded->width || image.height() != decoded->height)
        image = Image(decoded->width, decoded->height);
    if (!scaler) {
        constexpr int exact = SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INT |
                              SWS_FULL_CHR_H_INP;
        scaler.reset(sws_getContext(
            decoded->width, decoded->height, static_cast<AVPixelFormat>(decoded->format),
            decoded->width, decoded->height, AV_PIX_FMT_RGBA, exact, nullptr, nullptr, nullptr));
        if (!scaler) throw EnvironmentError("no memory for a colour conversion");
        const int matrix = !is_known(decoded->colorspace, AVCOL_SPC_NB) ||
                                   decoded->colorspace == AVCOL_SPC_UNSPECIFIED
                               ? SWS_CS_ITU709
                               : decoded->colorspace;
        const int full = is_known(decoded->color_range, AVCOL_RANGE_NB) &&
                                 decoded->color_range == AVCOL_RANGE_JPEG
                             ? 1
                             : 0;
        sws_setColorspaceDetails(scaler.get(), sws_getCoefficients(matrix), full,
                                 sws_getCoefficients(SWS_CS_ITU709), 1, 0, 1 << 16, 1 << 16);
    }
    std::uint8_t* const plane = image.bytes().data();
    const int stride = 4 * image.width();
    sws_scale(scaler.get(), decoded->data, decoded->linesize, 0, decoded->height, &plane, &stride);
}

void VideoReader::Impl::seek(std::int64_t k) {
    const std::int64_t start = stream->start_time == AV_NOPTS_VALUE ? 0 : stream->start_time;
    const std::int64_t time =
        start + av_rescale_q(k, av_inv_q(as_rational(info.rate)), stream->time_base);
    check(av_seek_frame(demuxer.get(), stream->index, time, AVSEEK_FLAG_BACKWARD), "seeking");
    avcodec_flush_buffers(decoder.get());
}

VideoReader::VideoReader(const std::filesystem::path& path) : impl_(std::make_unique<Impl>(path)) {}
VideoReader::~VideoReader() = default;
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;

const VideoInfo& VideoReader::info() const { return impl_->info; }

std::optional<double> VideoReader::time_s() const {
    const std::int64_t pts = impl_->decoded->pts;
    if (pts == AV_NOPTS_VALUE) return std::nullopt;
    return static_cast<double>(pts) * seconds_of(impl_->stream->time_base);
}

bool VideoReader::read(Image& frame) {
    if (!impl_->decode()) return false;
    impl_->convert(frame);
    return true;
}

Image VideoReader::frame(std::int64_t k) {
    const auto missing = [&] {
        return InputError(fmt::format("{} has no frame {}; it has {}", impl_->path.string(), k,
                                      impl_->info.n_frames));
    };
    if (k < 0 || k >= impl_->info.n_frames) throw missing();
    impl_->seek(k);
    do {
        if (!impl_->decode()) throw missing();
    } while (impl_->number_of_frame() < k);
    Image image;
    impl_->convert(image);
    return image;
}

}  // namespace poinsot
