// The plan panel: the herpolhode between its circles.
#include <gtest/gtest.h>

#include <algorithm>

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

}  // namespace
}  // namespace poinsot::panels_tests
