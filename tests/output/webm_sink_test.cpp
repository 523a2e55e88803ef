// WebM films decoded by libavformat: their properties, transparency and odd sizes.
#include <gtest/gtest.h>

#include "output/films.h"

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

TEST(Webm, AcceptsOddSizes) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.webm", 3);
    plan.width_px = 65;
    plan.height_px = 47;
    write_film(plan);
    const std::vector<Image> frames = frames_of(plan.path);
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[0].width(), 65);
    EXPECT_EQ(frames[0].height(), 47);
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

}  // namespace
}  // namespace poinsot
