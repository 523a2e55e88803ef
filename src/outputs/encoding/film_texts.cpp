#include "encoding/film_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "error/error.h"
#include "text/markup.h"
#include "text/numbers.h"

namespace poinsot {

void add_chapters(AVFormatContext& context, std::span<const FilmChapter> chapters,
                  const FrameRate& rate) {
    for (const FilmChapter& chapter : chapters) {
        // FFmpeg frees the memory owned by the context.
        auto* const grown = static_cast<AVChapter**>(
            av_realloc_array(context.chapters, context.nb_chapters + 1, sizeof(AVChapter*)));
        if (grown == nullptr) throw EnvironmentError("no memory for a film's chapters");
        context.chapters = grown;
        auto* const added = static_cast<AVChapter*>(av_mallocz(sizeof(AVChapter)));
        if (added == nullptr) throw EnvironmentError("no memory for a film's chapters");
        context.chapters[context.nb_chapters++] = added;
        added->id = context.nb_chapters;
        added->time_base = {static_cast<int>(rate.denominator), static_cast<int>(rate.numerator)};
        added->start = chapter.first_frame;
        added->end = chapter.end_frame;
        av_dict_set(&added->metadata, "title", chapter.title.c_str(), 0);
    }
}

void set_language(const libav::Muxer& muxer, AVStream& stream, const OutputPlan& plan) {
    if (plan.language.empty()) return;
    // MP4 has the terminological codes of ISO 639-2, WebM the bibliographic ones, and QuickTime
    // numbers for which FFmpeg has a list.
    std::string code = plan.language;
    const std::string_view container = muxer.context()->oformat->name;
    if (code == "deu" && container != "mp4") code = "ger";
    if (code == "fra" && container == "webm") code = "fre";
    av_dict_set(&stream.metadata, "language", code.c_str(), 0);
}

// One row "KIND NUMBER … LENGTH TEXT" each, with a text of LENGTH bytes of any content. Language:
// l; chapters: c, first and end; subtitles: s, begin, end, and whether they are at the top.
std::string texts_of(const OutputPlan& plan) {
    std::string text;
    if (!plan.language.empty())
        text += fmt::format("l {} {}\n", plan.language.size(), plan.language);
    for (const FilmChapter& chapter : plan.chapters)
        text += fmt::format("c {} {} {} {}\n", chapter.first_frame, chapter.end_frame,
                            chapter.title.size(), chapter.title);
    for (const FilmSubtitle& subtitle : plan.subtitles)
        text += fmt::format("s {} {} {} {} {}\n", subtitle.begin_ms, subtitle.end_ms,
                            subtitle.at_top ? 1 : 0, subtitle.text.size(), subtitle.text);
    return text;
}

namespace {

// Removes the first row of the text; false if it is not a row.
bool take_row(std::string_view& text, OutputPlan& plan) {
    if (text.size() < 2 || text[1] != ' ') return false;
    const char kind = text[0];
    if (kind != 'l' && kind != 'c' && kind != 's') return false;
    const std::size_t n_numbers = kind == 'l' ? 0 : kind == 'c' ? 2 : 3;
    text.remove_prefix(2);
    std::array<std::int64_t, 3> numbers{};
    std::int64_t length = 0;
    for (std::size_t i = 0; i < n_numbers; ++i)
        if (!take_count(text, numbers[i], ' ')) return false;
    if (!take_count(text, length, ' ')) return false;
    if (static_cast<std::size_t>(length) >= text.size()) return false;
    std::string said(text.substr(0, static_cast<std::size_t>(length)));
    text.remove_prefix(static_cast<std::size_t>(length) + 1);
    if (kind == 'l')
        plan.language = std::move(said);
    else if (kind == 'c')
        plan.chapters.push_back({std::move(said), numbers[0], numbers[1]});
    else
        plan.subtitles.push_back({std::move(said), numbers[0], numbers[1], numbers[2] != 0});
    return true;
}

}  // namespace

void parse_texts(std::string_view text, OutputPlan& plan) {
    plan.language.clear();
    plan.chapters.clear();
    plan.subtitles.clear();
    while (!text.empty()) {
        if (take_row(text, plan)) continue;
        plan.language.clear();
        plan.chapters.clear();
        plan.subtitles.clear();
        return;
    }
}

std::vector<FilmChapter> first_chapters(std::span<const FilmChapter> chapters,
                                        std::int64_t n_frames) {
    std::vector<FilmChapter> first;
    for (FilmChapter chapter : chapters) {
        chapter.end_frame = std::min(chapter.end_frame, n_frames);
        if (chapter.first_frame < chapter.end_frame) first.push_back(chapter);
    }
    return first;
}

std::vector<FilmSubtitle> first_subtitles(std::span<const FilmSubtitle> subtitles,
                                          std::int64_t n_frames, const FrameRate& rate) {
    const std::int64_t end_ms = milliseconds_of(n_frames, rate);
    std::vector<FilmSubtitle> first;
    for (FilmSubtitle subtitle : subtitles) {
        subtitle.end_ms = std::min(subtitle.end_ms, end_ms);
        if (subtitle.begin_ms < subtitle.end_ms) first.push_back(std::move(subtitle));
    }
    return first;
}

std::vector<FilmSubtitle> one_at_a_time(std::span<const FilmSubtitle> subtitles) {
    std::vector<std::int64_t> changes_ms;
    for (const FilmSubtitle& subtitle : subtitles)
        changes_ms.insert(changes_ms.end(), {subtitle.begin_ms, subtitle.end_ms});
    std::sort(changes_ms.begin(), changes_ms.end());
    changes_ms.erase(std::unique(changes_ms.begin(), changes_ms.end()), changes_ms.end());
    std::vector<FilmSubtitle> track;
    for (std::size_t k = 0; k + 1 < changes_ms.size(); ++k) {
        FilmSubtitle shown{"", changes_ms[k], changes_ms[k + 1], true};
        for (const bool at_top : {true, false})
            for (const FilmSubtitle& subtitle : subtitles) {
                if (subtitle.at_top != at_top || subtitle.begin_ms > shown.begin_ms ||
                    subtitle.end_ms < shown.end_ms)
                    continue;
                shown.text += (shown.text.empty() ? "" : "\n") + subtitle.text;
                shown.at_top = shown.at_top && at_top;
            }
        if (!shown.text.empty()) track.push_back(std::move(shown));
    }
    return track;
}

namespace {

// Default style of subtitles: centred at the bottom, white, no background. Source: 3GPP TS 26.245
// §5.16, the sample entry from displayFlags on.
constexpr std::array<std::uint8_t, 47> text_sample_entry{
    0,   0,   0,   0,                            // flags
    1,   255,                                    // centred, at the bottom
    0,   0,   0,   0,                            // background
    0,   0,   0,   0,   0,   0,   0,   0,        // the whole picture
    0,   0,   0,   0,   0,   1,   0,   18,       // characters 0 to 0, font 1, plain, size 18
    255, 255, 255, 255,                          // white
    0,   0,   0,   17,  'f', 't', 'a', 'b',      // fonts
    0,   1,   0,   1,   4,   'S', 'a', 'n', 's'  // one: 1, "Sans"
};

// A sample of 3GPP TS 26.245 §5.17: the text's length in 16 bits, and the text.
std::string timed_text(std::string_view text) {
    constexpr std::size_t most = 0xffff;
    // Truncates between characters.
    std::size_t size = std::min(text.size(), most);
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xc0U) == 0x80U) --size;
    std::string sample{static_cast<char>(size >> 8U), static_cast<char>(size & 0xffU)};
    return sample.append(text.substr(0, size));
}

}  // namespace

