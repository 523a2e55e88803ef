// The values of a scene reach the mechanics' problem, in the correct axes.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/write_scene.h"
#include "scene_text.h"

namespace poinsot {

namespace {

TEST(SceneValues, DefaultsAreThoseOfTheStructs) {
    const Scene scene = scene_of(a_scene);
    const Scene plain;
    EXPECT_EQ(scene.name, "a");
    EXPECT_EQ(scene.title, "a");
    EXPECT_EQ(scene.film.width_px, plain.film.width_px);
    EXPECT_EQ(scene.film.fps_numerator, 30);
    EXPECT_EQ(scene.method.name, "exact");
    EXPECT_EQ(scene.torque.index(), 0u);
    EXPECT_TRUE(scene.notes.empty());
}

TEST(SceneValues, NumbersMayBeWrittenAsIntegers) {
    const Scene scene = scene_of(
        "[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [1, 2, "
        "0x10]\n"
        "[film]\nfps = 25\n");
    EXPECT_EQ(scene.body.inertia.moments_kg_m2(), Eigen::Vector3d(3.0, 2.0, 1.0));
    EXPECT_EQ(scene.film.fps_numerator, 25);
}

TEST(SceneValues, TopStartsFromItsEulerAngles) {
    const Scene scene = scene_of(
        "[body]\nmoments_kg_m2 = [1.0, 1.0, 0.5]\n[start]\ntheta_rad = 0.7\ntheta_dot_rad_s = "
        "0.25\nphi_dot_rad_s = 0.35\nomega3_rad_s = 8.0\n[torque]\nkind = \"gravity\"\nmgl_N_m = "
        "1.0\n");
    const MotionProblem problem = problem_of(scene);
    // R = Rx(θ): e3 tilts to (0, −sin θ, cos θ). ω = θ̇ e1 + φ̇ z + (ω3 − φ̇ cos θ) e3 in space.
    const Eigen::Vector3d axis = problem.start.space_from_body * Eigen::Vector3d::UnitZ();
    EXPECT_LT((axis - Eigen::Vector3d(0.0, -std::sin(0.7), std::cos(0.7))).norm(),
              1e-15);  // measured 2e-16
    const Eigen::Vector3d omega = 0.25 * Eigen::Vector3d::UnitX() +
                                  0.35 * Eigen::Vector3d::UnitZ() +
                                  (8.0 - 0.35 * std::cos(0.7)) * axis;
    EXPECT_LT((problem.start.space_from_body * problem.start.omega_body - omega).norm(),
              4e-15);  // measured 1e-15, half an ulp of 8
    EXPECT_EQ(problem.start.omega_body[2], 8.0);
}

TEST(SceneValues, AttitudeIsNormalisedWithANote) {
    const Scene scene = scene_of(a_scene + "attitude = [2, 0, 0, 0]\n");
    EXPECT_EQ(scene.start.space_from_body.coeffs(), Eigen::Quaterniond::Identity().coeffs());
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_EQ(scene.notes[0], "start.attitude has length 2 and was scaled to 1");
}

TEST(SceneValues, AttitudeOfUnitLengthIsKeptExactly) {
    const Scene scene = scene_of(a_scene +
                                 "attitude = [0.7071067811865476, 0, "
                                 "0.7071067811865475, 0]\n");
    EXPECT_EQ(scene.start.space_from_body.w(), 0.7071067811865476);
    EXPECT_EQ(scene.start.space_from_body.y(), 0.7071067811865475);
    EXPECT_TRUE(scene.notes.empty());
}

TEST(SceneValues, OfTwoEqualQuaternionsTheOneWithPositiveWIsUsed) {
    const Scene scene = scene_of(a_scene + "attitude = [-0.5, 0.5, -0.5, 0.5]\n");
    EXPECT_EQ(scene.start.space_from_body.coeffs(),
              Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5).coeffs());
}

TEST(SceneValues, NearlyOrthogonalMatrixIsNoted) {
    const Scene scene =
        scene_of(a_scene + "attitude_matrix = [[0.8, -0.6, 0], [0.6, 0.80000001, 0], [0, 0, 1]]\n");
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_NE(scene.notes[0].find("start.attitude_matrix deviates from orthogonal by 1.6e-08"),
              std::string::npos)
        << scene.notes[0];
    EXPECT_NEAR(scene.start.space_from_body.norm(), 1.0, 4e-16);
}

TEST(SceneValues, AsymmetryOfRoundingIsNoted) {
    const Scene scene = scene_of(
        "[body]\ntensor_kg_m2 = [[2, 0.3, 0], [0.30000000000000004, 2, 0], [0, 0, 2]]\n" + a_start);
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_EQ(scene.notes[0].rfind("body.tensor_kg_m2: ", 0), 0u) << scene.notes[0];
    EXPECT_EQ(scene.body.tensor_kg_m2, scene.body.tensor_kg_m2.transpose());
}

TEST(SceneValues, SpanOfTheProblemContainsTheFilmAndTheStart) {
    const MotionProblem later =
        problem_of(scene_of(a_scene + "[film]\nstart_s = 3\nduration_s = 4\n"));
    EXPECT_EQ(later.first_time_s, 0.0);
    EXPECT_EQ(later.last_time_s, 7.0);
    const MotionProblem earlier =
        problem_of(scene_of(a_scene + "[film]\nstart_s = -9\nduration_s = 4\n"));
    EXPECT_EQ(earlier.first_time_s, -9.0);
    EXPECT_EQ(earlier.last_time_s, 0.0);
    const MotionProblem unsaid = problem_of(scene_of(a_scene + "[film]\nspeed = 2\n"));
    EXPECT_EQ(unsaid.last_time_s, 2.0 * default_film_s);
}

TEST(SceneValues, OverridesReplaceAndExtendTheFile) {
    const Scene scene =
        scene_of("title = \"a\"\n" + a_scene,
                 {"title=2024", "film.size=640x480", "film.fps=30000/1001", "show=plane,omega",
                  "camera.distance=.5", "start.omega_rad_s=[1,2,3]", "film.quality=\"draft\"",
                  "theme=dark", "theme=light"});
    EXPECT_EQ(scene.title, "2024");
    EXPECT_EQ(scene.film.width_px, 640);
    EXPECT_EQ(scene.film.fps_denominator, 1001);
    EXPECT_EQ(scene.show, (std::vector<std::string>{"plane", "omega"}));
    EXPECT_EQ(scene.camera.distance, 0.5);
    EXPECT_EQ(scene.start.omega_rad_s, Eigen::Vector3d(1.0, 2.0, 3.0));
    EXPECT_EQ(scene.film.quality, "draft");
    EXPECT_EQ(scene.theme, "light");
    EXPECT_EQ(scene.where("theme"), "--set theme=light: ");
}

TEST(SceneValues, OverridesReachItemsOfArrays) {
    const Scene scene = scene_of(
        "[[body.masses]]\nmass_kg = 1\nat_m = [1, 0, 0]\n[[body.masses]]\nmass_kg = "
        "1\nat_m = [0, 1, 0]\n[[body.masses]]\nmass_kg = 1\nat_m = [0, 0, 1]\n" +
            a_start,
        {"body.masses[1].mass_kg=2.5"});
    EXPECT_EQ(scene.body.masses.at(0).mass_kg, 1.0);
    EXPECT_EQ(scene.body.masses.at(1).mass_kg, 2.5);
}

TEST(SceneValues, LocationFallsBackToTheNearestTableAbove) {
    const Scene scene = scene_of(a_scene);
    EXPECT_EQ(scene.where("start.omega_rad_s"), "scenes/a.toml:5:1: ");
    EXPECT_EQ(scene.where("start.attitude"), "scenes/a.toml:4:2: ");
    EXPECT_EQ(scene.where("film.fps"), "scenes/a.toml:1:1: ");
}

// The start by T and L.

const std::string by_energy = a_body + "[start]\nenergy_J = 2.0\n";

TEST(ConservedStart, RefusesContradictions) {
    EXPECT_EQ(refusal(by_energy),
              "scenes/a.toml:4:1: start.energy_J needs start.momentum_kg_m2_s or "
              "start.plane_distance beside it: T alone does not choose a polhode");
    EXPECT_EQ(
        refusal(a_body + "[start]\nplane_distance = 0.7\n"),
        "scenes/a.toml:4:1: start.plane_distance is given but start.energy_J is not; give the "
        "kinetic energy, as in energy_J = 2.0");
    EXPECT_EQ(refusal(by_energy + "momentum_kg_m2_s = 2.5\nplane_distance = 0.7\n"),
              "scenes/a.toml:6:1: start.plane_distance contradicts start.momentum_kg_m2_s (at line "
              "5); with energy_J give one of them");
    EXPECT_EQ(refusal(by_energy + "momentum_kg_m2_s = 4\n"),
              "scenes/a.toml:5:1: momentum_kg_m2_s = 4 is impossible for this body with energy_J = "
              "2: 2T I_min <= L^2 <= 2T I_max requires L between 2 and 3.46410162 kg m^2/s");
    EXPECT_NE(refusal(by_energy + "momentum_kg_m2_s = 2.5\ntheta_rad = 0.5\n"), "");
    EXPECT_NE(refusal(by_energy + "momentum_kg_m2_s = 2.5\nomega_rad_s = [0, 0, 0]\n"), "");
}

TEST(ConservedStart, AcceptsUnitsAndIsWrittenAsGiven) {
    const Scene scene = scene_of(a_body +
                                 "[start]\nenergy_J = \"2000 mJ\"\nmomentum_kg_m2_s = "
                                 "2.5\nomega_rad_s = [1, 2, 3]\n");
    const std::string text = to_toml(scene);
    EXPECT_NE(text.find("omega_rad_s = [1.0, 2.0, 3.0]\nenergy_J = 2.0\nmomentum_kg_m2_s = 2.5\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(scene_of(text).start.omega_rad_s, scene.start.omega_rad_s);
    // A start that was changed since is written as ω.
    Scene changed = scene;
    changed.start.omega_rad_s[0] += 0.1;
    EXPECT_EQ(to_toml(changed).find("energy_J"), std::string::npos);
    EXPECT_FALSE(problem_of(changed).on_separatrix);
}

TEST(ConservedStart, OnTheSeparatrixIsExact) {
    // L² = 2T·I₂ = 8 has no exact root; its nearest double stands for it.
    const Scene scene = scene_of(by_energy + "momentum_kg_m2_s = 2.8284271247461903\n");
    EXPECT_TRUE(problem_of(scene).on_separatrix);
    EXPECT_TRUE(problem_of(scene_of(to_toml(scene))).on_separatrix);
    EXPECT_FALSE(problem_of(scene_of(by_energy + "momentum_kg_m2_s = 2.83\n")).on_separatrix);
}

}  // namespace

}  // namespace poinsot
