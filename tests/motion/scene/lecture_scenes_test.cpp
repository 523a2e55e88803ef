// The scenes of the lecture fulfil their titles and captions.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "mechanics/free/free_rotation.h"
#include "mechanics/motion.h"
#include "places.h"
#include "scene/files/load_scene.h"
#include "scene/film_clock.h"

namespace poinsot {

namespace {

Scene lecture(const std::string& name) {
    return load_scene(source_folder() / "scenes" / (name + ".toml"));
}

Motion motion_of(const Scene& scene) { return Motion(problem_of(scene)); }

Regime regime_of(const std::string& name) { return motion_of(lecture(name)).regime(); }

TEST(LectureScenes, EachHasTitleCaptionAndAFilmOfASuitableLength) {
    for (const std::filesystem::path& file : supplied_scenes()) {
        const Scene scene = load_scene(file);
        EXPECT_TRUE(scene.locations.contains("title")) << file;
        if (file.stem() == "cover") continue;  // a picture without words, of a long motion
        EXPECT_FALSE(scene.caption.empty() && scene.captions.empty()) << file;
        const double film_s = FilmClock(scene).length_s().value_or(0.0);
        EXPECT_GE(film_s, 10.0) << file;
        // A film with chapters may be longer, and one with stops much longer.
        const double most_s = scene.chapters.empty() ? 20.0 : scene.stops.empty() ? 60.0 : 200.0;
        EXPECT_LE(film_s, most_s) << file;
        EXPECT_TRUE(scene.notes.empty()) << file;
    }
}

TEST(LectureScenes, EachMovesAsItsNameSays) {
    EXPECT_EQ(regime_of("sphere"), Regime::permanent);
    EXPECT_EQ(regime_of("stable_largest"), Regime::elliptic_about_highest);
    EXPECT_EQ(regime_of("stable_smallest"), Regime::elliptic_about_lowest);
    EXPECT_EQ(regime_of("separatrix"), Regime::separatrix);
    EXPECT_EQ(regime_of("symmetric_oblate"), Regime::symmetric);
    EXPECT_EQ(regime_of("symmetric_prolate"), Regime::symmetric);
    EXPECT_EQ(regime_of("generic"), Regime::elliptic_about_lowest);
}

TEST(LectureScenes, SeparatrixIsExact) {
    // All of these numbers are exact in binary, so equality is exact, too.
    const Scene scene = lecture("separatrix");
    const Eigen::Vector3d I = scene.body.inertia.moments_kg_m2();
    const Eigen::Vector3d L = I.cwiseProduct(scene.start.omega_rad_s);
    EXPECT_EQ(L.squaredNorm(), L.dot(scene.start.omega_rad_s) * I[1]);
}

TEST(LectureScenes, TennisRacketTurnsOverMoreThanOnce) {
    const Scene scene = lecture("tennis_racket");
    const Motion motion = motion_of(scene);
    int n_flips = 0;
    double sign = 1.0;
    for (int i = 0; i <= 1000; ++i) {
        const double w2 = motion.at(*scene.film.duration_s * i / 1000.0).omega_body[1];
        if (w2 * sign < -1.0) {
            ++n_flips;
            sign = -sign;
        }
    }
    EXPECT_GE(n_flips, 2);
}

TEST(LectureScenes, CaptionsGiveTheRateOfPrecession) {
    for (const auto& [name, rate, in_caption] :
         {std::tuple{"symmetric_oblate", 1.2, "= 1.2$~rad/s"},
          std::tuple{"symmetric_prolate", -1.2, "= -1.2$~rad/s"}}) {
        const Scene scene = lecture(name);
        const Eigen::Vector3d I = scene.body.inertia.moments_kg_m2();
        EXPECT_EQ(I[0], I[1]);
        // Ω = (I₃−I₁)ω₃/I₁, to rounding of three operations.
        EXPECT_NEAR((I[2] - I[0]) * scene.start.omega_rad_s[2] / I[0], rate, 4e-16);
        EXPECT_NE(scene.caption.find(in_caption), std::string::npos) << scene.caption;
    }
}

TEST(LectureScenes, TopsMoveAsTheirNamesSay) {
    for (const auto& [name, regime] : {std::pair{"heavy_top_wavy", TopRegime::wavy},
                                       std::pair{"heavy_top_cusp", TopRegime::cusp},
                                       std::pair{"heavy_top_looping", TopRegime::looping},
                                       std::pair{"heavy_top_sleeping", TopRegime::sleeping},
                                       std::pair{"heavy_top_steady", TopRegime::steady_slow}}) {
        const Motion motion = motion_of(lecture(name));
        ASSERT_NE(motion.heavy_top(), nullptr) << name;
        EXPECT_EQ(motion.heavy_top()->regime(), regime) << name;
    }
}

TEST(LectureScenes, SteadyTopKeepsItsTilt) {
    const Motion motion = motion_of(lecture("heavy_top_steady"));
    const TopNutation& nutation = motion.heavy_top()->nutation();
    EXPECT_LT(nutation.theta_max_rad - nutation.theta_min_rad, 1e-15);
    EXPECT_NEAR(nutation.precession_rate_rad_s, 0.4666, 5e-5);  // as rounded in the caption
}

TEST(LectureScenes, TensorIsOffItsPrincipalAxes) {
    const Scene scene = lecture("tensor");
    EXPECT_FALSE(scene.body.inertia.body_axes_are_principal());
    EXPECT_GT(std::abs(scene.body.tensor_kg_m2(0, 1)), 0.1);
}

TEST(LectureScenes, PointMassesAreMovedToTheirCentreOfMass) {
    const Scene scene = lecture("point_masses");
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const PointMass& mass : scene.body.masses) moment += mass.mass_kg * mass.at_m;
    EXPECT_LT(moment.norm(), 1e-15);  // measured 2e-16
    EXPECT_GT(scene.body.centre_of_mass_m_body.norm(), 0.05);
}

FreeRotationConstants constants_of(const std::string& name) {
    const MotionProblem problem = problem_of(lecture(name));
    return FreeRotation(problem.inertia, problem.start).constants();
}

// Precession of a symmetric body's axis about L per turn of its spin ω₃: I₃/(I₁ cos θ), cos θ =
// I₃ω₃/L.
double wobbles_a_spin(const std::string& name) {
    const Scene scene = lecture(name);
    return constants_of(name).momentum_kg_m2_s / scene.body.inertia.moments_kg_m2()[0] /
           scene.start.omega_rad_s[2];
}

TEST(LectureScenes, RealBodiesMatchTheirCaptions) {
    // As rounded in the captions.
    EXPECT_NEAR(wobbles_a_spin("feynman_plate"), 2.00, 0.005);
    EXPECT_NEAR(wobbles_a_spin("football"), 0.64, 0.005);
    const Scene earth = lecture("earth_wobble");
    const Eigen::Vector3d I = earth.body.inertia.moments_kg_m2();
    const double period_s =
        2.0 * std::numbers::pi * I[0] / ((I[2] - I[0]) * earth.start.omega_rad_s[2]);
    EXPECT_NEAR(period_s / 86164.1, 304.3, 0.05);  // sidereal days: turns of the Earth
    EXPECT_NEAR(period_s / 86400.0, 303.5, 0.05);
}

TEST(LectureScenes, ToutatisHasTheObservedPeriods) {
    // Hudson & Ostro: 5.41 d about the long axis, 7.35 d of the long axis about L, on average.
    const Scene scene = lecture("toutatis");
    const double period_s = *constants_of("toutatis").polhode_period_s;
    EXPECT_NEAR(period_s / 86400.0, 5.41, 0.005);
    const Motion motion = motion_of(scene);
    const Eigen::Vector3d vertical =
        (scene.body.inertia.moments_kg_m2().cwiseProduct(scene.start.omega_rad_s)).normalized();
    const Eigen::Vector3d right = vertical.unitOrthogonal();
    double turned = 0.0;
    double before = 0.0;
    constexpr int n = 200;  // a hundred and fifty steps per turn
    for (int k = 0; k <= n; ++k) {
        const Eigen::Vector3d axis =
            motion.at(period_s * k / n).space_from_body * Eigen::Vector3d::UnitZ();
        const double azimuth = std::atan2(axis.dot(vertical.cross(right)), axis.dot(right));
        if (k > 0) turned += std::remainder(azimuth - before, 2.0 * std::numbers::pi);
        before = azimuth;
    }
    EXPECT_NEAR(period_s / 86400.0 * 2.0 * std::numbers::pi / std::abs(turned), 7.35, 0.005);
}

TEST(LectureScenes, ThrownRacketTurnsItsFaceOverInOneTurn) {
    // e1, perpendicular to the face, is reversed when the handle has turned once.
    const Scene scene = lecture("racket_thrown");
    const Motion motion = motion_of(scene);
    double handle_turned = 0.0;
    double t = 0.0;
    constexpr double step_s = 1e-3;
    const Eigen::Vector3d vertical =
        (scene.body.inertia.moments_kg_m2().cwiseProduct(scene.start.omega_rad_s)).normalized();
    Eigen::Vector3d before = Eigen::Vector3d::UnitZ();
    while (handle_turned < 2.0 * std::numbers::pi) {
        t += step_s;
        const Eigen::Vector3d handle = motion.at(t).space_from_body * Eigen::Vector3d::UnitZ();
        handle_turned += std::atan2(vertical.dot(before.cross(handle)), before.dot(handle));
        before = handle;
    }
    EXPECT_LT((motion.at(t).space_from_body * Eigen::Vector3d::UnitX()).x(), -0.7);
}

}  // namespace

}  // namespace poinsot
