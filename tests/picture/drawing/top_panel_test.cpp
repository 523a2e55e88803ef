// The top panel: the axis and its circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drawing/figures/charts/plot_quantity.h"
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

// The path and the circles are paler on the far side, as if the sphere were of glass.
TEST(TopPanel, SphereHidesTheFarPartsOfItsCurves) {
    const StagedScene staged(top_scene({0.7, 0.0, -0.6, 5.0}, "top"), 10.0);
    const Drawing drawing = staged.stage.at(10.0);
    const View& view = view_of(drawing);
    ASSERT_EQ(view.ellipsoids.size(), 1u);
    EXPECT_TRUE(view.ellipsoids[0].hides_far_curves);
    const auto n = std::count_if(view.curves.begin(), view.curves.end(), [](const Curve& curve) {
        return curve.on_surface == 0 && curve.hidden_opacity <= 0.5;
    });
    EXPECT_EQ(n, 4);  // the equator, two circles and the path
}

// The seconds of [trail] count the path's own instants: the point at its faint end was there then.
TEST(TopPanel, PathCanFade) {
    Scene scene = top_scene({0.7, 0.0, -0.6, 5.0}, "top");
    scene.trail.axis = "fading";
    scene.trail.length_s = 2.5;
    const StagedScene staged(scene, 10.0);
    const auto path_at = [&](double time_s) {
        const Drawing drawing = staged.stage.at(time_s);
        const auto& curves = view_of(drawing).curves;
        const auto path = std::find_if(curves.begin(), curves.end(),
                                       [](const Curve& curve) { return curve.fade_points > 0.0; });
        EXPECT_NE(path, curves.end());
        return *path;
    };
    const auto place = [](const Curve& curve, double index) {
        const auto k = static_cast<std::size_t>(index);
        const auto& points = curve.geometry->points;
        return Eigen::Vector3d(points.at(k) +
                               (index - std::floor(index)) *
                                   (points.at(std::min(k + 1, points.size() - 1)) - points.at(k)));
    };
    const auto e3_at = [&](double time_s) {
        return staged.motion.at(time_s).space_from_body * Eigen::Vector3d::UnitZ();
    };
    const Curve path = path_at(8.0);
    EXPECT_LT((place(path, path.last) - e3_at(8.0)).norm(), 5e-3);
    EXPECT_LT((place(path, path.first) - e3_at(5.5)).norm(), 5e-3);
    EXPECT_EQ(path.fade_points, path.last - path.first);
    // A young trail fades at the rate of a complete one.
    const Curve young = path_at(1.0);
    EXPECT_EQ(young.first, 0.0);
    EXPECT_NEAR(young.fade_points, 2.5 * young.last, 1e-9 * young.last);
}

// Upright or hanging there is no line of nodes; the angle from x to e1 is that of the attitude.
TEST(TopPanel, VerticalAxisHasOneAngle) {
    for (const double theta_rad : {0.0, std::numbers::pi}) {
        const StagedScene staged(top_scene({theta_rad, 0.0, 0.0, 5.0}, "top"), 10.0);
        const Theme& theme = staged.stage.context().theme;
        for (const double t : {0.3, 1.0, 1.4}) {
            const Drawing drawing = staged.stage.at(t);
            const View& view = view_of(drawing);
            const Curve* arc = nullptr;
            for (const Curve& curve : view.curves) {
                for (int i = 0; i < 3; ++i) EXPECT_FALSE(curve.colour == theme.angles[i]) << i;
                if (curve.colour == theme.text &&
                    curve.geometry == staged.stage.store().unit_circle())
                    arc = &curve;
            }
            ASSERT_NE(arc, nullptr);
            const double angle = 2.0 * std::numbers::pi * arc->last /
                                 static_cast<double>(arc->geometry->points.size());
            const Eigen::Vector3d e1 =
                staged.motion.at(t).space_from_body * Eigen::Vector3d::UnitX();
            EXPECT_NEAR(std::remainder(angle - std::atan2(e1.y(), e1.x()), 2.0 * std::numbers::pi),
                        0.0, 1e-12)
                << t;
        }
    }
}

