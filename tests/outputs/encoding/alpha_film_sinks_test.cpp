// WebM and QuickTime films decoded by libavformat: their properties, transparency and odd sizes.
#include <gtest/gtest.h>

#include "encoding/films.h"

namespace poinsot {
namespace {

TEST(Webm, KeepsTransparency) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.webm", 4);
    plan.quality = "print";
    const auto sink = format_for(plan.path).open(plan);
    Image picture(64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            picture.set(x, y, {200, 60, 30, static_cast<std::uint8_t>(x < 32 ? 0 : 255)});
    for (int k = 0; k < 4; ++k) sink->write(picture);
    sink->finish();
    for (const Image& shown : frames_of(plan.path)) {
        EXPECT_LE(shown.at(10, 24).a, 2);
        EXPECT_GE(shown.at(54, 24).a, 253);
        EXPECT_NEAR(shown.at(54, 24).r, 200, 4);
        EXPECT_NEAR(shown.at(54, 24).g, 60, 4);
        EXPECT_NEAR(shown.at(54, 24).b, 30, 4);
    }
}

TEST(AlphaFilms, AcceptOddSizes) {
    for (const char* name : {"a.webm", "a.mov"})
        for (const auto& [width, height] : {std::pair{65, 47}, {1, 1}, {3, 200}}) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, 3);
            plan.width_px = width;
            plan.height_px = height;
            write_film(plan);
            const std::vector<Image> frames = frames_of(plan.path);
            ASSERT_EQ(frames.size(), 3u);
            EXPECT_EQ(frames[0].width(), width);
            EXPECT_EQ(frames[0].height(), height);
        }
}

TEST(Webm, HasThePlannedFramesSizeRateAndTags) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.webm", 50);
    plan.rate = {25, 1};
    write_film(plan);
    VideoReader reader(plan.path);
    const VideoInfo& info = reader.info();
    EXPECT_EQ(info.codec, "vp9");
    EXPECT_EQ(info.n_frames, 50);
    EXPECT_EQ(info.rate.numerator, 25);
    EXPECT_EQ(info.rate.denominator, 1);
    EXPECT_NEAR(info.duration_s, 2, 1e-3);
    EXPECT_EQ(info.range, "tv");
    EXPECT_EQ(info.matrix, "bt709");
    EXPECT_EQ(info.texts.at("POINSOT"), plan.metadata);
}

TEST(Mov, HasThePlannedFramesSizeRateAndTags) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.mov", 50);
    plan.rate = {25, 1};
    write_film(plan);
    const VideoInfo info = VideoReader(plan.path).info();
    EXPECT_EQ(info.codec, "prores");
    EXPECT_EQ(info.pixel_format.substr(0, 8), "yuva444p");
    EXPECT_EQ(info.n_frames, 50);
    EXPECT_EQ(info.rate.numerator, 25);
    EXPECT_EQ(info.rate.denominator, 1);
    EXPECT_NEAR(info.duration_s, 2, 1e-3);
    // QuickTime's nclc has no range, and ProRes has only this one: FFmpeg 7 does not say it.
    EXPECT_TRUE(info.range == "tv" || info.range == "unknown") << info.range;
    EXPECT_EQ(info.matrix, "bt709");
    EXPECT_EQ(info.primaries, "bt709");
    EXPECT_EQ(info.transfer, "bt709");
    EXPECT_EQ(info.texts.at("poinsot"), plan.metadata);
    // The sample description "ap4h" with a depth of 32, as Apple writes 4444 with alpha. Source:
    // QuickTime File Format Specification, video sample description.
    const std::string bytes = bytes_of(plan.path);
    const std::size_t entry = bytes.find("ap4h");
    ASSERT_NE(entry, std::string::npos);
    EXPECT_EQ(bytes.substr(entry + 78, 2), std::string("\0\x20", 2));
}

// Whatever the first frame is: a scene may begin opaque and end transparent. Alpha is coded without
// loss; FFmpeg decodes 12 bits, and rounds half of the levels up by one when it makes 8 of them.
TEST(Mov, HasTheAlphaOfEveryFrameAndLevel) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.mov", 3);
    const auto sink = format_for(plan.path).open(plan);
    const auto alpha = [](int k, int x, int y) {
        return static_cast<std::uint8_t>(k == 0 ? 255 : 4 * x + y % 4 + k - 1);
    };
    for (int k = 0; k < 3; ++k) {
        Image picture(64, 48);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) picture.set(x, y, {200, 60, 30, alpha(k, x, y)});
        sink->write(picture);
    }
    sink->finish();
    const std::vector<Image> frames = frames_of(plan.path);
    ASSERT_EQ(frames.size(), 3u);
    int n_wrong = 0;
    for (int k = 0; k < 3; ++k)
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                if (std::abs(frames[static_cast<std::size_t>(k)].at(x, y).a - alpha(k, x, y)) > 1)
                    ++n_wrong;
    EXPECT_EQ(n_wrong, 0);
}

// ProRes codes each frame alone, in whole numbers.
TEST(Mov, IsTheSameForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    std::string first;
    for (const int n_threads : {1, 2, 5}) {
        OutputPlan plan = small_plan(folder / "a.mov", 130);
        plan.encoder_threads = n_threads;
        write_film(plan);
        if (first.empty()) first = bytes_of(plan.path);
        EXPECT_TRUE(bytes_of(plan.path) == first) << n_threads;
    }
}

}  // namespace
}  // namespace poinsot
