// Ranges of charts.
#include "drawing/figures/charts/plot_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/style/theme.h"
#include "mechanics/half_life.h"
#include "scenes_by_hand.h"
#include "styled_scenes.h"

namespace poinsot::style_tests {
namespace {

// A pencil that spins about its length, and loses this spin by friction within a thousandth of the
// film: from ω = 20 rad/s to L/I_max = 1.96 rad/s about e3. The chart shows the latter's range.
TEST(Plots, FirstInstantsThatWidenTheRangeTooMuchAreExcluded) {
    Scene scene = free_scene({0.1, 1.0, 1.05}, {20.0, 0.4, 0.2}, "plot");
    scene.film.duration_s = 60.0;
    scene.panels[0].quantity = "omega";
    scene.torque = InternalFriction{
        friction_rate_of_half_life(scene.body.inertia, scene.start.omega_rad_s, 0.05)};
    scene.method = {.name = "dopri5", .step_s = {}, .tolerance = 1e-9, .order = {}};
    const StagedScene staged(scene, 60.0);
    const View view = staged.stage.at(30.0).views.at(0);
    const Theme& theme = theme_named("light");
    std::array<double, 3> ends{};
    double least_y = 1e300, most_y = -1e300;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& points = curve_in(view, theme.axes[i])->geometry->points;
        ends[i] = points.back().y();
        for (const Eigen::Vector3d& point : points) {
            least_y = std::min(least_y, point.y());
            most_y = std::max(most_y, point.y());
        }
    }
    EXPECT_NEAR(ends[0], ends[1], 0.5);
    // Of a range of 20 it would be a tenth.
    EXPECT_GT(std::abs(ends[2] - ends[0]), 0.4 * (most_y - least_y));
    EXPECT_GT(least_y, 0.0);
    EXPECT_LT(most_y, view.height_px);
}

TEST(Plots, RangesOfSimilarWidthAreNotChanged) {
    const PlotQuantity& omega_row =
        *std::find_if(plot_quantities().begin(), plot_quantities().end(),
                      [](const PlotQuantity& quantity) { return quantity.name == "omega"; });
    EXPECT_TRUE(is_ruined(omega_row, {0.0, 20.0}, {0.0, 2.0}));
    EXPECT_FALSE(is_ruined(omega_row, {0.0, 20.0}, {0.0, 10.0}));
    EXPECT_FALSE(is_ruined(omega_row, {0.0, 20.0}, {19.0, 20.0}));  // its axis includes 0
    EXPECT_FALSE(is_ruined(omega_row, {0.0, 20.0}, {0.0, 1e-3}));   // it comes to rest
}

// The second motion may widen the chart by as much as the first one's chart, which may begin at 0.
TEST(Plots, SecondMotionAtMostDoublesTheChart) {
    PlotQuantity quantity{};
    quantity.from_zero = true;
    EXPECT_EQ(common_range(quantity, {6.0, 8.0}, {5.0, 30.0}), std::pair(0.0, 16.0));
    EXPECT_EQ(common_range(quantity, {6.0, 8.0}, {5.0, 10.0}), std::pair(0.0, 10.0));
    quantity.from_zero = false;
    EXPECT_EQ(common_range(quantity, {6.0, 8.0}, {5.0, 30.0}), std::pair(5.0, 10.0));
}

}  // namespace
}  // namespace poinsot::style_tests
