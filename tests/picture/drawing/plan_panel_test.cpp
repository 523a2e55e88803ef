// The plan panel: the herpolhode between its circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "drawing/style/theme.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(PlanPanel, HerpolhodeStaysBetweenItsCirclesAndEndsAtTheContact) {
    const Colour herpolhode_colour = theme_named("light").herpolhode;
    for (const FreeCase& one : extremes) {
        const StagedScene staged(free_scene(one.moments, one.omega, "plan"), 10.0);
        const Drawing drawing = staged.stage.at(3.7);
        const View& view = view_of(drawing);
        const Eigen::Vector3d contact = view.dots.back().at;
        double inner = 0.0;
        double outer = 0.0;
        const Curve* path = nullptr;
        for (const Curve& curve : view.curves) {
            if (curve.name.element == "momentum") continue;  // the sign of L
            if (curve.geometry->closed) {
                const double radius = curve.placement.linear().col(0).norm();
                inner = radius < 1.0 ? radius : inner;
                outer = std::max(outer, radius);
            } else if (curve.colour == herpolhode_colour && !curve.geometry->points.empty()) {
                path = &curve;
            }
        }
        if (outer == 0.0) {
            EXPECT_EQ(contact.norm(), 0.0) << one.name;
            EXPECT_EQ(path, nullptr) << one.name;
            continue;
        }
        EXPECT_NEAR(outer, 1.0, 1e-14) << one.name;
        // If ω differs from the axis by an ulp, the herpolhode has a relative error of a few
        // hundredths.
        const double slack = std::string_view(one.name) == "nearly a sphere" ? 0.03 : 1e-8;
        EXPECT_LE(contact.norm(), 1.0 + slack) << one.name;
        EXPECT_GE(contact.norm(), inner - slack) << one.name;
        ASSERT_NE(path, nullptr) << one.name;
        for (const Eigen::Vector3d& point : path->geometry->points) {
            EXPECT_LE(point.norm(), 1.0 + slack) << one.name;
        }
        const auto i = static_cast<std::size_t>(path->last);
        const auto& points = path->geometry->points;
        const Eigen::Vector3d end =
            points[i] + (path->last - static_cast<double>(i)) *
                            (points[std::min(i + 1, points.size() - 1)] - points[i]);
        // The end of the shown part moves along the chord at a constant rate.
        EXPECT_LT((end - contact).norm(), 2e-2) << one.name;
    }
}

// No edge of the panel cuts it.
TEST(PlanPanel, PlaneEndsInsideThePanel) {
    for (const auto& [width_px, height_px] : {std::pair(640, 360), std::pair(300, 640)}) {
        Scene scene = free_scene(generic_moments, generic_omega, "plan");
        scene.film.width_px = width_px;
        scene.film.height_px = height_px;
        const StagedScene staged(scene, 10.0);
        const Drawing drawing = staged.stage.at(1.0);
        const View& view = view_of(drawing);
        ASSERT_EQ(view.planes.size(), 1u);
        const double high = view.camera.height_units;
        const double wide = high * view.width_px / view.height_px;
        EXPECT_LE(view.planes[0].radius, 0.5 * std::min(high, wide) * (1.0 + 1e-12));
        EXPECT_GT(view.planes[0].radius, 1.0);  // of the herpolhode's outer circle
        EXPECT_LT(view.planes[0].fade_from, 1.0);
    }
}

// A circled point towards the reader, a circled cross away.
TEST(PlanPanel, SignOfMomentumSaysWhereItPoints) {
    for (const char* plane : {"below", "above"})
        for (const double elevation_deg : {25.0, -25.0}) {
            Scene scene = free_scene(generic_moments, generic_omega, "plan");
            scene.construction.plane = plane;
            scene.camera.elevation_deg = elevation_deg;
            const StagedScene staged(scene, 10.0);
            const Drawing drawing = staged.stage.at(1.0);
            int n_circles = 0, n_lines = 0, n_points = 0;
            for (const Curve& curve : view_of(drawing).curves) {
                if (curve.name.element != "momentum") continue;
                ++(curve.geometry->closed ? n_circles : n_lines);
            }
            for (const Dot& dot : view_of(drawing).dots)
                n_points += dot.name.element == "momentum" ? 1 : 0;
            // L points down if the plane is below; the reader is on the camera's side of the plane.
            const bool towards = (std::string_view(plane) == "above") ==
                                 (drawing.views[0].camera.eye.z() > 0.0 && elevation_deg > 0.0);
            EXPECT_EQ(n_circles, 1);
            EXPECT_EQ(n_points, towards ? 1 : 0) << plane << elevation_deg;
            EXPECT_EQ(n_lines, towards ? 0 : 2) << plane << elevation_deg;
        }
}

}  // namespace
}  // namespace poinsot::panels_tests
