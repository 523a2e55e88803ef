#include "output/video_remux.h"

#include <fmt/format.h>
#include <unistd.h>

#include "error/error.h"
#include "output/libav.h"

namespace poinsot {

namespace {

using libav::checked;

// A container being read from a descriptor, from its start.
class Demuxer {
 public:
    Demuxer(int descriptor, const std::filesystem::path& path)
        : io_(descriptor, libav::DescriptorIo::Direction::read) {
        if (::lseek(descriptor, 0, SEEK_SET) < 0) throw_write_error(path, errno);
        context_ = avformat_alloc_context();
        if (!context_) throw EnvironmentError("no memory for a film");
        context_->pb = io_.context();
        // On failure FFmpeg frees the context itself.
        checked(avformat_open_input(&context_, nullptr, av_find_input_format("mp4"), nullptr), path,
                "reading back");
    }
    ~Demuxer() { avformat_close_input(&context_); }
    Demuxer(const Demuxer&) = delete;
    Demuxer& operator=(const Demuxer&) = delete;

    AVFormatContext* operator->() const { return context_; }
    AVFormatContext* get() const { return context_; }

 private:
    libav::DescriptorIo io_;
    AVFormatContext* context_ = nullptr;
};

}  // namespace

void remux_to_faststart(const AtomicFile& fragments, const AtomicFile& whole) {
    const std::filesystem::path& path = whole.path();
    Demuxer demuxer(fragments.descriptor(), path);
    if (demuxer->nb_streams != 1)
        throw EnvironmentError(
            fmt::format("cannot write {}: the film aside was lost", path.string()));
    const AVStream* from = demuxer->streams[0];
    libav::Muxer muxer("mp4", whole.descriptor(), path, whole.aside());
    AVStream* to = muxer.stream();
    checked(avcodec_parameters_copy(to->codecpar, from->codecpar), path, "stream parameters");
    to->codecpar->codec_tag = 0;
    to->time_base = from->time_base;
    to->avg_frame_rate = from->avg_frame_rate;
    // The brands, which read as metadata too, are the new container's own.
    if (const AVDictionaryEntry* ours = av_dict_get(demuxer->metadata, "poinsot", nullptr, 0))
        av_dict_set(&muxer.context()->metadata, ours->key, ours->value, 0);
    libav::Options options;
    options.set("movflags", "faststart+use_metadata_tags");
    options.set("video_track_timescale", fmt::format("{}", from->time_base.den));
    muxer.write_header(options);
    const libav::Packet packet = libav::make_packet();
    // Fragments cannot say that decoding starts before time 0, so they start later than the film
    // does. The first packet is a key frame and the first picture shown.
    std::int64_t start = AV_NOPTS_VALUE;
    for (;;) {
        const int result = av_read_frame(demuxer.get(), packet.get());
        if (result == AVERROR_EOF) break;
        checked(result, path, "reading back");
        if (start == AV_NOPTS_VALUE) start = packet->pts;
        packet->pts -= start;
        packet->dts -= start;
        muxer.write(packet.get(), from->time_base);
    }
    muxer.write_trailer();
}

}  // namespace poinsot
