// Looping films: the frame after the last equals the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "production/session/session.h"
#include "production/stills/picture.h"
#include "scene/files/load_scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {

namespace {

const std::string motion =
    "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.5, 0.3, 0.75]\n";

Session session_from(const std::string& text) {
    return session_of(
        parse_scene(motion + text, "a.toml", std::vector<Override>{{"film.size", "[240, 136]"}}),
        {installed_fonts()});
}

// Largest difference of any component of any pixel, in levels of 255.
int largest_difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.bytes().size(), b.bytes().size());
    int largest = 0;
    for (std::size_t i = 0; i < std::min(a.bytes().size(), b.bytes().size()); ++i) {
        largest = std::max(largest, std::abs(a.bytes()[i] - b.bytes()[i]));
    }
    return largest;
}

struct Ends {
    int levels_around = 0;  // between the first frame and the one after the last
    int levels_step = 0;    // between the first frame and the second
};

Ends ends_of(const std::string& text) {
    const Session session = session_from(text);
    const FilmPlan film = film_plan(session);
    EXPECT_GT(film.repeat_s, 0.0);
    LazyRenderer renderer;
    PictureMaker pictures(
        session, renderer,
        {.first_time_s = film.time_of(0), .last_time_s = film.time_of(film.n_frames - 1)});
    Image first, second, past;
    pictures.draw(film.moment_of(0), first);
    pictures.draw(film.moment_of(1), second);
    pictures.draw(film.moment_of(film.n_frames), past);
    return {largest_difference(first, past), largest_difference(first, second)};
}

TEST(Loop, OfTurnsOverPeriodsIsSeamless) {
    for (const std::string trail : {"history", "fading", "whole"}) {
        const Ends ends = ends_of("[film]\nloop = \"5/3\"\n[trail]\nherpolhode = \"" + trail +
                                  "\"\npolhode = \"" + trail + "\"\n");
        EXPECT_LE(ends.levels_around, 1) << trail;
        // The frames between are different.
        EXPECT_GT(ends.levels_step, 20) << trail;
    }
}

TEST(Loop, OfAPeriodIsSeamlessForATurningCamera) {
    const std::string panels =
        "[[panels]]\nkind = \"space\"\n[[panels]]\nkind = \"plan\"\ncolumn = 1\n"
        "[[panels]]\nkind = \"object\"\ncolumn = 2\n";
    const Ends ends =
        ends_of("[camera]\nmotion = \"co-precessing\"\n[trail]\ndirection_marks = true\n" + panels);
    EXPECT_LE(ends.levels_around, 1);
    EXPECT_GT(ends.levels_step, 20);
}

TEST(Loop, OfAPeriodIsNotSeamlessForAFixedCamera) {
    // Otherwise the test above would prove nothing.
    const Session session = session_from("[camera]\nmotion = \"co-precessing\"\n");
    Session fixed = session_from("");
    const FilmPlan film = film_plan(session);
    LazyRenderer renderer;
    PictureMaker pictures(fixed, renderer, {.first_time_s = 0.0, .last_time_s = film.repeat_s});
    Image first, past;
    pictures.draw({0.0, 0.0}, first);
    pictures.draw({film.repeat_s, film.repeat_s}, past);
    EXPECT_GT(largest_difference(first, past), 20);
}

