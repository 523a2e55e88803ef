// The instant of a still without --time.
#include "production/still_moment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "drawing/stage.h"
#include "production/scene_summary.h"
#include "scene/load_scene.h"

namespace poinsot::still_moment_tests {
namespace {

// ω returns to the middle axis at the film's end, where its arrow lies on that of e2.
const std::string racket =
    "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.01, 2.0, 0.01]\n";

Session session_with(const std::string& text) { return session_of(parse_scene(text, "a.toml")); }

// The least distance of two arrows that are not always parallel, of ω and e2 at least.
double least_separation_px(const Session& session, double time_s) {
    const FilmPlan film = film_plan(session);
    const Stage stage(session.scene, session.motion,
                      {.first_time_s = film.start_s, .last_time_s = film.last_time_s()});
    const auto arrows = stage.arrows_at(moment_of_time(film.clock, time_s));
    double least = INFINITY;
    for (std::size_t i = 0; i < arrows.size(); ++i)
        for (std::size_t j = i + 1; j < arrows.size(); ++j)
            if (arrows[i].direction.cross(arrows[j].direction).norm() > 1e-12)
                least = std::min(least, separation_px(arrows[i], arrows[j]));
    return least;
}

TEST(StillMoment, IsOneAtWhichNoTwoArrowsCoincide) {
    // Seven seconds: about half a period, back at the middle axis.
    const Session session = session_with(racket + "[film]\nduration_s = 7.2\n");
    const FilmTime chosen = still_moment(session, {}, StillTime::of_scene);
    const double last_s = film_plan(session).last_time_s();
    EXPECT_LT(least_separation_px(session, last_s), 20.0);
    EXPECT_GT(least_separation_px(session, chosen.time_s), 30.0);
    EXPECT_GE(chosen.time_s, 0.0);
    EXPECT_LE(chosen.time_s, last_s);
    // The same at every size, and each time.
    const Session small = session_with(racket + "[film]\nduration_s = 7.2\nsize = [640, 360]\n");
    EXPECT_EQ(still_moment(small, {}, StillTime::of_scene).time_s, chosen.time_s);
}

TEST(StillMoment, IsTheLastOfTheFilmWhereArrowsAreApart) {
    const Session session = session_with(
        "show = [\"plane\", \"momentum\"]\n[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n"
        "[start]\nomega_rad_s = [1.5, 0.3, 0.75]\n[film]\nduration_s = 3\n");
    const FilmPlan film = film_plan(session);
    EXPECT_EQ(still_moment(session, {}, StillTime::of_scene).time_s, film.last_time_s());
}

TEST(StillMoment, IsTheSceneOwnUnlessAskedOtherwise) {
    const Session session = session_with(racket + "[film]\nduration_s = 7.2\nstill_s = 7.1\n");
    EXPECT_EQ(still_moment(session, {}, StillTime::of_scene).time_s, 7.1);
    EXPECT_EQ(still_moment(session, {}, StillTime::common).time_s, 7.1);
    EXPECT_EQ(still_moment(session, 3.5, StillTime::of_scene).time_s, 3.5);
    const Session plain = session_with(racket + "[film]\nduration_s = 7.2\n");
    EXPECT_EQ(still_moment(session, {}, StillTime::clearest).time_s,
              still_moment(plain, {}, StillTime::of_scene).time_s);
    EXPECT_EQ(still_moment(plain, {}, StillTime::common).time_s, film_plan(plain).last_time_s());
}

// check, beyond constants.

std::string json_of(const Session& session, const std::string& key) {
    for (const SummaryLine& line : summarise(session, false).lines)
        if (line.key == key) return line.json;
    return "";
}
std::string text_of_line(const Session& session, const std::string& key) {
    for (const SummaryLine& line : summarise(session, false).lines)
        if (line.key == key) return line.label + ": " + line.text;
    return "";
}

TEST(StillMoment, CheckSaysWhenTheBodyFlips) {
    // Twice as slow, from t = 1 s: a flip at t is at second 2(t − 1) of the film.
    const Session session =
        session_with(racket + "[film]\nstart_s = 1\nduration_s = 20\nspeed = 0.5\n");
    const std::string times = json_of(session, "flips_s");
    const std::string film_times = json_of(session, "flips_film_s");
    const double first_s = std::stod(times.substr(1));
    EXPECT_NEAR(session.motion.at(first_s).omega_body[1], 0.0, 1e-12);
    EXPECT_NEAR(std::stod(film_times.substr(1)), 2.0 * (first_s - 1.0), 1e-9);
    EXPECT_NEAR(std::stod(json_of(session, "flip_interval_s")),
                0.5 * *session.motion.free_constants().polhode_period_s, 1e-12);
    const std::string text = text_of_line(session, "flips_s");
    EXPECT_EQ(text.find("flips (\u03c9 along e2, the middle axis, changes its sign): at t = "), 0u)
        << text;
    // A wobble about another axis does not flip.
    EXPECT_EQ(json_of(session_with("[body]\nmoments_kg_m2 = [1.0, 2.0, 3.0]\n[start]\n"
                                   "omega_rad_s = [0.5, 0.3, 2.5]\n"),
                      "flips_s"),
              "");
}

TEST(StillMoment, CheckNamesLoopsNearby) {
    const std::string motion =
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.5, 0.3, 0.75]\n";
    const Session session = session_with(motion);
    const std::string text = text_of_line(session, "near_loops");
    EXPECT_NE(text.find("\"7/4\" (omega_"), std::string::npos) << text;
    // A loop named there is accepted, and then there is nothing more to name.
    const Session loop = session_with(motion + "[film]\nloop = \"7/4\"\n");
    ASSERT_TRUE(loop.loop);
    EXPECT_EQ(json_of(loop, "near_loops"), "");
}

}  // namespace
}  // namespace poinsot::still_moment_tests
