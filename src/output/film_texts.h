// What a film says besides its pictures, in containers that can carry it: chapters, and captions
// as a track of text. Included only inside output/.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/frame_sink.h"
#include "output/libav.h"

namespace poinsot {

// Before the header is written. Throws EnvironmentError if memory has run out.
void add_chapters(AVFormatContext& context, std::span<const FilmChapter> chapters,
                  const FrameRate& rate);

// A plan's chapters and subtitles as a text that a film under way carries, and back into a plan;
// what is no such text has none.
std::string texts_of(const OutputPlan& plan);
void parse_texts(std::string_view text, OutputPlan& plan);

// Those of a film that ends after n_frames.
std::vector<FilmChapter> first_chapters(std::span<const FilmChapter> chapters,
                                        std::int64_t n_frames);
std::vector<FilmSubtitle> first_subtitles(std::span<const FilmSubtitle> subtitles,
                                          std::int64_t n_frames, const FrameRate& rate);

// One after another, as a track of text has them: where two stand at once, both do, the upper one
// first.
std::vector<FilmSubtitle> one_at_a_time(std::span<const FilmSubtitle> subtitles);

// The subtitles of a film as a track of their own. Players show it when they are asked to: the
// picture has the captions already. A film without them has no track.
class SubtitleTrack {
 public:
    // Before the header is written. codec: AV_CODEC_ID_MOV_TEXT or AV_CODEC_ID_WEBVTT.
    SubtitleTrack(libav::Muxer& muxer, AVCodecID codec, const OutputPlan& plan,
                  std::int64_t n_frames);

    // Writes those that begin before the n-th frame of the film.
    void write_before(std::int64_t n);

 private:
    void write(const FilmSubtitle& subtitle);

    libav::Muxer* muxer_;
    AVCodecID codec_;
    FrameRate rate_;
    std::vector<FilmSubtitle> left_;  // the last of them first
    AVStream* stream_ = nullptr;
    libav::Packet packet_;
};

}  // namespace poinsot
