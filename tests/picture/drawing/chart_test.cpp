#include "drawing/figures/charts/chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "error/error.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

TEST(Chart, DecadesAreEquallySpaced) {
    const Chart chart{"t", "x", "y", {{"s", {{1.0, 1e-6}, {10.0, 1e-4}, {100.0, 1e-2}}}}};
    const ChartSheet builder(chart, theme_named("light"), installed_fonts(), 960, 540);
    const Drawing drawing = builder.drawing();
    const std::vector<Dot>& dots = drawing.views.at(0).dots;
    ASSERT_EQ(dots.size(), 3u);
    EXPECT_NEAR((dots[0].at + dots[2].at - 2.0 * dots[1].at).norm(), 0.0, 1e-9);
    for (const Dot& dot : dots) {
        EXPECT_GE(dot.at.x(), 0.0);
        EXPECT_LE(dot.at.x(), 960.0);
        EXPECT_GE(dot.at.y(), 0.0);
        EXPECT_LE(dot.at.y(), 540.0);
    }
    // A smaller y is lower in the picture; y of the view is up.
    EXPECT_LT(dots[0].at.y(), dots[2].at.y());
}

TEST(Chart, SmallRangesSpanOneTwoOrFive) {
    // From 2 to 20: the axis's middle is the geometric mean.
    const Chart chart{
        "t", "x", "y", {{"s", {{2.5, 3.0}, {std::sqrt(40.0), 6.0}, {15.0, 12.0, true, "name"}}}}};
    const ChartSheet builder(chart, theme_named("light"), installed_fonts(), 960, 540);
    const Drawing drawing = builder.drawing();
    const View& view = drawing.views.at(0);
    ASSERT_EQ(view.dots.size(), 3u);
    const double left = view.curves.front().geometry->points.front().x();  // grid line of 2
    const double right = view.curves.at(3).geometry->points.front().x();   // of 5, 10, 20
    EXPECT_NEAR(view.dots[1].at.x(), 0.5 * (left + right), 1e-9);
    EXPECT_LT(left, view.dots[0].at.x());
    EXPECT_LT(view.dots[2].at.x(), right);
    // Four numbers per axis, title and captions, and the names of series and point.
    EXPECT_EQ(view.labels.size(), 4u + 4u + 3u + 2u);
}

TEST(Chart, RejectsEmptyCharts) {
    const Chart chart{"t", "x", "y", {{"s", {{0.0, 1.0}}}}};
    EXPECT_THROW(ChartSheet(chart, theme_named("light"), installed_fonts(), 960, 540), InputError);
}

}  // namespace
}  // namespace poinsot
