// The scale of distances beside the body.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "drawing/stage/construction_picture.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"

namespace poinsot::panels_tests {
namespace {

// In perspective, too, it is upright in the picture, each of its marks at the height of the plane
// at that distance; and no line of it runs through the body or to the foot of L.
TEST(LevelScale, IsUprightBesideTheBody) {
    for (const char* side : {"below", "above"}) {
        Scene scene = free_scene(generic_moments, generic_omega, "space");
        scene.show = {"plane", "ellipsoid", "levels"};
        scene.construction.plane = side;
        scene.camera.elevation_deg = 15.0;
        const StagedScene staged(scene, 10.0);
        const StageContext& stage = staged.stage.context();
        const Drawing drawing = staged.stage.at(3.0);
        const View& view = view_of(drawing);
        const Eigen::Vector3d normal = stage.rolling->normal;
        const auto place = [&](const Eigen::Vector3d& at) { return project(view, at).px; };
        const Eigen::Vector2d centre = place(Eigen::Vector3d::Zero());

        std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines;
        for (const Curve& curve : view.curves) {
            if (curve.name.element != "levels") continue;
            const std::vector<Eigen::Vector3d> points = drawn_points(curve);
            lines.emplace_back(place(points.front()), place(points.back()));
        }
        ASSERT_EQ(lines.size(), 6u);
        const auto& [zero, end] = lines[1];
        EXPECT_NEAR(zero.x(), end.x(), 1e-6);
        EXPECT_NEAR(zero.y(), centre.y(), 1e-6);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(lines[2 + i].first.x(), zero.x(), 1e-6);
            EXPECT_NEAR(lines[2 + i].first.y(), place(stage.rolling->half_axes[i] * normal).y(),
                        1e-6);
        }
        EXPECT_NEAR(lines[5].second.x(), zero.x(), 1e-6);
        EXPECT_NEAR(lines[5].second.y(), place(stage.rolling->foot()).y(), 1e-6);
        // Half-way between L and the scale nothing of it begins.
        for (const auto& [from, to] : lines)
            EXPECT_GT(std::min(from.x(), to.x()), 0.5 * (centre.x() + zero.x()));
    }
}

}  // namespace
}  // namespace poinsot::panels_tests