SubtitleTrack::SubtitleTrack(libav::Muxer& muxer, AVCodecID codec, const OutputPlan& plan,
                             std::int64_t n_frames)
    : muxer_(&muxer),
      codec_(codec),
      rate_(plan.rate),
      left_(one_at_a_time(first_subtitles(plan.subtitles, n_frames, plan.rate))),
      packet_(libav::make_packet()) {
    if (left_.empty()) return;
    std::reverse(left_.begin(), left_.end());
    stream_ = muxer.add_stream();
    set_language(muxer, *stream_, plan);
    stream_->time_base = {1, 1000};
    AVCodecParameters& parameters = *stream_->codecpar;
    parameters.codec_type = AVMEDIA_TYPE_SUBTITLE;
    parameters.codec_id = codec;
    if (codec != AV_CODEC_ID_MOV_TEXT) return;
    parameters.codec_tag = MKTAG('t', 'x', '3', 'g');  // in QuickTime as in MP4
    // FFmpeg frees the memory owned by the parameters.
    parameters.extradata = static_cast<std::uint8_t*>(
        av_mallocz(text_sample_entry.size() + AV_INPUT_BUFFER_PADDING_SIZE));
    if (parameters.extradata == nullptr) throw EnvironmentError("no memory for a film");
    std::copy(text_sample_entry.begin(), text_sample_entry.end(), parameters.extradata);
    parameters.extradata_size = static_cast<int>(text_sample_entry.size());
}

void SubtitleTrack::write_before(std::int64_t n) {
    const std::int64_t now_ms = milliseconds_of(n, rate_);
    for (; !left_.empty() && left_.back().begin_ms < now_ms; left_.pop_back()) write(left_.back());
}

void SubtitleTrack::write(const FilmSubtitle& subtitle) {
    const bool is_timed_text = codec_ == AV_CODEC_ID_MOV_TEXT;
    const std::string sample =
        is_timed_text ? timed_text(subtitle.text) : escaped_cue(subtitle.text);
    libav::checked(av_new_packet(packet_.get(), static_cast<int>(sample.size())), muxer_->path(),
                   "packet");
    std::copy(sample.begin(), sample.end(), packet_->data);
    if (constexpr std::string_view top = "line:0"; !is_timed_text && subtitle.at_top) {
        std::uint8_t* const settings =
            av_packet_new_side_data(packet_.get(), AV_PKT_DATA_WEBVTT_SETTINGS, top.size());
        if (settings == nullptr) throw EnvironmentError("no memory for a subtitle");
        std::copy(top.begin(), top.end(), settings);
    }
    packet_->pts = packet_->dts = subtitle.begin_ms;
    packet_->duration = subtitle.end_ms - subtitle.begin_ms;
    packet_->flags |= AV_PKT_FLAG_KEY;
    muxer_->write(packet_.get(), {1, 1000}, *stream_);
}

}  // namespace poinsot
