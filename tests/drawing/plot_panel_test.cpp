// The plot panel: values, their order and which motions have them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "drawing/figures/charts/plot_quantity.h"
#include "error/error.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(PlotPanel, DotsLieOnTheirCurvesUnderTheCursor) {
    const StagedScene staged(free_scene(generic_moments, generic_omega, "plot"), 10.0);
    for (int k = 0; k <= 20; ++k) {
        const Drawing drawing = staged.stage.at(0.5 * k);
        const View& view = view_of(drawing);
        ASSERT_EQ(view.dots.size(), 3u);
        std::size_t at = 0;
        for (const Curve& curve : view.curves) {
            if (curve.geometry->points.size() < 3) continue;
            const Eigen::Vector3d dot = view.dots[at++].at;
            EXPECT_NEAR(dot.x(), view.dots[0].at.x(), 1e-9);
            double nearest = 1e300;
            const auto& points = curve.geometry->points;
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                if (points[i].x() > dot.x() + 1e-9 || points[i + 1].x() < dot.x() - 1e-9) continue;
                const double s = (dot.x() - points[i].x()) / (points[i + 1].x() - points[i].x());
                nearest = std::min(
                    nearest,
                    std::abs(points[i].y() + s * (points[i + 1].y() - points[i].y()) - dot.y()));
            }
            EXPECT_LT(nearest, 0.1);  // px: accuracy_px; measured 0.05
        }
        EXPECT_EQ(at, 3u);
    }
}

// Rounding noise around zero is not drawn as a curve and does not determine the order of names.
TEST(PlotPanel, RoundingNoiseIsOnTheLowestLineInTableOrder) {
    for (const Eigen::Vector3d& omega : {generic_omega, Eigen::Vector3d(0.3, 2.0, 0.1)}) {
        Scene scene = free_scene(generic_moments, omega, "plot");
        scene.panels[0].quantity = "residuals";
        const StagedScene staged(scene, 10.0);
        const Drawing drawing = staged.stage.at(7.0);
        const View& view = view_of(drawing);
        ASSERT_EQ(view.dots.size(), 5u);
        for (const Dot& dot : view.dots) EXPECT_EQ(dot.at.y(), view.dots[0].at.y());
        for (const Curve& curve : view.curves) {
            if (curve.geometry->points.size() < 3) continue;
            for (const Eigen::Vector3d& point : curve.geometry->points)
                ASSERT_EQ(point.y(), view.dots[0].at.y());
        }
        // The names are the last labels, stacked upwards in the order of the table.
        ASSERT_GE(view.labels.size(), 5u);
        const std::span names(view.labels.end() - 5, view.labels.end());
        for (std::size_t i = 1; i < names.size(); ++i)
            EXPECT_LT(names[i].top_left_px.y(), names[i - 1].top_left_px.y()) << i;
    }
}

TEST(PlotPanel, QuantitiesDependOnTheMotion) {
    Scene scene = free_scene(generic_moments, generic_omega, "plot");
    for (const char* quantity : {"omega", "energy", "residuals"}) {
        scene.panels[0].quantity = quantity;
        const StagedScene staged(scene, 10.0);
        const Drawing drawing = staged.stage.at(1.0);
        expect_finite(view_of(drawing), quantity);
    }
    scene.panels[0].quantity = "euler_angles";
    EXPECT_THROW(StagedScene(scene, 10.0), InputError);
    scene.panels[0].quantity = "omgea";
    try {
        const StagedScene staged(scene, 10.0);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"omega\"?"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace poinsot::panels_tests
