#include "drawing/stage/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shapes/projection.h"

namespace poinsot {
namespace {

View view_of(const PanelBox& box, const Camera& camera) {
    View view;
    view.x_px = box.x_px;
    view.y_px = box.y_px;
    view.width_px = box.width_px;
    view.height_px = box.height_px;
    view.camera = camera;
    return view;
}

// Least distance of the points from the sides of the box.
double least_margin(const View& view, const std::vector<Eigen::Vector3d>& points) {
    double least = 1e300;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector2d px = project(view, point).px - Eigen::Vector2d(view.x_px, view.y_px);
        least = std::min({least, px.x(), px.y(), view.width_px - px.x(), view.height_px - px.y()});
    }
    return least;
}

TEST(Framing, ContainsAllPointsAndTouchesTheMargin) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 200; ++k) {
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < 20; ++i) {
            points.emplace_back(normal(random), normal(random), 0.3 * normal(random));
        }
        const PanelBox box{37, 11, k % 2 == 0 ? 800 : 300, k % 3 == 0 ? 600 : 300};
        const Camera camera =
            framed(box, direction_of(7.0 * k, 20.0), Eigen::Vector3d::UnitZ(), 0.5, points, 25.0);
        // The outermost point is on the margin. Measured 2e-12.
        EXPECT_NEAR(least_margin(view_of(box, camera), points), 25.0, 1e-9);
    }
}

TEST(Framing, OnePointIsViewedFromADistance) {
    const std::vector<Eigen::Vector3d> points(3, Eigen::Vector3d(1.0, 2.0, 3.0));
    const Camera camera = framed({0, 0, 100, 100}, direction_of(10.0, 20.0),
                                 Eigen::Vector3d::UnitZ(), 0.5, points, 10.0);
    EXPECT_NEAR((camera.eye - camera.target).norm(), 1.0, 1e-12);
    EXPECT_LT((camera.target - points[0]).norm(), 1e-12);
}

TEST(Framing, PointsOfAnEllipsoidLieOnIt) {
    const Eigen::Matrix3d half_axes = Eigen::Vector3d(1.0, 0.5, 1e-6).asDiagonal();
    for (const Eigen::Vector3d& point : points_of_ellipsoid(half_axes)) {
        EXPECT_NEAR((half_axes.inverse() * point).norm(), 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace poinsot
