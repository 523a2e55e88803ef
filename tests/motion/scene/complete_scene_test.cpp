// The values of a scene reach the mechanics' problem, in the correct axes.
#include <gtest/gtest.h>

#include <cmath>

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

// The page that follows is a file of the same folder.
TEST(SceneValues, TheNextPageIsInTheSameFolder) {
    const auto with_next = [](const std::string& name) {
        return a_scene + "[page]\nnext = '" + name + "'\n";
    };
    EXPECT_EQ(scene_of(with_next("the top_2.html")).page.next, "the top_2.html");
    EXPECT_EQ(scene_of(with_next("")).page.next, "");
    EXPECT_EQ(scene_of(with_next("Präzession.html")).page.next, "Präzession.html");
    for (const char* name : {"top", ".html", "..html", "a/top.html", "../top.html", "a\\top.html",
                             "https://example.org/top.html", "javascript:alert(1)//.html",
                             "top.html?x=1", "\"top.html"})
        EXPECT_NE(refusal(with_next(name)).find("is no page in the same folder; give"),
                  std::string::npos)
            << name;
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

}  // namespace
}  // namespace poinsot
