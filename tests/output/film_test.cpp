// Films decoded by libavformat: players get the planned properties and pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "image/compare.h"
#include "output/films.h"
#include "output/yuv.h"

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

// Eight cells that show the frame's number in binary, in black and white.
Image spelled(int number) {
    Image image(64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const int bit = x / 16 + 4 * (y / 24);
            const std::uint8_t level = number >> bit & 1 ? 255 : 0;
            image.set(x, y, {level, level, level, 255});
        }
    return image;
}
int read_number(const Image& image) {
    int number = 0;
    for (int bit = 0; bit < 8; ++bit)
        number |= (image.at(16 * (bit % 4) + 8, 24 * (bit / 4) + 12).g > 127 ? 1 : 0) << bit;
    return number;
}

TEST(Films, EveryFrameShowsItsOwnPicture) {
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        const TemporaryFolder folder;
        const OutputPlan plan = small_plan(folder / name, 256);
        const auto sink = format_for(plan.path).open(plan);
        for (int k = 0; k < 256; ++k) sink->write(spelled(k));
        sink->finish();
        const std::vector<Image> frames = frames_of(plan.path);
        ASSERT_EQ(frames.size(), 256u) << name;
        for (int k = 0; k < 256; ++k)
            EXPECT_EQ(read_number(frames[static_cast<std::size_t>(k)]), k) << name;
    }
}

// The first frame as decoded compared with the rendered picture, at the quality of a lecture.
TEST(Films, FirstFrameIsCloseToItsPicture) {
    for (const char* name : {"a.mp4", "a.webm"}) {
        const TemporaryFolder folder;
        OutputPlan plan = small_plan(folder / name, 3);
        plan.width_px = 320;
        plan.height_px = 180;
        plan.quality = "lecture";
        write_film(plan);
        const Image shown = frames_of(plan.path)[0], drawn = frame_of(plan, 0);
        EXPECT_LT(mean_difference(shown, drawn), 2);           // measured 1.27 levels (H.264)
        EXPECT_GT(structural_similarity(shown, drawn), 0.99);  // measured 0.9930
    }
}

// A uniform colour has only rounding errors, so any error of range or matrix would be visible: a
// confusion of BT.601 with BT.709 changes these colours by 8 to 20 levels.
TEST(Mp4, PreservesColours) {
    const std::vector<Rgba8> colours = {
        {255, 0, 0, 255}, {0, 255, 0, 255},     {0, 0, 255, 255},   {255, 255, 255, 255},
        {0, 0, 0, 255},   {128, 128, 128, 255}, {200, 60, 30, 255}, {245, 245, 242, 255}};
    for (const char* name : {"a.mp4", "a.webm"}) {
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

TEST(Films, AreReproducible) {
    std::vector<Image> pictures;
    for (int k = 0; k < 20; ++k) pictures.push_back(synthetic_frame(320, 180, k));
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        for (const char* quality : {"draft", "lecture"}) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, 20);
            plan.width_px = 320;
            plan.height_px = 180;
            plan.quality = quality;
            std::string first;
            for (int run = 0; run < 3; ++run) {
                const auto sink = format_for(plan.path).open(plan);
                for (const Image& picture : pictures) sink->write(picture);
                sink->finish();
                if (run == 0) first = bytes_of(plan.path);
                EXPECT_TRUE(bytes_of(plan.path) == first) << name << " " << quality;
            }
        }
    }
}

TEST(Films, DoNotContainTheirPath) {
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        const TemporaryFolder folder;
        const OutputPlan plan = small_plan(folder / name);
        write_film(plan);
        EXPECT_EQ(bytes_of(plan.path).find("poinsot_test"), std::string::npos) << name;
    }
}

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

TEST(VideoReader, FindsAnyFrame) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        const OutputPlan plan = small_plan(folder / name, 130);
        write_film(plan);
        const std::vector<Image> frames = frames_of(plan.path);
        VideoReader reader(plan.path);
        for (const std::int64_t k : {129, 0, 64, 121, 119, 120, 3})
            EXPECT_TRUE(reader.frame(k) == frames[static_cast<std::size_t>(k)]) << name << " " << k;
        Image next;
        ASSERT_TRUE(reader.read(next));
        EXPECT_TRUE(next == frames[4]);
        EXPECT_NE(input_error_of([&] { reader.frame(130); }).find("has no frame 130; it has 130"),
                  std::string::npos);
        EXPECT_NE(input_error_of([&] { reader.frame(-1); }), "");
    }
}

TEST(VideoReader, RefusesOtherFiles) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.mp4") << "not a film";
    std::ofstream(folder / "empty.mp4") << "";
    for (const char* name : {"a.mp4", "empty.mp4", "missing.mp4", "."})
        EXPECT_NE(input_error_of([&] { VideoReader(folder / name); }).find("cannot be read"),
                  std::string::npos)
            << name;
}

}  // namespace
}  // namespace poinsot
