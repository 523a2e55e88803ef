#include "encoding/libav.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "encoding/video_encoder.h"
#include "error/error.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"

namespace poinsot::libav {

namespace {

constexpr int buffer_size = 1 << 16;

// Limits the size of FFmpeg's allocations during its lifetime.
class LargestPiece {
 public:
    explicit LargestPiece(std::size_t bytes) { av_max_alloc(bytes); }
    ~LargestPiece() { av_max_alloc(INT_MAX); }  // FFmpeg's default
    LargestPiece(const LargestPiece&) = delete;
    LargestPiece& operator=(const LargestPiece&) = delete;
};

// Sample tables take 24 bytes in memory for each 4 in the file, and grow by half.
std::size_t largest_piece_of(const std::filesystem::path& film) {
    constexpr std::uintmax_t always = 64U << 20U, times = 16, most = INT_MAX;
    std::error_code ignored;
    const std::uintmax_t bytes = std::filesystem::file_size(film, ignored);
    return bytes > (most - always) / times ? most : always + times * bytes;
}

}  // namespace

Frame make_frame() {
    Frame frame(av_frame_alloc());
    if (!frame) throw EnvironmentError("no memory for a video frame");
    return frame;
}

Packet make_packet() {
    Packet packet(av_packet_alloc());
    if (!packet) throw EnvironmentError("no memory for a video packet");
    return packet;
}

std::string error_text(int averror) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
    av_strerror(averror, text.data(), text.size());
    return text.data();
}

DemuxContext open_film(const std::filesystem::path& film) {
    const auto check = [&film](int result) {
        if (result < 0)
            throw InputError(
                fmt::format("{} cannot be read as a film: {}", film.string(), error_text(result)));
    };
    if (const FileKind kind = kind_of_file(film); kind == FileKind::special)
        throw InputError(fmt::format("{}: {}", film.string(), in_words(kind)));
    silence_libav();
    const LargestPiece while_it_opens(largest_piece_of(film));
    AVFormatContext* context = nullptr;
    check(avformat_open_input(&context, ("file:" + film.string()).c_str(), nullptr, nullptr));
    DemuxContext demuxer(context);
    // FFmpeg opens pictures as films of one frame.
    const std::string_view container = context->iformat->name;
    if (container.ends_with("_pipe") || container == "image2")
        throw InputError(fmt::format("{} is a picture, not a film; {}", film.string(),
                                     container == "png_pipe" ? "name it .png" : "give a film"));
    check(avformat_find_stream_info(context, nullptr));
    return demuxer;
}

int checked(int result, const std::filesystem::path& path, std::string_view what) {
    if (result >= 0) return result;
    throw EnvironmentError(
        fmt::format("cannot write {}: {}: {}", path.string(), what, error_text(result)));
}

DescriptorIo::DescriptorIo(int descriptor) : descriptor_(descriptor) {
    auto* buffer = static_cast<unsigned char*>(av_malloc(buffer_size));
    if (buffer)
        context_ = avio_alloc_context(buffer, buffer_size, 1, this, nullptr, &DescriptorIo::write,
                                      &DescriptorIo::seek);
    if (!context_) {
        av_free(buffer);
        throw EnvironmentError("no memory for a file buffer");
    }
}

DescriptorIo::~DescriptorIo() {
    av_freep(&context_->buffer);
    avio_context_free(&context_);
}

int DescriptorIo::write(void* self, libav::PacketByte* buffer, int size) {
    auto& io = *static_cast<DescriptorIo*>(self);
    int done = 0;
    while (done < size) {
        const ssize_t n_written =
            ::write(io.descriptor_, buffer + done, static_cast<std::size_t>(size - done));
        if (n_written >= 0) {
            done += static_cast<int>(n_written);
        } else if (errno != EINTR) {
            if (io.error_number_ == 0) io.error_number_ = errno;
            return AVERROR(errno);
        }
    }
    return size;
}

std::int64_t DescriptorIo::seek(void* self, std::int64_t offset, int whence) {
    auto& io = *static_cast<DescriptorIo*>(self);
    if (whence == AVSEEK_SIZE) return AVERROR(ENOSYS);
    const off_t position = ::lseek(io.descriptor_, offset, whence & ~AVSEEK_FORCE);
    return position >= 0 ? position : AVERROR(errno);
}

Muxer::Muxer(const char* container, int descriptor, std::filesystem::path path,
             const std::filesystem::path& readable)
    : path_(std::move(path)), io_(std::make_unique<DescriptorIo>(descriptor)) {
    AVFormatContext* context = nullptr;
    const std::string name = "file:" + readable.string();
    checked(avformat_alloc_output_context2(&context, nullptr, container, name.c_str()), path_,
            container);
    context_.reset(context);
    context_->pb = io_->context();
    context_->flags |= AVFMT_FLAG_CUSTOM_IO | AVFMT_FLAG_BITEXACT;
    stream_ = add_stream();
}

AVStream* Muxer::add_stream() {
    AVStream* const stream = avformat_new_stream(context_.get(), nullptr);
    if (stream == nullptr) throw EnvironmentError("no memory for a stream of a film");
    return stream;
}

void Muxer::check(int result, std::string_view what) const {
    if (io_->error_number() != 0) throw_write_error(path_, io_->error_number());
    checked(result, path_, what);
    checked(io_->context()->error, path_, what);
}

void Muxer::write_header(Options& options) {
    check(avformat_write_header(context_.get(), options.get()), "header");
    if (av_dict_count(*options.get()) != 0)
        throw EnvironmentError(
            fmt::format("cannot write {}: this FFmpeg does not know \"{}\"", path_.string(),
                        av_dict_get(*options.get(), "", nullptr, AV_DICT_IGNORE_SUFFIX)->key));
}

void Muxer::write(AVPacket* packet, AVRational time_base, const AVStream& stream) {
    av_packet_rescale_ts(packet, time_base, stream.time_base);
    packet->stream_index = stream.index;
    check(av_interleaved_write_frame(context_.get(), packet), "frame");
}

void Muxer::write_trailer() {
    check(av_write_trailer(context_.get()), "trailer");
    avio_flush(io_->context());
    check(0, "flush");
}

}  // namespace poinsot::libav
