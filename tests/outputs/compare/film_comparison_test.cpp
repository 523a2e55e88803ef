// Films frame by frame, by sequences whose differences are known; the formats of films are compared
// in tests/doors/cli/compare_test.cpp.
#include "compare/film_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/compared_picture.h"
#include "compare/report_pictures.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/synthetic.h"
#include "system/faults.h"

namespace poinsot {
namespace {

class Sequences : public ::testing::Test {
 protected:
    // Frames with a mark of so many levels; 0: none.
    std::filesystem::path draw(const std::string& name, const std::vector<int>& levels,
                               int width = 32) const {
        std::filesystem::path pattern = folder_ / (name + "_###.png");
        for (std::size_t k = 0; k < levels.size(); ++k) {
            Image image = synthetic_frame(width, 18, static_cast<int>(k));
            Rgba8 colour = image.at(3, 3);
            colour.g = static_cast<std::uint8_t>(std::abs(colour.g - levels[k]));
            image.set(3, 3, colour);
            write_png(frame_name(pattern, static_cast<std::int64_t>(k) + 7), image);
        }
        return pattern;
    }
    static FilmDifferences compared(const std::filesystem::path& a, const std::filesystem::path& b,
                                    int n_threads = 3,
                                    CompareLimits limits = CompareLimits::exact(),
                                    std::vector<PictureRegion> ignored = {}) {
        FrameStream expected(a), actual(b);
        return compare_films(
            expected, actual, limits,
            [&ignored](std::int64_t, int, int) { return CompareExtras{.ignored = ignored}; },
            n_threads);
    }
    TemporaryFolder folder_;
};

TEST_F(Sequences, ThatAreEqualHaveNoDifference) {
    const auto a = draw("a", std::vector<int>(12, 0)), b = draw("b", std::vector<int>(12, 0));
    const FilmDifferences film = compared(a, b);
    EXPECT_EQ(film.n_expected, 12);
    EXPECT_EQ(film.n_compared, 12);
    EXPECT_EQ(film.n_differing, 0);
    EXPECT_EQ(film.measured.verdict, Verdict::same);
    EXPECT_EQ(in_words(film), "");
    EXPECT_TRUE(film.strip.empty());
}

TEST_F(Sequences, NameTheFirstAndTheWorstFrame) {
    const auto a = draw("a", std::vector<int>(60, 0));
    std::vector<int> levels(60, 0);
    levels[4] = 1, levels[5] = 3, levels[20] = 9, levels[21] = 40, levels[22] = 8, levels[58] = 20;
    const auto b = draw("b", levels);
    for (const int n_threads : {1, 2, 3}) {
        const FilmDifferences film = compared(a, b, n_threads);
        EXPECT_EQ(film.n_differing, 6);
        EXPECT_EQ(film.n_failing, 6);
        EXPECT_EQ(film.first, 4);
        EXPECT_EQ(film.worst, 21);
        EXPECT_EQ(film.measured.largest_difference, 40);
        EXPECT_EQ(in_words(film),
                  "6 of 60 frames exceed the limits; first frame 4, worst frame 21");
        // Of frames within half a second only the worst is kept; the pictures are those frames'.
        ASSERT_EQ(film.strip.size(), 3u);
        EXPECT_EQ(film.strip[0].frame, 5);
        EXPECT_EQ(film.strip[1].frame, 21);
        EXPECT_EQ(film.strip[2].frame, 58);
        EXPECT_EQ(film.strip[1].expected.image, synthetic_frame(32, 18, 21));
        EXPECT_EQ(film_strip(film.strip, 1000).width(), 3 * 32);
        EXPECT_EQ(film_strip(film.strip, 1000).height(), 3 * 18);
    }
}

// The first frame that exceeds the limits counts, not the first that differs.
TEST_F(Sequences, NameTheFirstFrameThatFails) {
    const auto a = draw("a", {0, 0, 0, 0}), b = draw("b", {0, 2, 0, 30});
    const CompareLimits limits{.differing_share = 1, .level = 5, .over_level_share = 0};
    const FilmDifferences film = compared(a, b, 3, limits);
    EXPECT_EQ(film.n_differing, 2);
    EXPECT_EQ(film.n_failing, 1);
    EXPECT_EQ(film.first, 3);
    EXPECT_EQ(in_words(film), "1 of 4 frames exceeds the limits; first frame 3, worst frame 3");
    const FilmDifferences mild = compared(a, draw("c", {0, 2, 4, 0}), 3, limits);
    EXPECT_EQ(in_words(mild),
              "2 of 4 frames differ within the limits; first frame 1, worst frame 2");
    EXPECT_TRUE(mild.measured.passes());
}

TEST_F(Sequences, KeepFiveOfManyFramesWithTheWorst) {
    std::vector<int> levels(300, 0);
    for (std::size_t k = 0; k < levels.size(); ++k)
        levels[k] = 1 + static_cast<int>(40 * std::abs(std::sin(0.02 * static_cast<double>(k))));
    const FilmDifferences film = compared(draw("a", std::vector<int>(300, 0)), draw("b", levels));
    ASSERT_EQ(film.strip.size(), 5u);
    bool has_worst = false;
    for (const KeptFrames& kept : film.strip) has_worst = has_worst || kept.frame == film.worst;
    for (std::size_t i = 1; i < film.strip.size(); ++i)
        EXPECT_GT(film.strip[i].frame / 15, film.strip[i - 1].frame / 15);
    EXPECT_TRUE(has_worst);
}

// Each frame of a drift is worse than the one before; each half second still has one in the strip.
TEST_F(Sequences, KeepFramesOfASteadyDrift) {
    std::vector<int> levels(90, 0);
    for (std::size_t k = 0; k < levels.size(); ++k) levels[k] = 1 + static_cast<int>(k);
    const FilmDifferences film = compared(draw("a", std::vector<int>(90, 0)), draw("b", levels));
    std::vector<std::int64_t> frames;
    for (const KeptFrames& kept : film.strip) frames.push_back(kept.frame);
    EXPECT_EQ(frames, (std::vector<std::int64_t>{29, 44, 59, 74, 89}));
}

TEST_F(Sequences, OfDifferentLengthsAreComparedAsFarAsBothGo) {
    const auto a = draw("a", std::vector<int>(9, 0)), b = draw("b", std::vector<int>(6, 0));
    EXPECT_EQ(in_words(compared(a, b)), "expected 9 frames, found 6; of the first 6, none differs");
    EXPECT_EQ(in_words(compared(b, a)), "expected 6 frames, found 9; of the first 6, none differs");
    const auto c = draw("c", {0, 0, 5});
    EXPECT_EQ(in_words(compared(a, c)),
              "expected 9 frames, found 3; of the first 3, 1 exceeds the limits; first frame 2, "
              "worst frame 2");
}

TEST_F(Sequences, OfDifferentSizesEndAtOnce) {
    const FilmDifferences film =
        compared(draw("a", std::vector<int>(9, 0)), draw("b", std::vector<int>(9, 0), 40));
    EXPECT_EQ(film.measured.verdict, Verdict::size_differs);
    EXPECT_EQ(film.n_compared, 1);
}

// However strongly an earlier frame differs.
TEST_F(Sequences, ThatChangeTheirSizeEndThere) {
    const auto a = draw("a", std::vector<int>(9, 0));
    const auto b = draw("b", {0, 90, 0, 0, 0, 0, 0, 0, 0});
    for (const std::int64_t frame : {5, 6, 7, 8})
        write_png(frame_name(b, frame + 7), synthetic_frame(40, 18, static_cast<int>(frame)));
    for (const int n_threads : {1, 2, 8}) {
        const FilmDifferences film = compared(a, b, n_threads);
        EXPECT_EQ(film.measured.verdict, Verdict::size_differs);
        EXPECT_EQ(film.worst, 5);
        EXPECT_EQ(film.n_compared, 6);
    }
    const ComparedPicture picture = compare_files("b", a, b, {});
    EXPECT_EQ(picture.outcome, Outcome::size);
    EXPECT_EQ(picture.reason, "frame 5: expected 32×18 pixels, found 40×18");
}

// Several pairs are compared at the same time, and taken in their order.
TEST_F(Sequences, AreComparedAlikeByAnyNumberOfThreads) {
    std::vector<int> levels(50, 0);
    for (std::size_t k = 0; k < levels.size(); ++k) levels[k] = static_cast<int>(k * k % 23);
    const auto a = draw("a", std::vector<int>(47, 0)), b = draw("b", levels);
    const auto said = [&](int n_threads) {
        const FilmDifferences film = compared(a, b, n_threads);
        std::string text = in_words(film) + film.measured.reason;
        for (const KeptFrames& kept : film.strip) {
            text += " " + std::to_string(kept.frame);
            EXPECT_EQ(kept.expected.image, synthetic_frame(32, 18, static_cast<int>(kept.frame)));
        }
        return text;
    };
    const std::string alone = said(1);
    EXPECT_EQ(alone.find("expected 47 frames, found 50; of the first 47, 44 exceed"), 0u) << alone;
    for (const int n_threads : {2, 3, 4, 46, 47, 48, 60}) EXPECT_EQ(said(n_threads), alone);
}

// Nothing is left to compare, though the films differ.
TEST_F(Sequences, WhoseWholePictureIsIgnoredFail) {
    const auto a = draw("a", {0, 0, 0}), b = draw("b", {0, 9, 0});
    const ComparedPicture picture =
        compare_files("b", a, b, {.given = {.ignore = {parse_region("0%,0%,100%,100%")}}});
    EXPECT_EQ(picture.outcome, Outcome::region);
    EXPECT_NE(picture.reason.find("nothing is compared"), std::string::npos) << picture.reason;
    EXPECT_EQ(compare_files("b", a, b, {.given = {.ignore = {parse_region("3,3,1,1")}}}).outcome,
              Outcome::within_limits);
}

// A picture may have # in its name.
TEST_F(Sequences, AreNotPicturesOfThatName) {
    const auto a = draw("a", {0, 0});
    EXPECT_TRUE(is_sequence_name(a));
    write_png(a, synthetic_frame(32, 18, 0));
    EXPECT_FALSE(is_sequence_name(a));
    EXPECT_EQ(compare_files("a", a, frame_name(a, 7), {}).outcome, Outcome::same);
    EXPECT_EQ(compare_files("a", a, frame_name(a, 8), {}).outcome, Outcome::pixels);
}

TEST_F(Sequences, IgnoreRegions) {
    const auto a = draw("a", {0, 0}), b = draw("b", {0, 9});
    EXPECT_TRUE(compared(a, b, 3, CompareLimits::exact(), {{3, 3, 1, 1}}).measured.passes());
    EXPECT_FALSE(compared(a, b, 3, CompareLimits::exact(), {{4, 3, 1, 1}}).measured.passes());
}

TEST_F(Sequences, WithGapsOrWithoutPicturesAreRefused) {
    const auto a = draw("a", std::vector<int>(5, 0));
    std::filesystem::remove(frame_name(a, 9));
    try {
        const FrameStream stream(a);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(
            std::string(error.what()).find("a_009.png: this picture of the sequence is missing"),
            std::string::npos)
            << error.what();
    }
    EXPECT_THROW(FrameStream(folder_ / "none_##.png"), InputError);
    EXPECT_THROW(FrameStream(folder_ / "none.mp4"), InputError);
}

}  // namespace
}  // namespace poinsot
