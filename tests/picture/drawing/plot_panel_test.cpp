// The plot panel: values, their order and which motions have them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

std::vector<const Curve*> measured_curves(const View& view) {
    std::vector<const Curve*> curves;
    for (const Curve& curve : view.curves)
        if (curve.name.element == "measured") curves.push_back(&curve);
    return curves;
}

// ω times a constant c has T times c² and L times c: heights in the chart, above the exact line, in
// the ratio of the constants' excesses, for two tables in one chart's scale.
TEST(PlotPanel, MeasuredTAndLLieAtTheirValues) {
    for (const auto& [quantity, power] :
         {std::pair{"measured_energy", 2.0}, std::pair{"measured_momentum", 1.0}}) {
        Scene scene = free_scene(generic_moments, generic_omega, "plot");
        scene.panels[0].quantity = quantity;
        measure(scene, 10.0, 41, 1.02);
        // The second half of the table has another factor.
        auto& rows = scene.measured.motion.rows;
        for (std::size_t i = 20; i < rows.size(); ++i) rows[i].omega_body *= 1.04 / 1.02;
        const StagedScene staged(scene, 10.0);
        const View view = staged.stage.at(10.0).views.at(0);
        const double exact = view.dots.at(0).at.y();
        const auto curves = measured_curves(view);
        ASSERT_EQ(curves.size(), 1u);
        const auto& points = curves[0]->geometry->points;
        ASSERT_EQ(points.size(), 41u);
        const double ratio = (std::pow(1.04, power) - 1.0) / (std::pow(1.02, power) - 1.0);
        EXPECT_NEAR((points[40].y() - exact) / (points[0].y() - exact), ratio, 1e-9) << quantity;
        EXPECT_GT(points[0].y() - exact, 20.0);  // px: the drift is seen
    }
}

// Attitudes turned about an axis across L by an angle tilt L by it; a table without attitudes has
// no such chart.
TEST(PlotPanel, MeasuredTiltOfLIsTheAngleByWhichItIsTurned) {
    Scene scene = free_scene(generic_moments, generic_omega, "plot");
    scene.panels[0].quantity = "measured_tilt";
    measure(scene, 10.0, 41);
    const Eigen::Vector3d momentum = generic_moments.cwiseProduct(generic_omega);
    auto& rows = scene.measured.motion.rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].space_from_body =
            Eigen::AngleAxisd(i < 20 ? 0.01 : 0.03, momentum.unitOrthogonal()) *
            rows[i].space_from_body;
    const StagedScene staged(scene, 10.0);
    const View view = staged.stage.at(10.0).views.at(0);
    const auto curves = measured_curves(view);
    ASSERT_EQ(curves.size(), 1u);
    const auto& points = curves[0]->geometry->points;
    const double exact = view.dots.at(0).at.y();
    EXPECT_NEAR((points[40].y() - exact) / (points[0].y() - exact), 3.0, 1e-6);

    scene.measured.motion.has_attitude = false;
    EXPECT_THROW(StagedScene(scene, 10.0), InputError);
    scene.panels[0].quantity = "measured_energy";
    EXPECT_NO_THROW(StagedScene(scene, 10.0));
    scene.measured = {};
    EXPECT_THROW(StagedScene(scene, 10.0), InputError);
}

// Each component is drawn, without a line across missing rows; what does not follow from the rows
// is not.
TEST(PlotPanel, MeasuredValuesAreInterruptedAtGaps) {
    Scene scene = free_scene(generic_moments, generic_omega, "plot");
    measure(scene, 10.0, 41);
    auto& rows = scene.measured.motion.rows;
    rows.erase(rows.begin() + 10, rows.begin() + 20);
    const StagedScene staged(scene, 10.0);
    const View view = staged.stage.at(3.0).views.at(0);
    std::vector<std::size_t> lengths;
    for (const Curve* curve : measured_curves(view))
        lengths.push_back(curve->geometry->points.size());
    EXPECT_EQ(lengths, (std::vector<std::size_t>{10, 21, 10, 21, 10, 21}));
    // The exact motion's rows lie on the exact curves.
    for (const Curve* curve : measured_curves(view))
        for (const Eigen::Vector3d& point : curve->geometry->points) {
            double nearest = 1e300;
            for (const Curve& other : view.curves) {
                if (other.name.element == "measured" || other.geometry->points.size() < 3) continue;
                const auto& line = other.geometry->points;
                for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                    const Eigen::Vector3d run = line[i + 1] - line[i];
                    const double s =
                        std::clamp(run.dot(point - line[i]) / run.squaredNorm(), 0.0, 1.0);
                    nearest = std::min(nearest, (line[i] + s * run - point).norm());
                }
            }
            EXPECT_LT(nearest, 0.1);  // px: accuracy_px
        }
    scene.panels[0].quantity = "residuals";
    const StagedScene residuals(scene, 10.0);
    EXPECT_TRUE(measured_curves(residuals.stage.at(3.0).views.at(0)).empty());
}

}  // namespace
}  // namespace poinsot::panels_tests
