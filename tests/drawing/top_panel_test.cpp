// The top panel: the axis and its circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(TopPanel, AxisIsThatOfTheAttitude) {
    for (const TopCase& one : tops) {
        const StagedScene staged(top_scene(one.start, "top", one.mgl_N_m), 10.0);
        for (const double t : {0.0, 1.3, 10.0}) {
            // The quaternion is computed independently of the angles.
            const Eigen::Vector3d e3 =
                staged.motion.at(t).space_from_body * Eigen::Vector3d::UnitZ();
            const Drawing drawing = staged.stage.at(t);
            EXPECT_LT((view_of(drawing).dots.back().at - e3).norm(), 2e-12) << one.name << " " << t;
            // The shown path ends there; leaders of labels follow it in the list.
            const auto& curves = view_of(drawing).curves;
            const auto path = std::find_if(curves.rbegin(), curves.rend(), [&](const Curve& curve) {
                return curve.geometry != staged.stage.store().unit_segment();
            });
            ASSERT_NE(path, curves.rend());
            const auto i = static_cast<std::size_t>(path->last);
            EXPECT_LT((path->geometry->points[i] - e3).norm(), 0.25) << one.name << " " << t;
        }
    }
}

TEST(TopPanel, AxisMovesBetweenTheDrawnCircles) {
    const StagedScene staged(top_scene({0.7, 0.0, -0.6, 5.0}, "top"), 10.0);
    const Drawing drawing = staged.stage.at(10.0);
    std::vector<double> heights;
    for (const Curve& curve : view_of(drawing).curves) {
        if (curve.dash_px > 0.0 && curve.geometry->closed) {
            heights.push_back(curve.placement.translation().z());
        }
    }
    ASSERT_EQ(heights.size(), 2u);
    double lowest = 1.0;
    double highest = -1.0;
    for (const Eigen::Vector3d& point : view_of(drawing).curves.back().geometry->points) {
        lowest = std::min(lowest, point.z());
        highest = std::max(highest, point.z());
        EXPECT_NEAR(point.norm(), 1.0, 1e-14);
    }
    EXPECT_NEAR(lowest, std::min(heights[0], heights[1]), 1e-3);  // reached between two samples
    EXPECT_NEAR(highest, std::max(heights[0], heights[1]), 1e-3);
    EXPECT_GE(lowest, std::min(heights[0], heights[1]) - 1e-13);
    EXPECT_LE(highest, std::max(heights[0], heights[1]) + 1e-13);
}

}  // namespace
}  // namespace poinsot::panels_tests
