// Slides: which frames each shows, where it loops, and which stops are refused.
#include "production/slides/slide_plan.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "production/session/session.h"
#include "refusal.h"
#include "scene/files/load_scene.h"
#include "scene/scene_error.h"

namespace poinsot {
namespace {

Session session_with(const std::string& events, const std::string& fps = "10") {
    return session_of(
        parse_scene("[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.5, 0.3, "
                    "0.75]\n[film]\nlength_s = 3.0\nfps = " +
                        fps + "\n" + events,
                    "a.toml", std::vector<Override>{{"film.size", "[96, 54]"}}));
}

std::vector<Slide> slides_with(const std::string& events) {
    const Session session = session_with(events);
    return slides_of(session.scene, film_plan(session), "--slides");
}

std::string refusal_of(const std::string& events) {
    return refusal_message<SceneError>([&] { slides_with(events); });
}

TEST(SlidePlan, EachSlideBeginsWithTheLastFrameOfTheOneBefore) {
    const std::vector<Slide> slides = slides_with(
        "[[stops]]\nat_s = 1.0\ntitle = \"One\"\nnote = \"Ask.\"\n[[stops]]\nat_s = 2.0\n"
        "loop_s = 0.5\n");
    ASSERT_EQ(slides.size(), 3u);
    EXPECT_EQ(slides[0].title, "One");
    EXPECT_EQ(slides[0].note, "Ask.");
    EXPECT_EQ(slides[0].first_frame, 0);
    EXPECT_EQ(slides[0].last_frame, 10);
    EXPECT_EQ(slides[0].n_loop_frames, 0);
    EXPECT_EQ(slides[1].first_frame, 10);
    EXPECT_EQ(slides[1].last_frame, 20);
    EXPECT_EQ(slides[2].first_frame, 20);
    EXPECT_EQ(slides[2].last_frame, 29);
    EXPECT_TRUE(slides[1].is_stop);
    EXPECT_FALSE(slides[2].is_stop);
}

// What follows the last stop has its title and note, so that no slide is without.
TEST(SlidePlan, TheLastSlideHasTheTitleOfTheLastStop) {
    const std::vector<Slide> slides =
        slides_with("[[stops]]\nat_s = 1.0\ntitle = \"One\"\nnote = \"Ask.\"\n");
    ASSERT_EQ(slides.size(), 2u);
    EXPECT_EQ(slides[1].title, "One");
    EXPECT_EQ(slides[1].note, "Ask.");
}

// The frame before the loop is that of the stop a repetition earlier.
TEST(SlidePlan, ALoopLastsItsSecondsAndEndsWithItsStop) {
    const std::vector<Slide> slides =
        slides_with("[[stops]]\nat_s = 2.0\nloop_s = 0.5\n[[stops]]\nat_s = 3.0\nloop_s = 1.0\n");
    ASSERT_EQ(slides.size(), 2u);
    EXPECT_EQ(slides[0].n_loop_frames, 5);
    EXPECT_EQ(slides[0].first_loop_frame(), 16);
    // The film ends at 3 s with frame 29.
    EXPECT_EQ(slides[1].last_frame, 29);
    EXPECT_EQ(slides[1].first_loop_frame(), 20);
}

TEST(SlidePlan, ALoopOfTheWholeFilmHasAllItsFrames) {
    const std::vector<Slide> slides = slides_with("[[stops]]\nat_s = 3.0\nloop_s = 3.0\n");
    ASSERT_EQ(slides.size(), 1u);
    EXPECT_EQ(slides[0].first_loop_frame(), 0);
    EXPECT_EQ(slides[0].n_loop_frames, 30);
}

TEST(SlidePlan, ChaptersServeWithoutStops) {
    const std::string chapters =
        "[[chapters]]\nat_s = 0.0\ntitle = \"A\"\n[[chapters]]\nat_s = 1.5\ntitle = \"B\"\n";
    const std::vector<Slide> slides = slides_with(chapters);
    ASSERT_EQ(slides.size(), 2u);
    EXPECT_EQ(slides[0].title, "A");
    // Texts fade out in the last third of a second of the chapter, which ends with frame 14.
    EXPECT_EQ(slides[0].last_frame, 10);
    EXPECT_EQ(slides[1].first_frame, 10);
    EXPECT_EQ(slides[1].last_frame, 25);
    EXPECT_EQ(slides_with(chapters + "[[stops]]\nat_s = 1.0\n").size(), 2u);
    EXPECT_EQ(slides_with(chapters + "[[stops]]\nat_s = 1.0\n")[0].title, "");
}

TEST(SlidePlan, StopsDoNotIncludeTheRestOfTheFilm) {
    const Session session = session_with("[[stops]]\nat_s = 1.0\n");
    EXPECT_EQ(stops_of(session.scene, film_plan(session), "--chapters").size(), 1u);
}

TEST(SlidePlan, RefusesStopsThatShareTheLastFrame) {
    EXPECT_EQ(refusal_of("[[stops]]\nat_s = 2.9\n[[stops]]\nat_s = 3.0\n"),
              "a.toml:11:1: stops[0] and stops[1] are both at the film's last frame, which is "
              "shown at 2.9 s; remove one of them");
}

TEST(SlidePlan, RefusesStopsOutOfOrderTooCloseBeyondTheEndAndLoopsTooLong) {
    const auto stops = [](const std::string& one, const std::string& two) {
        return refusal_of("[[stops]]\nat_s = " + one + "\n[[stops]]\nat_s = " + two + "\n");
    };
    EXPECT_NE(stops("2.0", "1.0").find("a.toml:11:1: stops[1].at_s is 1, before the 2 s"),
              std::string::npos);
    EXPECT_NE(stops("1.0", "1.0").find("a.toml:11:1: stops[0] and stops[1] are both at 1 s"),
              std::string::npos);
    EXPECT_NE(stops("1.0", "1.05").find("a.toml:11:1: stops[1] is 0.05 s after stops[0]"),
              std::string::npos);
    EXPECT_NE(stops("1.0", "3.5").find("a.toml:11:1: stops[1].at_s is 3.5, but the film ends"),
              std::string::npos);
    EXPECT_NE(stops("1.0", "2.0\nloop_s = 0.05")
                  .find("a.toml:12:1: stops[1].loop_s is 0.05, less than a frame (0.1 s)"),
              std::string::npos);
    EXPECT_NE(stops("1.0", "2.0\nloop_s = 1.5").find("a.toml:12:1: stops[1].loop_s is 1.5"),
              std::string::npos);
}

TEST(SlidePlan, RefusesASceneWithoutStopsAndChapters) {
    EXPECT_EQ(refusal_of(""),
              "a.toml:1:1: the scene has no [[stops]] and no [[chapters]] for --slides; add "
              "[[stops]] with at_s, or leave --slides out");
}

}  // namespace
}  // namespace poinsot
