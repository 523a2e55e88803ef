// Captions as a text track, read back packet by packet.
#include "encoding/film_texts.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "encoding/film_packets.h"
#include "encoding/films.h"
#include "encoding/video_reader.h"

namespace poinsot {
namespace {

const std::vector<FilmSubtitle> told{
    {"ω₁ < 2 & L", 100, 900, false}, {"above", 500, 700, true}, {"the end", 1000, 60000, true}};

struct Read {
    AVCodecID codec = AV_CODEC_ID_NONE;
    int n_streams = 0;
    std::vector<FilmSubtitle> subtitles;  // at_top: from the packet's settings
};

Read read_track(const std::filesystem::path& film) {
    const libav::DemuxContext input = libav::open_film(film);
    Read read;
    read.n_streams = static_cast<int>(input->nb_streams);
    int track = -1;
    for (unsigned i = 0; i < input->nb_streams; ++i) {
        if (input->streams[i]->codecpar->codec_type != AVMEDIA_TYPE_SUBTITLE) continue;
        track = static_cast<int>(i);
        read.codec = input->streams[i]->codecpar->codec_id;
    }
    const libav::Packet packet = libav::make_packet();
    while (av_read_frame(input.get(), packet.get()) >= 0) {
        if (packet->stream_index == track) {
            const AVRational unit = input->streams[track]->time_base;
            const auto ms = [&](std::int64_t time) {
                return (2000 * time * unit.num + unit.den) / (2 * unit.den);
            };
            FilmSubtitle subtitle;
            subtitle.text.assign(reinterpret_cast<const char*>(packet->data),
                                 static_cast<std::size_t>(packet->size));
            subtitle.begin_ms = ms(packet->pts);
            subtitle.end_ms = ms(packet->pts + packet->duration);
            std::size_t n_settings = 0;
            const std::uint8_t* const settings =
                av_packet_get_side_data(packet.get(), AV_PKT_DATA_WEBVTT_SETTINGS, &n_settings);
            subtitle.at_top =
                std::string(reinterpret_cast<const char*>(settings), n_settings) == "line:0";
            read.subtitles.push_back(subtitle);
        }
        av_packet_unref(packet.get());
    }
    return read;
}

OutputPlan told_plan(const std::filesystem::path& path) {
    OutputPlan plan = small_plan(path, 45);
    plan.rate = {30, 1};
    plan.subtitles = told;
    return plan;
}

void expect(const FilmSubtitle& found, const FilmSubtitle& wanted) {
    EXPECT_EQ(found.text, wanted.text);
    EXPECT_EQ(found.begin_ms, wanted.begin_ms) << wanted.text;
    EXPECT_EQ(found.end_ms, wanted.end_ms) << wanted.text;
    EXPECT_EQ(found.at_top, wanted.at_top) << wanted.text;
}

// Where two captions overlap, both are shown; the last ends with the film, which lasts 1.5 s.
TEST(SubtitleTrack, OfWebmHasTheTextsAtTheirTimes) {
    const TemporaryFolder folder;
    const OutputPlan plan = told_plan(folder / "a.webm");
    write_film(plan);
    const Read read = read_track(plan.path);
    EXPECT_EQ(read.codec, AV_CODEC_ID_WEBVTT);
    ASSERT_EQ(read.subtitles.size(), 4u);
    const std::string below = "ω₁ &lt; 2 &amp; L";
    expect(read.subtitles[0], {below, 100, 500, false});
    expect(read.subtitles[1], {"above\n" + below, 500, 700, false});
    expect(read.subtitles[2], {below, 700, 900, false});
    expect(read.subtitles[3], {"the end", 1000, 1500, true});
}

// A sample is its text's length in 16 bits, and the text; samples without text fill the gaps.
class TimedText : public ::testing::TestWithParam<const char*> {};

TEST_P(TimedText, HasTheTextsAtTheirTimesAndEmptyGaps) {
    const TemporaryFolder folder;
    const OutputPlan plan = told_plan(folder / GetParam());
    write_film(plan);
    const Read read = read_track(plan.path);
    EXPECT_EQ(read.codec, AV_CODEC_ID_MOV_TEXT);
    std::vector<FilmSubtitle> texts;
    std::int64_t end_ms = 0;
    for (FilmSubtitle subtitle : read.subtitles) {
        ASSERT_GE(subtitle.text.size(), 2u);
        EXPECT_EQ(subtitle.begin_ms, end_ms);
        end_ms = subtitle.end_ms;
        const auto length =
            static_cast<std::size_t>(256 * static_cast<unsigned char>(subtitle.text[0]) +
                                     static_cast<unsigned char>(subtitle.text[1]));
        subtitle.text = subtitle.text.substr(2, length);
        if (!subtitle.text.empty()) texts.push_back(subtitle);
    }
    ASSERT_EQ(texts.size(), 4u);
    expect(texts[0], {told[0].text, 100, 500, false});
    expect(texts[1], {"above\n" + told[0].text, 500, 700, false});
    expect(texts[2], {told[0].text, 700, 900, false});
    expect(texts[3], {"the end", 1000, 1500, false});
}

INSTANTIATE_TEST_SUITE_P(Formats, TimedText, ::testing::Values("a.mp4", "a.mov"),
                         [](const auto& tested) { return std::string(tested.param).substr(2); });

// The sample entry of 3GPP TS 26.245 §5.16 is valid under its own name only; QuickTime's is "text".
TEST(SubtitleTrack, OfMovIsNamedAsItsEntry) {
    const TemporaryFolder folder;
    const OutputPlan plan = told_plan(folder / "a.mov");
    write_film(plan);
    EXPECT_NE(bytes_of(plan.path).find(std::string("tx3g\0\0\0\0\0\0\0\1", 12)), std::string::npos);
}

// Players offer the captions by the language of the track.
TEST(FilmTexts, TracksHaveTheLanguageOfTheFilm) {
    const TemporaryFolder folder;
    const std::map<std::string, std::map<std::string, std::string>> read{
        {"a.mp4", {{"deu", "deu"}, {"fra", "fra"}, {"jpn", "jpn"}, {"", "und"}}},
        {"a.mov", {{"deu", "ger"}, {"fra", "fra"}, {"jpn", "jpn"}, {"", "und"}}},
        {"a.webm", {{"deu", "ger"}, {"fra", "fre"}, {"jpn", "jpn"}, {"", "und"}}}};
    for (const auto& [name, tags] : read)
        for (const auto& [language, wanted] : tags) {
            OutputPlan plan = told_plan(folder / name);
            plan.language = language;
            write_film(plan);
            const libav::DemuxContext input = libav::open_film(plan.path);
            ASSERT_EQ(input->nb_streams, 2u);
            for (unsigned i = 0; i < 2; ++i) {
                const AVDictionaryEntry* const entry =
                    av_dict_get(input->streams[i]->metadata, "language", nullptr, 0);
                const std::string tag = entry != nullptr ? entry->value : "und";
                EXPECT_EQ(tag, wanted) << name << " " << i;
            }
        }
}

// The track does not change the pictures, and a film without captions has one stream.
TEST(SubtitleTrack, ChangesNoPictureAndIsOmittedWithoutTexts) {
    const TemporaryFolder folder;
    for (const char* suffix : {"mp4", "webm", "mov"}) {
        const OutputPlan with = told_plan(folder / (std::string("with.") + suffix));
        OutputPlan without = told_plan(folder / (std::string("without.") + suffix));
        without.subtitles.clear();
        write_film(with);
        write_film(without);
        EXPECT_EQ(packet_hash_of(with.path), packet_hash_of(without.path));
        EXPECT_EQ(read_track(with.path).n_streams, 2);
        EXPECT_EQ(read_track(without.path).n_streams, 1);
        EXPECT_NEAR(VideoReader(with.path).info().duration_s, 1.5, 0.04);
        EXPECT_EQ(frames_of(with.path).size(), 45u);
    }
}

TEST(FilmTexts, AreReadBackFromTheirText) {
    OutputPlan plan;
    plan.chapters = {{"one\n2 c 3", 0, 10}, {"", 10, 20}};
    plan.subtitles = told;
    plan.language = "jpn";
    const std::string text = texts_of(plan);
    OutputPlan again;
    parse_texts(text, again);
    ASSERT_EQ(again.chapters.size(), 2u);
    ASSERT_EQ(again.subtitles.size(), 3u);
    EXPECT_EQ(again.chapters[0].title, plan.chapters[0].title);
    EXPECT_EQ(again.chapters[1].end_frame, 20);
    EXPECT_EQ(again.language, "jpn");
    for (std::size_t k = 0; k < 3; ++k) expect(again.subtitles[k], told[k]);
    EXPECT_EQ(texts_of(again), text);
    // Truncated text gives either nothing or the complete rows that remain.
    for (std::size_t n = 0; n < text.size(); ++n) {
        parse_texts(std::string_view(text).substr(0, n), again);
        EXPECT_TRUE(text.starts_with(texts_of(again)));
    }
    parse_texts("s 1 2 9223372036854775807 x\n", again);
    EXPECT_TRUE(again.subtitles.empty());
}

}  // namespace
}  // namespace poinsot
