#include "drawing/figures/charts/flight_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

ChartedFlight flight_of(std::size_t n_rows, double residual) {
    ChartedFlight flight;
    const auto omega = [](double t) { return Eigen::Vector3d(std::cos(t), std::sin(t), 0.5 * t); };
    for (std::size_t i = 0; i < n_rows; ++i) {
        const double t = 0.1 * static_cast<double>(i);
        flight.times_s.push_back(3.0 + t);
        flight.curve.push_back(omega(t));
        flight.measured.emplace_back(omega(t) + Eigen::Vector3d(0.0, 0.0, residual));
        flight.residuals.emplace_back(0.0, 0.0, residual);
    }
    flight.curve_times_s = flight.times_s;
    return flight;
}

bool has_dot_at(const std::vector<Dot>& dots, const Eigen::Vector3d& at) {
    return std::any_of(dots.begin(), dots.end(),
                       [&at](const Dot& dot) { return (dot.at - at).norm() < 1e-6; });
}

// Measured rows that the motion meets exactly: each row is a dot on its curve, and its residual is
// on a line.
TEST(FlightChart, PutsRowsOnTheirCurvesAndTheirResidualsOnZero) {
    FlightChart chart;
    chart.flights = {flight_of(20, 0.0)};
    const FlightSheet sheet(chart, theme_named("light"), installed_fonts());
    const Drawing drawing = sheet.drawing();
    const View& view = drawing.views.front();
    std::size_t n_curves = 0;
    for (const Curve& curve : view.curves) {
        if (curve.geometry->points.size() != 20) continue;
        ++n_curves;
        for (const Eigen::Vector3d& point : curve.geometry->points)
            EXPECT_TRUE(has_dot_at(view.dots, point));
    }
    EXPECT_EQ(n_curves, 3U);
    // Three components twice, and one dot each in the legend.
    EXPECT_EQ(view.dots.size(), 2U * 3U * 20U + 3U);
    double zero = -1.0;
    std::size_t n_on_zero = 0;
    for (const Dot& dot : view.dots) {
        const auto n = static_cast<std::size_t>(std::count_if(
            view.dots.begin(), view.dots.end(),
            [&dot](const Dot& other) { return std::abs(other.at.y() - dot.at.y()) < 1e-6; }));
        if (n > n_on_zero) {
            n_on_zero = n;
            zero = dot.at.y();
        }
    }
    EXPECT_EQ(n_on_zero, 60U);
    EXPECT_LT(zero, 0.35 * drawing.height_px);  // y is up
}

TEST(FlightChart, ShowsTheRatiosOfFlightsAndWhoIsLeftOut) {
    FlightChart chart;
    for (int i = 0; i < 5; ++i) {
        ChartedFlight flight = flight_of(20, 0.01);
        flight.ratios = Eigen::Vector2d(0.7 + 0.01 * i, 0.4);
        flight.ratios_sd = Eigen::Vector2d(0.02, 0.01);
        flight.is_left_out = i == 4;
        chart.flights.push_back(flight);
    }
    const auto height_without = [&chart] {
        return FlightSheet(chart, theme_named("light"), installed_fonts()).drawing().height_px;
    };
    const int alone = height_without();
    chart.ratios = Eigen::Vector2d(0.72, 0.4);
    chart.ratios_sd = Eigen::Vector2d(0.01, 0.01);
    const FlightSheet sheet(chart, theme_named("light"), installed_fonts());
    const Drawing drawing = sheet.drawing();
    EXPECT_GT(drawing.height_px, alone);
    const auto& dots = drawing.views.front().dots;
    // The ratios of flights 0 to 3 rise evenly, the others are equal.
    std::vector<Dot> large;
    for (const Dot& dot : dots)
        if (dot.radius_px > 6.0) large.push_back(dot);
    ASSERT_EQ(large.size(), 10U);
    for (std::size_t i = 1; i < 3; ++i) {
        EXPECT_NEAR(large[i + 1].at.y() - large[i].at.y(), large[i].at.y() - large[i - 1].at.y(),
                    1e-6);
        EXPECT_GT(large[i].at.y(), large[i - 1].at.y());
        EXPECT_NEAR(large[5 + i].at.y(), large[5].at.y(), 1e-6);
    }
    for (const Dot& dot : dots) {
        EXPECT_GE(dot.at.x(), 0.0);
        EXPECT_LE(dot.at.x(), drawing.width_px);
        EXPECT_GE(dot.at.y(), 0.0);
        EXPECT_LE(dot.at.y(), drawing.height_px);
    }
}

// A long recording stays a chart that opens quickly.
TEST(FlightChart, ThinsTheDotsOfManyRows) {
    FlightChart chart;
    chart.flights = {flight_of(20'000, 0.01)};
    const FlightSheet sheet(chart, theme_named("light"), installed_fonts());
    EXPECT_LE(sheet.drawing().views.front().dots.size(), 2U * 3U * 500U + 3U);
}

}  // namespace
}  // namespace poinsot
