// Quantities that are not shown are not computed.
#include <gtest/gtest.h>

#include "mechanics/counted_motion.h"
#include "scenes_by_hand.h"

namespace poinsot {
namespace {

const Eigen::Vector3d generic_moments{1.0, 2.0, 2.9};
const Eigen::Vector3d generic_omega{1.4, 0.5, 1.6};

TEST(Evaluations, BodyPanelRequestsOnlyOmega) {
    for (const char* kind : {"body", "momentum"}) {
        const StagedScene staged(free_scene(generic_moments, generic_omega, kind), 10.0);
        EXPECT_EQ(staged.stage.counts().n_omega, 0) << kind;
        for (int k = 0; k < 5; ++k) staged.stage.at(k);
        EXPECT_EQ(staged.stage.counts().n_omega, 5) << kind;
        EXPECT_EQ(staged.stage.counts().n_attitude, 0) << kind;
        EXPECT_EQ(staged.stage.counts().n_herpolhode, 0) << kind;
    }
}

TEST(Evaluations, PlanRequestsNoAttitude) {
    const StagedScene staged(free_scene(generic_moments, generic_omega, "plan"), 10.0);
    const std::int64_t made = staged.stage.counts().n_herpolhode;
    EXPECT_GT(made, 0);
    staged.stage.at(3.0);
    EXPECT_EQ(staged.stage.counts().n_herpolhode, made + 1);
    EXPECT_EQ(staged.stage.counts().n_attitude, 0);
}

TEST(Evaluations, SpacePanelRequestsWhatItsElementsShow) {
    Scene scene = free_scene(generic_moments, generic_omega, "space");
    scene.show = {"plane", "momentum", "annulus"};
    const StagedScene still(scene, 10.0);
    still.stage.at(1.0);
    EXPECT_EQ(still.stage.counts().n_omega, 1);
    EXPECT_EQ(still.stage.counts().n_attitude, 0);
    EXPECT_EQ(still.stage.counts().n_herpolhode, 0);

    scene.show = {"plane", "ellipsoid"};
    const StagedScene turning(scene, 10.0);
    turning.stage.at(1.0);
    EXPECT_EQ(turning.stage.counts().n_attitude, 1);
    EXPECT_EQ(turning.stage.counts().n_herpolhode, 0);
}

TEST(Evaluations, StillSamplesNoHistoryAfterItsInstant) {
    const Scene scene = free_scene(generic_moments, generic_omega, "space");
    const StagedScene at_start(scene, 0.0);
    EXPECT_LE(at_start.stage.counts().n_herpolhode, 1);
    const StagedScene early(scene, 1.0);
    const StagedScene late(scene, 10.0);
    // The number of evaluations is proportional to the shown time, up to the end of its last piece.
    EXPECT_LT(early.stage.counts().n_herpolhode, late.stage.counts().n_herpolhode / 5);
}

TEST(Evaluations, SphereHasNoCurves) {
    const StagedScene space(free_scene({2.0, 2.0, 2.0}, generic_omega, "space"), 10.0);
    EXPECT_EQ(space.stage.counts().n_herpolhode, 0);
    // Only straight lines: the axis of rotation, and the right angle at the foot of L.
    const Drawing drawing = space.stage.at(1.0);
    for (const Curve& curve : drawing.views[0].curves) {
        EXPECT_EQ(curve.geometry->points.size(), 2u);
    }
    const StagedScene body(free_scene({2.0, 2.0, 2.0}, generic_omega, "body"), 10.0);
    const StagedScene momentum(free_scene({2.0, 2.0, 2.0}, generic_omega, "momentum"), 10.0);
    // At most the leader of a name: ω and L lie on one line.
    for (const StagedScene* staged : {&body, &momentum}) {
        const Drawing shown = staged->stage.at(1.0);
        EXPECT_LE(shown.views[0].curves.size(), 1u);
        for (const Curve& curve : shown.views[0].curves) EXPECT_EQ(curve.name.part, "leader");
    }
}

TEST(Evaluations, SphereEvaluatesNoThetaSeries) {
    // A sphere rotates steadily; the same picture of another body needs Jacobi's functions at each
    // instant.
    const StagedScene sphere(free_scene({2.0, 2.0, 2.0}, generic_omega, "space"), 10.0);
    const StagedScene generic(free_scene(generic_moments, generic_omega, "space"), 10.0);
    for (int k = 0; k < 5; ++k) {
        sphere.stage.at(k);
        generic.stage.at(k);
    }
    EXPECT_EQ(sphere.stage.counts().n_omega, 5);
    EXPECT_EQ(sphere.stage.counts().n_theta_series, 0);
    EXPECT_EQ(generic.stage.counts().n_theta_series, generic.stage.counts().n_omega);
}

TEST(Evaluations, SteadySpinEvaluatesNoThetaSeries) {
    const StagedScene staged(free_scene(generic_moments, {0.0, 2.0, 0.0}, "body"), 10.0);
    staged.stage.at(3.0);
    EXPECT_EQ(staged.stage.counts().n_theta_series, 0);
}

TEST(Evaluations, WithoutTorqueNoTorqueIsEvaluated) {
    Scene scene = free_scene({1.0, 1.0, 0.5}, generic_omega, "body");
    scene.method.step_s = 0.1;
    for (const char* method : {"euler", "rk4", "splitting", "rkmk4"}) {
        scene.method.name = method;
        scene.torque = NoTorque{};
        const Motion free(problem_of(scene));
        EXPECT_GT(free.integrated()->counters().n_steps, 0) << method;
        EXPECT_EQ(free.integrated()->counters().n_torques, 0) << method;
        scene.torque = Gravity{1.0, {0.0, 0.0, 1.0}};
        EXPECT_GE(Motion(problem_of(scene)).integrated()->counters().n_torques, 100) << method;
    }
    scene.method = {"dopri5", {}, 1e-6, {}};
    EXPECT_GE(Motion(problem_of(scene)).integrated()->counters().n_torques, 50);
    scene.torque = NoTorque{};
    EXPECT_EQ(Motion(problem_of(scene)).integrated()->counters().n_torques, 0);
}

TEST(Evaluations, PotentialOfATopRequestsOnlyItsAngles) {
    const StagedScene staged(top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, "potential"), 10.0);
    staged.stage.at(1.0);
    EXPECT_EQ(staged.stage.counts().n_euler_angles, 1);
    EXPECT_EQ(staged.stage.counts().n_attitude, 0);
}

TEST(Evaluations, PanelsShareOneEvaluationPerInstant) {
    Scene scene = free_scene(generic_moments, generic_omega, "space");
    scene.grid.columns = {1.0, 1.0, 1.0};
    for (const char* kind : {"body", "momentum"}) {
        PanelSpec spec;
        spec.kind = kind;
        spec.column = static_cast<int>(scene.panels.size());
        scene.panels.push_back(spec);
    }
    const StagedScene staged(scene, 2.0);
    const std::int64_t made = staged.stage.counts().n_omega;
    staged.stage.at(1.0);
    EXPECT_EQ(staged.stage.counts().n_omega, made + 1);
    EXPECT_EQ(staged.stage.counts().n_attitude, 1);
}

}  // namespace
}  // namespace poinsot
