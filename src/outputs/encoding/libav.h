// RAII types for FFmpeg's C types; its errors as exceptions. Included only inside output/.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "encoding/libav_calls.h"

namespace poinsot::libav {

// The type of bytes that a muxer passes to be written, const since FFmpeg 7.
using PacketByte =
    std::conditional_t<(LIBAVFORMAT_VERSION_MAJOR >= 61), const std::uint8_t, std::uint8_t>;

struct Deleter {
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    void operator()(AVFormatContext* context) const { avformat_free_context(context); }
};
using Frame = std::unique_ptr<AVFrame, Deleter>;
using Packet = std::unique_ptr<AVPacket, Deleter>;
using CodecContext = std::unique_ptr<AVCodecContext, Deleter>;
using MuxContext = std::unique_ptr<AVFormatContext, Deleter>;

struct CloseInput {
    void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
};
using DemuxContext = std::unique_ptr<AVFormatContext, CloseInput>;

// Throw EnvironmentError if memory has run out.
Frame make_frame();
Packet make_packet();

std::string error_text(int averror);

// Opens a film to be read, with its streams known. A corrupt box may claim any size, and FFmpeg
// allocates it at once: allocations are limited to the needs of a film of this length. Throws
// InputError `FILM cannot be read as a film: REASON`.
DemuxContext open_film(const std::filesystem::path& film);

// Throws EnvironmentError `cannot write PATH: WHAT: REASON` if the result is negative.
int checked(int result, const std::filesystem::path& path, std::string_view what);

// A dictionary of options. Options left after opening are unknown to FFmpeg.
class Options {
 public:
    Options() = default;
    ~Options() {
        if (dictionary_ != nullptr) av_dict_free(&dictionary_);
    }
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    void set(const char* key, const std::string& value) {
        av_dict_set(&dictionary_, key, value.c_str(), 0);
    }
    AVDictionary** get() { return &dictionary_; }

 private:
    AVDictionary* dictionary_ = nullptr;
};

// A file descriptor that FFmpeg writes to. Remembers system errors, because FFmpeg reports them
// late or not at all. Does not own the descriptor; is not moved.
class DescriptorIo {
 public:
    explicit DescriptorIo(int descriptor);
    ~DescriptorIo();
    DescriptorIo(const DescriptorIo&) = delete;
    DescriptorIo& operator=(const DescriptorIo&) = delete;

    AVIOContext* context() const { return context_; }
    int error_number() const { return error_number_; }  // errno of the first failure, or 0

 private:
    static int write(void* self, libav::PacketByte* buffer, int size);
    static std::int64_t seek(void* self, std::int64_t offset, int whence);

    int descriptor_;
    int error_number_ = 0;
    AVIOContext* context_ = nullptr;
};

// Writes one video stream into a container on an open descriptor.
class Muxer {
 public:
    // path is the output's final name, for messages; readable is a name by which the muxer can read
    // what it has written (for faststart).
    Muxer(const char* container, int descriptor, std::filesystem::path path,
          const std::filesystem::path& readable);

    AVFormatContext* context() const { return context_.get(); }
    AVStream* stream() const { return stream_; }
    const std::filesystem::path& path() const { return path_; }

    // Adds another stream before the header is written. Throws EnvironmentError.
    AVStream* add_stream();

    void write_header(Options& options);
    // Takes ownership of the packet's contents. Its times are in time_base.
    void write(AVPacket* packet, AVRational time_base) { write(packet, time_base, *stream_); }
    void write(AVPacket* packet, AVRational time_base, const AVStream& stream);
    void write_trailer();

 private:
    void check(int result, std::string_view what) const;

    std::filesystem::path path_;
    std::unique_ptr<DescriptorIo> io_;
    MuxContext context_;
    AVStream* stream_ = nullptr;
};

}  // namespace poinsot::libav
