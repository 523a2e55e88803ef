// MP4 films decoded by libavformat: players get the planned properties and pictures.
#include <gtest/gtest.h>

#include <algorithm>

#include "encoding/films.h"

namespace poinsot {
namespace {

struct Rate {
    FrameRate rate;
    std::int64_t n_frames;
};

TEST(Mp4, HasThePlannedFramesSizeRateAndTags) {
    // 250 frames contain two ends of chunks.
    for (const auto& [rate, n_frames] :
         {Rate{{30, 1}, 250}, {{30000, 1001}, 125}, {{24, 1}, 1}, {{60, 1}, 2}, {{1, 2}, 3}}) {
        const TemporaryFolder folder;
        OutputPlan plan = small_plan(folder / "a.mp4", n_frames);
        plan.rate = rate;
        write_film(plan);
        VideoReader reader(plan.path);
        const VideoInfo& info = reader.info();
        EXPECT_EQ(info.codec, "h264");
        EXPECT_EQ(info.pixel_format, "yuv420p");
        EXPECT_EQ(info.width_px, 64);
        EXPECT_EQ(info.height_px, 48);
        EXPECT_EQ(info.rate.numerator, rate.numerator);
        EXPECT_EQ(info.rate.denominator, rate.denominator);
        EXPECT_EQ(info.n_frames, n_frames);
        // The container stores thousandths of a second.
        EXPECT_NEAR(info.duration_s, static_cast<double>(n_frames) / rate.per_second(), 1e-3);
        EXPECT_EQ(info.range, "tv");
        EXPECT_EQ(info.matrix, "bt709");
        EXPECT_EQ(info.primaries, "bt709");
        EXPECT_EQ(info.transfer, "bt709");
        EXPECT_EQ(info.chroma_location, "left");
        EXPECT_EQ(info.texts.at("poinsot"), plan.metadata);
        EXPECT_EQ(static_cast<std::int64_t>(frames_of(plan.path).size()), n_frames);
    }
}

// A uniform colour has only rounding errors, so any error of range or matrix would be visible: a
// confusion of BT.601 with BT.709 changes these colours by 8 to 20 levels.
TEST(Mp4, PreservesColours) {
    const std::vector<Rgba8> colours = {
        {255, 0, 0, 255}, {0, 255, 0, 255},     {0, 0, 255, 255},   {255, 255, 255, 255},
        {0, 0, 0, 255},   {128, 128, 128, 255}, {200, 60, 30, 255}, {245, 245, 242, 255}};
    for (const char* name : {"a.mp4", "a.webm", "a.mov"}) {
        for (const Rgba8 colour : colours) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, 1);
            plan.quality = "reference";
            Image flat(64, 48);
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 64; ++x) flat.set(x, y, colour);
            const auto sink = format_for(plan.path).open(plan);
            sink->write(flat);
            sink->finish();
            const Rgba8 shown = frames_of(plan.path)[0].at(32, 24);
            // Half a level each of Y', Cb and Cr, through the inverse matrix, and as much from the
            // encoder: measured 1.
            EXPECT_NEAR(shown.r, colour.r, 2) << name;
            EXPECT_NEAR(shown.g, colour.g, 2) << name;
            EXPECT_NEAR(shown.b, colour.b, 2) << name;
        }
    }
}

TEST(Mp4, TransparentPicturesAreBlendedWithWhite) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.mp4", 1);
    const auto sink = format_for(plan.path).open(plan);
    Image clear(64, 48);
    sink->write(clear);
    sink->finish();
    const Rgba8 shown = frames_of(plan.path)[0].at(10, 10);
    EXPECT_GE(shown.r, 253);
    EXPECT_GE(shown.g, 253);
    EXPECT_GE(shown.b, 253);
}

TEST(Mp4, HasItsIndexAtTheFront) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.mp4");
    write_film(plan);
    const std::string bytes = bytes_of(plan.path);
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
    EXPECT_EQ(bytes.find("moof"), std::string::npos);
}

// Whatever the frames around it, a frame at an end decodes to the same pixels.
TEST(Mp4, EncodesTheEndsAloneIfAsked) {
    const TemporaryFolder folder;
    for (const std::string quality : {"draft", "lecture", "print"}) {
        for (const std::int64_t n_frames : {1, 2, 3, 4, 120, 121, 122, 250}) {
            OutputPlan plan = small_plan(folder / "a.mp4", n_frames);
            plan.quality = quality;
            plan.ends_alone = true;
            write_film(plan);
            // The same last picture after others.
            OutputPlan next = small_plan(folder / "b.mp4", 30);
            next.quality = quality;
            next.ends_alone = true;
            const auto sink = format_for(next.path).open(next);
            for (std::int64_t k = 0; k < 30; ++k) sink->write(frame_of(next, n_frames - 1 + k));
            sink->finish();
            VideoReader film(plan.path), after(next.path);
            ASSERT_EQ(film.info().n_frames, n_frames) << quality;
            EXPECT_NEAR(film.info().duration_s, static_cast<double>(n_frames) / 30.0, 1e-3)
                << quality << " " << n_frames;
            EXPECT_TRUE(
                std::ranges::equal(film.frame(n_frames - 1).bytes(), after.frame(0).bytes()))
                << quality << " " << n_frames;
        }
    }
}

}  // namespace
}  // namespace poinsot