TEST(FilmPictures, DoNotDependOnEarlierPictures) {
    // Contents cached by the renderer must be redrawn when they fade or the camera moves, and only
    // then: here a camera that moves and stops, and a plane and a title that fade in.
    const Session session = session_from(
        "[film]\nlength_s = 4\nfps = 4\n[[keyframes]]\nat_s = 1\nview = \"lecture\"\n"
        "[[keyframes]]\nat_s = 2\nview = \"high\"\nspeed = 0\n"
        "[[fades]]\nat_s = 0\nelements = [\"plane\", \"momentum\"]\n"
        "[[fades]]\nat_s = 2.5\nelements = [\"ellipsoid\", \"title\", \"clock\"]\nopacity = 0\n");
    const FilmPlan film = film_plan(session);
    const PictureSpan span{film.time_of(0), film.last_time_s()};
    LazyRenderer renderer;
    PictureMaker all(session, renderer, span);
    for (std::int64_t k = 0; k < film.n_frames; ++k) {
        Image in_order, alone;
        all.draw(film.moment_of(k), in_order);
        PictureMaker fresh(session, renderer.context(), span, {1.0, 1});
        fresh.draw(film.moment_of(k), alone);
        EXPECT_EQ(largest_difference(in_order, alone), 0) << "frame " << k;
    }
}

TEST(Loop, HasEquallySpacedFrames) {
    const Session session = session_from("[film]\nloop = \"5/3\"\nfps = 7\n");
    const FilmPlan film = film_plan(session);
    const double step_s = film.repeat_s / static_cast<double>(film.n_frames);
    for (std::int64_t k = 0; k <= film.n_frames; ++k) {
        // Rounding of a product of two doubles and a sum; measured 4e-15.
        EXPECT_NEAR(film.time_of(k), static_cast<double>(k) * step_s, 1e-13);
    }
    // The steps agree with the given rate up to half a frame in the whole film.
    EXPECT_NEAR(step_s * 7.0, 1.0, 0.5 / static_cast<double>(film.n_frames));
}

TEST(Loop, FitsTheGivenLengthAndKeepsSlowMotion) {
    const Session session = session_from(
        "[film]\nloop = \"5/3\"\nlength_s = 12\n[[keyframes]]\nat_s = 4\nspeed = 1\n"
        "[[keyframes]]\nat_s = 6\nspeed = 0.2\n[[keyframes]]\nat_s = 10\nspeed = 1\n");
    const FilmPlan film = film_plan(session);
    EXPECT_EQ(film.n_frames, 360);
    EXPECT_NEAR(film.time_of(film.n_frames), film.repeat_s, 1e-12 * film.repeat_s);
    // The ratio of speeds is unchanged.
    EXPECT_NEAR(film.clock.speed_at(6.0) / film.clock.speed_at(4.0), 0.2, 1e-12);
}

TEST(Loop, ReportsChangesOfTheStartWithTheirSize) {
    const Session session =
        session_from("[film]\nloop = \"5/3\"\nloop_changes = \"omega_body_1\"\n");
    ASSERT_EQ(session.notes.size(), 1u);
    const std::string& note = session.notes[0];
    EXPECT_EQ(note.rfind("film.loop = \"5/3\": omega_body_1 was changed from 1.5 to ", 0), 0u)
        << note;
    EXPECT_NE(note.find("% of |omega|"), std::string::npos) << note;
    EXPECT_EQ(session.scene.start.omega_rad_s[1], 0.3);
    EXPECT_EQ(session.scene.start.omega_rad_s[2], 0.75);
}

// I₂ = 2: L² = 2T·I₂ holds exactly, though ω is rounded.
TEST(Loop, OfAStartOnTheSeparatrixIsRefused) {
    const std::string start =
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nenergy_J = 1.0\nmomentum_kg_m2_s = "
        "2.0\n";
    const auto open = [&](const std::string& text) {
        return session_of(parse_scene(start + text, "a.toml"));
    };
    EXPECT_EQ(open("").motion.regime(), Regime::separatrix);
    EXPECT_THROW(open("[film]\nloop = \"5/3\"\n"), SceneError);
    EXPECT_THROW(open("[film]\nloop = \"period\"\n[camera]\nmotion = \"co-precessing\"\n"),
                 SceneError);
    // Where a loop is the default only, the film has none.
    EXPECT_FALSE(open("[camera]\nmotion = \"co-precessing\"\n").loop);
}

}  // namespace

}  // namespace poinsot
