// The texts of a film in containers that support them: chapters, and captions as a text track.
// Included only inside output/.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "encoding/frame_sink.h"
#include "encoding/libav.h"

namespace poinsot {

// Adds chapters before the header is written. Throws EnvironmentError if memory has run out.
void add_chapters(AVFormatContext& context, std::span<const FilmChapter> chapters,
                  const FrameRate& rate);

// Tags a track with the film's language, before the header is written.
void set_language(const libav::Muxer& muxer, AVStream& stream, const OutputPlan& plan);

// Converts a plan's language, chapters and subtitles to text stored with an unfinished film, and
// back into a plan; other text gives none.
std::string texts_of(const OutputPlan& plan);
void parse_texts(std::string_view text, OutputPlan& plan);

// Returns the chapters of a film that ends after n_frames.
std::vector<FilmChapter> first_chapters(std::span<const FilmChapter> chapters,
                                        std::int64_t n_frames);
std::vector<FilmSubtitle> first_subtitles(std::span<const FilmSubtitle> subtitles,
                                          std::int64_t n_frames, const FrameRate& rate);

// Returns the subtitles without overlaps, as a text track needs them: where two overlap, both are
// shown in one, the upper one first.
std::vector<FilmSubtitle> one_at_a_time(std::span<const FilmSubtitle> subtitles);

// The subtitles of a film as a separate track. Players show it only on request, because the picture
// contains the captions already. A film without subtitles has no track.
class SubtitleTrack {
 public:
    // Adds the track before the header is written. codec: AV_CODEC_ID_MOV_TEXT or
    // AV_CODEC_ID_WEBVTT.
    SubtitleTrack(libav::Muxer& muxer, AVCodecID codec, const OutputPlan& plan,
                  std::int64_t n_frames);

    // Writes the subtitles that begin before the n-th frame of the film.
    void write_before(std::int64_t n);

 private:
    void write(const FilmSubtitle& subtitle);

    libav::Muxer* muxer_;
    AVCodecID codec_;
    FrameRate rate_;
    std::vector<FilmSubtitle> left_;  // not yet written, in reverse order
    AVStream* stream_ = nullptr;
    libav::Packet packet_;
};

}  // namespace poinsot
