// The instant of a still without --time.
#include "production/session/still_moment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "drawing/stage/stage.h"
#include "places.h"
#include "production/session/picture_setting.h"
#include "scene/files/load_scene.h"
#include "scene/parse_scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::still_moment_tests {
namespace {

// ω returns to the middle axis at the film's end, where its arrow lies on that of e2.
const std::string racket =
    "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.01, 2.0, 0.01]\n";

Session session_with(const std::string& text) {
    return session_of(parse_scene(text, "a.toml"), {.fonts = installed_fonts()});
}

// The least distance of two arrows that are not always parallel, of ω and e2 at least.
double least_separation_px(const Session& session, double time_s) {
    const FilmPlan film = film_plan(session);
    const Stage stage(
        session.scene, session.theme, session.motion,
        {.first_time_s = film.start_s, .last_time_s = film.last_time_s(), .fonts = session.fonts});
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

// A picture on paper has another shape, also where its panels stand in more rows.
TEST(StillMoment, IsTheSameOnPaper) {
    const std::string film = racket + "[film]\nduration_s = 7.2\n";
    const double screen_s = still_moment(session_with(film), {}, StillTime::of_scene).time_s;
    for (const char* size : {"[1004, 1400]", "[1280, 480]", "[720, 1280]"}) {
        const Session session = session_with(film + "size = " + size + "\n");
        EXPECT_EQ(still_moment(session, {}, StillTime::of_scene).time_s, screen_s) << size;
    }
}

TEST(StillMoment, OfEverySuppliedSceneIsChosenByEye) {
    for (const auto& file : supplied_scenes())
        EXPECT_TRUE(load_scene(file, {}).film.still_s) << file;
}

// A trail of the entire film is entire in a still as well.
TEST(StillMoment, AStillShowsTheWholeTrailOfItsFilm) {
    const std::string text =
        "[body]\nmoments_kg_m2 = [5.5, 4.5, 1.2]\n[start]\nomega_rad_s = [0.8, 0.9, 2.4]\n"
        "[film]\nduration_s = 16\n[trail]\nherpolhode = ";
    // The points of the herpolhode that a still at three seconds shows.
    const auto shown = [](const Session& session) {
        const FilmPlan film = film_plan(session);
        PictureSpan span = span_of_instant(session, film, 3.0);
        span.is_still = true;
        const Stage stage = stage_of(session, span, setting_of(session.scene));
        double px = 0.0;
        const Drawing drawing = stage.at(moment_of_time(film.clock, 3.0));
        for (const View& view : drawing.views)
            for (const Curve& curve : view.curves)
                if (curve.name == ShapeName{"herpolhode", 0, ""})
                    for (std::size_t k = 1; k < curve.geometry->points.size(); ++k)
                        if (static_cast<double>(k) <= curve.last &&
                            static_cast<double>(k) > curve.first)
                            px +=
                                (curve.geometry->points[k] - curve.geometry->points[k - 1]).norm();
        return px;
    };
    const double whole = shown(session_with(text + "\"whole\"\n"));
    const double history = shown(session_with(text + "\"history\"\n"));
    // Sixteen seconds instead of three.
    EXPECT_GT(whole, 4.0 * history);
    EXPECT_GT(history, 0.1);
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

}  // namespace
}  // namespace poinsot::still_moment_tests