// Its chart shows only the sum, whose rate is φ̇ + ψ̇ = ω₃, or the difference, whose rate is −ω₃.
TEST(TopPanel, ChartOfAVerticalAxisShowsOneAngle) {
    for (const double sign : {1.0, -1.0}) {
        const double theta_rad = sign > 0.0 ? 0.0 : std::numbers::pi;
        const StagedScene staged(top_scene({theta_rad, 0.0, 0.0, 5.0}, "plot"), 10.0);
        const StageContext& stage = staged.stage.context();
        const PlotQuantity& quantity = plot_quantity_of(stage, "euler_angles");
        ASSERT_EQ(quantity.curves.size(), 1u);
        for (const double t : {0.0, 0.7, 9.1}) {
            FrameInput instant;
            instant.time_s = t;
            instant.euler =
                staged.motion
                    .sample(t, {.attitude = false, .herpolhode = false, .euler_angles = true})
                    .euler;
            const PlotValues values = quantity.values(stage, instant);
            EXPECT_NEAR(values[0], sign * 5.0 * t, 1e-13 * (1.0 + 5.0 * t));
        }
    }
    const StagedScene leaning(top_scene({0.7, 0.0, 0.0, 5.0}, "plot"), 10.0);
    EXPECT_EQ(plot_quantity_of(leaning.stage.context(), "").curves.size(), 3u);
}

// Whole turns of φ are circles, and the rest is an arc: together they are the angle of the chart.
TEST(TopPanel, PrecessionCountsTurns) {
    const StagedScene staged(top_scene({0.7, 0.0, 0.45, 5.0}, "top"), 40.0);
    const Theme& theme = staged.stage.context().theme;
    int most_turns = 0;
    for (const double t : {1.0, 6.0, 14.0, 22.0, 30.0, 39.0}) {
        const double phi_rad =
            staged.motion.sample(t, {.attitude = false, .herpolhode = false, .euler_angles = true})
                .euler.phi_rad;
        const Drawing drawing = staged.stage.at(t);
        double drawn_rad = 0.0;
        int n_turns = 0;
        for (const Curve& curve : view_of(drawing).curves) {
            if (!(curve.colour == theme.angles[1]) ||
                curve.geometry != staged.stage.store().unit_circle())
                continue;
            const double n = static_cast<double>(curve.geometry->points.size());
            drawn_rad += 2.0 * pi * std::min(curve.last / n, 1.0);
            n_turns += curve.last >= n ? 1 : 0;
        }
        EXPECT_NEAR(drawn_rad, phi_rad, 1e-9) << t;
        most_turns = std::max(most_turns, n_turns);
    }
    EXPECT_GE(most_turns, 2);
}

// An arc is at least 40 pixels of a picture of 1080 rows long, and ψ of a fast top has none.
TEST(TopPanel, LeavesOutArcsThatNobodyCanRead) {
    const auto n_arcs = [](const StagedScene& staged, double t, int angle) {
        const Drawing drawing = staged.stage.at(t);
        const auto& curves = view_of(drawing).curves;
        return std::count_if(curves.begin(), curves.end(), [&](const Curve& curve) {
            return curve.colour == staged.stage.context().theme.angles[angle] &&
                   curve.on_surface < 0 && curve.geometry == staged.stage.store().unit_circle();
        });
    };
    const StagedScene fast(top_scene({0.7, 0.0, 0.0, 5.0}, "top"), 10.0);
    EXPECT_EQ(n_arcs(fast, 0.01, 1), 0);
    EXPECT_EQ(n_arcs(fast, 5.0, 1), 1);
    EXPECT_EQ(n_arcs(fast, 5.0, 0), 1);
    EXPECT_EQ(n_arcs(fast, 5.0, 2), 0);
    const StagedScene slow(top_scene({0.7, 0.0, 0.6, 1.2}, "top", 0.136), 10.0);
    EXPECT_EQ(n_arcs(slow, 2.0, 2), 1);
}

}  // namespace
}  // namespace poinsot::panels_tests
