// The film's clock is the integral of its speed at any second, independent of the frames before.
#include "scene/film_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scene/easing.h"
#include "scene_text.h"

namespace poinsot {

namespace {

Scene film(const std::string& text) { return scene_of(a_scene + text); }

// ∫ f over [from, to] by Simpson's rule on n pieces: independent of the closed forms.
template <typename Function>
double integrated(const Function& f, double from, double to, int n) {
    const double h = (to - from) / n;
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
        const double x = from + k * h;
        sum += h / 6.0 * (f(x) + 4.0 * f(x + 0.5 * h) + f(x + h));
    }
    return sum;
}

TEST(Easings, GoFromZeroToOneAndMatchTheirIntegral) {
    for (const Easing& easing : easings()) {
        EXPECT_EQ(easing.value(0.0), 0.0) << easing.name;
        EXPECT_EQ(easing.value(1.0), 1.0) << easing.name;
        EXPECT_EQ(easing.integral(0.0), 0.0) << easing.name;
        for (const double u : {0.1, 0.25, 0.5, 0.9, 0.999}) {
            // Simpson's error decreases with the fourth power: 4e-10 on 64 pieces, so 7e-15 on
            // 1024.
            EXPECT_NEAR(easing.integral(u), integrated(easing.value, 0.0, u, 1024), 1e-13)
                << easing.name << " at " << u;
        }
    }
}

TEST(FilmClock, OfConstantSpeedIsTheExactProduct) {
    const FilmClock clock(film("[film]\nstart_s = 3\nspeed = 0.1\nduration_s = 2\n"));
    std::mt19937_64 random(1);
    for (int k = 0; k < 1000; ++k) {
        const double film_s = std::uniform_real_distribution(0.0, 1e5)(random);
        EXPECT_EQ(clock.time_at(film_s), 3.0 + 0.1 * film_s);
    }
    EXPECT_EQ(clock.length_s(), 2.0 / 0.1);
}

const std::string slow_motion =
    "[film]\nstart_s = 1\nlength_s = 30\nspeed = 2\n"
    "[[keyframes]]\nat_s = 4\nspeed = 2\n"
    "[[keyframes]]\nat_s = 6\nspeed = 0.1\neasing = \"smoother\"\n"
    "[[keyframes]]\nat_s = 9\nspeed = 0\neasing = \"out\"\n"
    "[[keyframes]]\nat_s = 11\nspeed = 0\n"
    "[[keyframes]]\nat_s = 12\nspeed = 1.5\neasing = \"in\"\n"
    "[[keyframes]]\nat_s = 20\nspeed = 3\neasing = \"hold\"\n";

TEST(FilmClock, IsTheIntegralOfItsSpeed) {
    const FilmClock clock(film(slow_motion));
    const double keys[] = {0.0, 4.0, 6.0, 9.0, 11.0, 12.0, 20.0, 30.0};
    double sum_s = 1.0;
    for (int i = 0; i < 7; ++i) {
        for (const double share : {0.3, 1.0}) {
            const double to = keys[i] + share * (keys[i + 1] - keys[i]);
            // Just before a jump, which "hold" causes at its end.
            const double until = std::nexttoward(to, 0.0);
            const double here = sum_s + integrated([&](double s) { return clock.speed_at(s); },
                                                   keys[i], until, 256);
            EXPECT_NEAR(clock.time_at(to), here, 1e-9) << to;  // measured 2e-12
            if (share == 1.0) sum_s = here;
        }
    }
    // By hand: 2·4, a mean of 1.05 over 2, 0.1/3 over 3, none, 0.5 over 1, 1.5·8, then 3·10.
    EXPECT_NEAR(clock.time_at(30.0), 1.0 + 8.0 + 2.1 + 0.1 + 0.0 + 0.5 + 12.0 + 30.0, 1e-13);
}

TEST(FilmClock, NeverGoesBackAndItsInverseIsTheFirstSecond) {
    const FilmClock clock(film(slow_motion));
    double before_s = clock.time_at(0.0);
    for (int k = 1; k <= 30'000; ++k) {
        const double time_s = clock.time_at(0.001 * k);
        EXPECT_GE(time_s, before_s) << k;
        before_s = time_s;
    }
    for (const double film_s : {0.0, 1.0, 4.0, 5.0, 7.7, 11.6, 15.0, 20.0, 25.0, 100.0}) {
        const auto found = clock.film_second_of(clock.time_at(film_s));
        ASSERT_TRUE(found);
        // With speed v, an ulp of the time is an ulp/v of the second; measured 4e-14
        EXPECT_NEAR(*found, film_s, 1e-12 * (1.0 + film_s) / std::min(1.0, clock.speed_at(film_s)))
            << film_s;
    }
    // While the motion is stopped, every second shows one instant: the inverse is the first of
    // them.
    const auto rest = clock.film_second_of(clock.time_at(10.0));
    ASSERT_TRUE(rest);
    EXPECT_LE(*rest, 9.0 + 1e-9);
    // End of "out": the time is within an ulp of its last value as soon as 3·(0.1·(1−u)³/3) <
    // 1e-15.
    EXPECT_GE(*rest, 9.0 - 1e-3);
}

TEST(FilmClock, LastsUntilItsDurationHasPassed) {
    const std::string slowing = "[[keyframes]]\nat_s = 4\nspeed = 0.5\neasing = \"linear\"\n";
    // ∫ = 0.75·4 = 3 until 4 s, then 0.5 per second.
    EXPECT_NEAR(*FilmClock(film("[film]\nduration_s = 5\n" + slowing)).length_s(), 8.0, 1e-14);
    EXPECT_EQ(*FilmClock(film("[film]\nlength_s = 6\n" + slowing)).length_s(), 6.0);
    EXPECT_EQ(film_end_time_s(film("[film]\nlength_s = 6\n" + slowing)), 4.0);
}

TEST(FilmClock, MomentsBeforeAndAfterTheFilmKeepTheOrder) {
    const FilmClock clock(
        film("[film]\nlength_s = 10\n[[keyframes]]\nat_s = 0\nspeed = 0\n"
             "[[keyframes]]\nat_s = 2\nspeed = 1\n[[keyframes]]\nat_s = 5\nspeed = 0\n"));
    EXPECT_LT(moment_of_time(clock, -1.0).film_s, 0.0);
    EXPECT_EQ(moment_of_time(clock, 100.0).film_s, 10.0);
}

TEST(BadFilm, IsRefusedInOneLine) {
    const std::string keys = "[[keyframes]]\nat_s = 2\nspeed = 1\n[[keyframes]]\n";
    EXPECT_EQ(refusal(a_scene + keys + "at_s = 1\nspeed = 2\n"),
              "scenes/a.toml:10:1: keyframes[1].at_s is 1, before the 2 s of keyframes[0]; put "
              "them in order of time");
    EXPECT_EQ(refusal(a_scene + keys + "at_s = 2\nspeed = 2\n"),
              "scenes/a.toml:10:1: keyframes[0] and keyframes[1] both set the speed at 2 s; remove "
              "one of them");
    EXPECT_EQ(refusal(a_scene + keys + "at_s = 3\n"),
              "scenes/a.toml:9:1: keyframes[1] sets nothing; give a view, a value of the camera, "
              "or the speed");
    EXPECT_EQ(refusal(a_scene + keys + "speed = 2\n"),
              "scenes/a.toml:9:1: keyframes[1].at_s is missing; give it");
    EXPECT_EQ(refusal(a_scene + keys + "at_s = 3\neasing = \"smoth\"\n"),
              "scenes/a.toml:11:10: unknown easing \"smoth\"; did you mean \"smooth\"?");
    EXPECT_EQ(refusal(a_scene + keys + "at_s = 3\nview = \"tip\"\n").substr(0, 47),
              "scenes/a.toml:11:8: unknown camera view \"tip\"; ");
    EXPECT_EQ(refusal(a_scene + keys + "at_s = -3\n"),
              "scenes/a.toml:10:8: keyframes[1].at_s is -3; give a number from 0 to 1e7");
    EXPECT_EQ(refusal(a_scene + "[[fades]]\nat_s = 2\nelements = [\"plane\"]\nopacity = 1.5\n"),
              "scenes/a.toml:9:11: fades[0].opacity is 1.5; give a number from 0 to 1");
    EXPECT_EQ(refusal(a_scene + "[[fades]]\nat_s = 2\nelements = [\"plane\"]\n"
                                "[[fades]]\nat_s = 2.5\nelements = [\"plane\"]\nopacity = 0\n"),
              "scenes/a.toml:10:1: fades[1] begins at 2.5 s, while fades[0] still fades \"plane\" "
              "until 3 s; let one end before the next");
    EXPECT_EQ(refusal(a_scene + "[[chapters]]\nat_s = 20\ntitle = \"x\"\n"),
              "scenes/a.toml:7:1: chapters[0].at_s is 20, but the film ends at 10 s; begin it "
              "earlier");
    EXPECT_EQ(refusal(a_scene + "[film]\nduration_s = 5\nlength_s = 5\n"),
              "scenes/a.toml:8:1: film.length_s contradicts film.duration_s (at line 7); give "
              "film.duration_s (of the motion) or film.length_s (of the film), not both");
    EXPECT_EQ(refusal(a_scene + "[film]\nduration_s = 5\n[[keyframes]]\nat_s = 1\nspeed = 0\n"),
              "scenes/a.toml:7:1: the speed falls to 0 before 5 s of the motion have passed; raise "
              "it again, or give film.length_s instead of film.duration_s");
    EXPECT_EQ(refusal(a_scene + "[film]\nloop = \"5 by 3\"\n"),
              "scenes/a.toml:7:8: film.loop is \"5 by 3\"; give turns over periods, each 1 to "
              "1000, as in \"5/3\", or \"period\"");
    EXPECT_EQ(refusal(a_scene + "[film]\nloop = \"period\"\n"),
              "scenes/a.toml:7:1: film.loop is \"period\", but after one polhode period only a "
              "co-precessing camera sees the same picture; set camera.motion to \"co-precessing\", "
              "or give film.loop as turns/periods, as in \"5/3\"");
}

std::string with_stops(const std::string& first, const std::string& second) {
    return a_scene + "[[stops]]\n" + first + "[[stops]]\n" + second;
}

TEST(FilmClock, RefusesStopsThatNoPageCanKeep) {
    // The film of this scene has 10 s at 30 frames a second.
    EXPECT_EQ(refusal(a_scene + "[[stops]]\ntitle = \"x\"\n"),
              "scenes/a.toml:6:1: stops[0].at_s is missing; give it");
    EXPECT_EQ(
        refusal(with_stops("at_s = 3\n", "at_s = 2\n")),
        "scenes/a.toml:9:1: stops[1].at_s is 2, before the 3 s of stops[0]; put them in order "
        "of time");
    EXPECT_EQ(refusal(with_stops("at_s = 3\n", "at_s = 3\n")),
              "scenes/a.toml:9:1: stops[0] and stops[1] are both at 3 s; remove one of them");
    EXPECT_EQ(refusal(with_stops("at_s = 3\n", "at_s = 3.02\n")),
              "scenes/a.toml:9:1: stops[1] is 0.02 s after stops[0], less than a frame (0.0333 s); "
              "move one of them");
    EXPECT_EQ(
        refusal(a_scene + "[[stops]]\nat_s = 10.5\n"),
        "scenes/a.toml:7:1: stops[0].at_s is 10.5, but the film ends at 10 s; put it earlier");
    EXPECT_EQ(refusal(a_scene + "[[stops]]\nat_s = 2\nloop_s = -1\n"),
              "scenes/a.toml:8:10: stops[0].loop_s is -1; give a number greater than 0");
    EXPECT_EQ(refusal(a_scene + "[[stops]]\nat_s = 2\nloop_s = 2.5\n"),
              "scenes/a.toml:8:1: stops[0].loop_s is 2.5, but only 2 s lie before that stop; make "
              "the loop shorter");
    EXPECT_EQ(refusal(with_stops("at_s = 3\n", "at_s = 4\nloop_s = 1.5\n")),
              "scenes/a.toml:10:1: stops[1].loop_s is 1.5, but since the last stop only 1 s lie "
              "before that stop; make the loop shorter");
}

TEST(FilmClock, AcceptsStopsAtTheirLimits) {
    const Scene scene = scene_of(with_stops("at_s = 0\n", "at_s = 10\nloop_s = 10\n"));
    EXPECT_EQ(scene.stops.at(1).loop_s, 10.0);
    // 3 · 0.1 is not the double of 0.3, a frame after 0.2 at 10 frames a second.
    EXPECT_EQ(
        scene_of(with_stops("at_s = 0.2\n", "at_s = 0.3\nloop_s = 0.1\n") + "[film]\nfps = 10\n")
            .stops.size(),
        2U);
}

TEST(Controls, OfFreeMotionsAreTheirStartAndMoments) {
    const std::string free =
        "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.5, 1.0, 0.2]\n";
    const auto of = [](const std::string& text) { return controls_of(scene_of(text)); };
    const std::vector<std::string> start{"start.omega_rad_s"}, none;
    EXPECT_EQ(of(free), (std::vector<std::string>{"start.omega_rad_s", "body.moments_kg_m2"}));
    EXPECT_EQ(of(free + "[page]\ncontrols = []\n"), none);
    EXPECT_EQ(of(free + "[film]\nloop = \"5/3\"\n"), none);
    EXPECT_EQ(of(free + "[torque]\nkind = \"constant_body\"\ntorque_body_N_m = [0.1, 0.0, 0.0]\n"
                        "[motion]\nmethod = \"rk4\"\n"),
              none);
    EXPECT_EQ(of("[body]\nshape = \"box\"\nsize_m = [1, 2, 3]\nmass_kg = 1\n"
                 "[start]\nomega_rad_s = [0.5, 1.0, 0.2]\n"),
              start);
    EXPECT_EQ(of("[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n"
                 "[start]\nenergy_J = 2.0\nmomentum_kg_m2_s = 2.8\n")
                  .at(0),
              "start.energy_J");
}

TEST(FilmClock, RefusesControlsThatNoSliderCanHold) {
    const auto refusal_of = [](const std::string& control) {
        return refusal(a_scene + "[page]\ncontrols = [\"film.speed\", \"" + control + "\"]\n");
    };
    EXPECT_EQ(refusal_of("start.omega"),
              "scenes/a.toml:7:27: page.controls[1] is \"start.omega\", which is no key; did you "
              "mean \"start.omega_rad_s\"?");
    EXPECT_EQ(refusal_of("title"),
              "scenes/a.toml:7:27: page.controls[1] is \"title\", which takes a string; name a key "
              "that takes numbers, true and false, or one of a few names");
    EXPECT_EQ(refusal_of("show").substr(0, 66),
              "scenes/a.toml:7:27: page.controls[1] is \"show\", which takes a list");
    EXPECT_EQ(refusal_of("stops[0].at_s"),
              "scenes/a.toml:7:1: page.controls[1] is \"stops[0].at_s\", but the scene has 0 "
              "[[stops]], counted from 0; give the number of one of them, as in stops[0]");
    // A number, an item of a vector, a switch and a choice.
    for (const char* good : {"film.speed", "start.omega_rad_s[2]", "body.allow_unphysical",
                             "camera.projection", "body.moments_kg_m2"})
        EXPECT_EQ(
            scene_of(a_scene + "[page]\ncontrols = [\"" + good + "\"]\n").page.controls->at(0),
            good);
}

}  // namespace

}  // namespace poinsot
