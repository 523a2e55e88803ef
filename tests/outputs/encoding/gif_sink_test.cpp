// GIF films: colours, durations and transparency.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "encoding/films.h"

namespace poinsot {
namespace {

TEST(Gif, KeepsFewColoursExactly) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.gif", 3);
    const auto sink = format_for(plan.path).open(plan);
    std::vector<Image> pictures;
    for (int k = 0; k < 3; ++k) {
        Image picture(64, 48);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                picture.set(x, y,
                            (x / 8 + y / 8 + k) % 2
                                ? Rgba8{245, 245, 242, 255}
                                : Rgba8{static_cast<std::uint8_t>(10 * (x / 8)), 30, 200, 255});
        pictures.push_back(picture);
        sink->write(picture);
    }
    sink->finish();
    const std::vector<Image> frames = frames_of(plan.path);
    ASSERT_EQ(frames.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(frames[k] == pictures[k]) << k;
}

TEST(Gif, ApproximatesSmoothPictures) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.gif", 10);
    plan.width_px = 320;
    plan.height_px = 180;
    write_film(plan);
    const std::vector<Image> frames = frames_of(plan.path);
    ASSERT_EQ(frames.size(), 10u);
    for (std::int64_t k = 0; k < 10; ++k)
        EXPECT_LT(mean_difference(frames[static_cast<std::size_t>(k)], frame_of(plan, k)), 0.5);
    VideoReader reader(plan.path);
    // Hundredths of a second: 3, 3, 4, …
    EXPECT_NEAR(reader.info().duration_s, 10 / 30.0, 0.011);
    EXPECT_EQ(reader.info().texts.at("comment"), plan.metadata);
}

// GIF89a §23: a graphic control extension begins with 21 F9 04, flags, and the delay in hundredths.
TEST(Gif, EveryFrameStaysUntilTheNextAndTheLastUntilTheEnd) {
    const TemporaryFolder folder;
    for (const auto& [fps, n_frames] : {std::pair(30, 10), std::pair(24, 7), std::pair(24, 1),
                                        std::pair(50, 3), std::pair(7, 5)}) {
        OutputPlan plan = small_plan(folder / fmt::format("{}_{}.gif", fps, n_frames), n_frames);
        plan.rate = {fps, 1};
        write_film(plan);
        const std::string bytes = bytes_of(plan.path);
        const std::string head("\x21\xf9\x04", 3);
        int frame = 0, ends = 0;
        for (std::size_t at = bytes.find(head); at != std::string::npos;
             at = bytes.find(head, at + 1)) {
            ends += static_cast<unsigned char>(bytes[at + 4]) +
                    256 * static_cast<unsigned char>(bytes[at + 5]);
            EXPECT_EQ(ends, std::lround(100.0 * ++frame / fps)) << fps << " " << frame;
        }
        EXPECT_EQ(frame, n_frames);
    }
}

TEST(Gif, ClearsTransparentPixelsBehindMovingObjects) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.gif", 4);
    const auto sink = format_for(plan.path).open(plan);
    for (int k = 0; k < 4; ++k) {
        Image picture(64, 48);
        for (int y = 10; y < 20; ++y)
            for (int x = 10 * k; x < 10 * k + 10; ++x) picture.set(x, y, {200, 0, 0, 255});
        sink->write(picture);
    }
    sink->finish();
    const std::vector<Image> frames = frames_of(plan.path);
    ASSERT_EQ(frames.size(), 4u);
    for (int k = 0; k < 4; ++k)
        for (int column = 0; column < 6; ++column)
            EXPECT_EQ(frames[static_cast<std::size_t>(k)].at(10 * column + 5, 15).a,
                      column == k ? 255 : 0)
                << "frame " << k << " column " << column;
}

}  // namespace
}  // namespace poinsot
