// The object panel: a box and masses.
#include <gtest/gtest.h>

#include <algorithm>

#include "drawing/figures/elements/object_shapes.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(ObjectPanel, BoxHasTheGivenMoments) {
    // For 1 kg: I₁ = (b² + c²)/12 and so on.
    const Eigen::Vector3d edges = box_of_moments(generic_moments);
    const Eigen::Vector3d squares = edges.cwiseProduct(edges);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR((squares[(i + 1) % 3] + squares[(i + 2) % 3]) / 12.0, generic_moments[i],
                    1e-14);
    }
    // A lamina and bodies with impossible moments have a positive thickness.
    EXPECT_GT(box_of_moments({1.0, 2.0, 3.0}).minCoeff(), 0.0);
    EXPECT_GT(box_of_moments({1.0, 2.0, 3.5}).minCoeff(), 0.0);
}

TEST(ObjectPanel, MassesAreAtTheirPositions) {
    Scene scene = free_scene({1.0, 2.0, 2.5}, generic_omega, "object");
    scene.body.given = BodySpec::Given::masses;
    scene.body.masses = {{1.0, {1.0, 0.0, 0.0}}, {1.0, {-0.5, 0.5, 0.0}}, {1.0, {-0.5, -0.5, 0.0}}};
    const StagedScene staged(scene, 1.0);
    const Drawing drawing = staged.stage.at(0.0);
    ASSERT_EQ(view_of(drawing).meshes.size(), 2u);
    // The mean of the balls' corners is the centre of mass, in units of the body's reach: all balls
    // have the same number of corners.
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double reach = 0.0;
    for (const auto& p : view_of(drawing).meshes[1].geometry->positions) {
        mean += p.cast<double>();
        reach = std::max(reach, 1.0 * p.norm());
    }
    mean /= static_cast<double>(view_of(drawing).meshes[1].geometry->positions.size());
    EXPECT_LT(mean.norm(), 1e-5);
    EXPECT_NEAR(reach, 1.0, 1e-6);
}

}  // namespace
}  // namespace poinsot::panels_tests
