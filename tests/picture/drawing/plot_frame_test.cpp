#include "drawing/figures/charts/plot_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace poinsot {
namespace {

std::vector<std::string> labels_of(const Axis& axis) {
    std::vector<std::string> labels;
    for (const Tick& tick : axis.ticks) labels.push_back(tick.label);
    return labels;
}

TEST(PlotFrame, TicksAreMultiplesOfOneTwoOrFive) {
    for (double extent = 1e-9; extent < 1e9; extent *= 1.37) {
        for (const int most : {2, 4, 7, 10}) {
            const Axis axis = linear_axis(-0.3 * extent, 0.7 * extent, most);
            ASSERT_GE(axis.ticks.size(), 3u) << extent;
            // If steps of 5 give two ticks, steps of 2 may give seven.
            EXPECT_LE(axis.ticks.size(), static_cast<std::size_t>(std::max(most, 6)) + 1) << extent;
            const double step = axis.ticks[1].value - axis.ticks[0].value;
            const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
            EXPECT_LT(
                std::min({std::abs(digit - 1.0), std::abs(digit - 2.0), std::abs(digit - 5.0)}),
                1e-6)
                << step;
        }
    }
}

TEST(PlotFrame, NumbersGiveTheValuesOfTheTicks) {
    EXPECT_EQ(labels_of(linear_axis(-1.1, 1.1, 5)),
              (std::vector<std::string>{"-1.0", "-0.5", "0", "0.5", "1.0"}));
    EXPECT_EQ(labels_of(linear_axis(0.0, 16.0, 8)),
              (std::vector<std::string>{"0", "2", "4", "6", "8", "10", "12", "14", "16"}));
    // Small and large numbers are in units of a power of ten.
    const Axis small = linear_axis(0.0, 2.1e-8, 4);
    EXPECT_EQ(small.exponent, -8);
    EXPECT_EQ(labels_of(small), (std::vector<std::string>{"0", "1", "2"}));
    EXPECT_EQ(linear_axis(0.0, 3e7, 4).exponent, 7);
    // A short range at a late time keeps its digits.
    const Axis late = linear_axis(1e9, 1e9 + 10.0, 5);
    EXPECT_EQ(late.exponent, 0);
    EXPECT_EQ(late.ticks.front().label, "1000000000");
}

TEST(PlotFrame, EveryTickHasADifferentNumber) {
    for (const double first : {-3.7, 0.0, 0.1, 99.9, 1234.5, 1e9}) {
        for (const double extent : {1e-6, 0.013, 0.9, 7.0, 555.0}) {
            const Axis axis = linear_axis(first, first + extent, 6);
            const auto labels = labels_of(axis);
            EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), labels.size())
                << first << " " << extent;
        }
    }
}

TEST(PlotFrame, EmptyRangesAreWidened) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const auto& [first, last] : std::vector<std::pair<double, double>>{{0.0, 0.0},
                                                                            {2.0, 2.0},
                                                                            {-1e-300, -1e-300},
                                                                            {nan, 1.0},
                                                                            {-infinite, infinite},
                                                                            {1e300, 1e300},
                                                                            {5e-324, 5e-324}}) {
        const Axis axis = linear_axis(first, last, 5);
        EXPECT_TRUE(std::isfinite(axis.first) && std::isfinite(axis.last)) << first;
        EXPECT_GT(axis.last, axis.first) << first;
        EXPECT_LE(axis.ticks.size(), 12u) << first;
    }
}

TEST(PlotFrame, DecadesAreAtWholePowers) {
    EXPECT_EQ(labels_of(decade_axis(-17.0, -14.0, 5)),
              (std::vector<std::string>{"10^{-17}", "10^{-16}", "10^{-15}", "10^{-14}"}));
    EXPECT_LE(decade_axis(-300.0, 0.0, 6).ticks.size(), 7u);
}

TEST(PlotFrame, TitleHasQuantityAndUnit) {
    EXPECT_EQ(axis_title("$t$", "s", 0), "$t$ / s");
    EXPECT_EQ(axis_title("$\\omega_i$", "rad/s", 0), "$\\omega_i$ / (rad/s)");
    EXPECT_EQ(axis_title("$\\omega_i$", "rad/s", -8), "$\\omega_i$ / ($10^{-8}$ rad/s)");
    EXPECT_EQ(axis_title("relative residual", "", 0), "relative residual");
}

}  // namespace
}  // namespace poinsot
