// Marks at multiples of α, against marks that are set and sorted one by one.
#include "numerics/three_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace poinsot::three_gaps_tests {
namespace {

double largest_gap(double alpha, int n) {
    std::vector<double> marks;
    for (int k = 0; k < n; ++k) marks.push_back(k * alpha - std::floor(k * alpha));
    std::sort(marks.begin(), marks.end());
    marks.push_back(1.0);
    double largest = 0.0;
    for (std::size_t i = 1; i < marks.size(); ++i)
        largest = std::max(largest, marks[i] - marks[i - 1]);
    return largest;
}

TEST(ThreeGaps, FindHowManyMarksLeaveNoLargerGap) {
    for (const double alpha : {0.6180339887498949, 1.7504912, std::sqrt(2.0), 0.001237, 0.9987121,
                               -0.3141592, 12.25031}) {
        for (const double gap : {0.6, 0.3, 0.07, 0.011, 0.0023}) {
            const auto n = marks_until_gap(alpha, gap);
            ASSERT_TRUE(n) << alpha << " " << gap;
            ASSERT_LT(*n, 1e6);
            constexpr double rounding = 1e-9;
            EXPECT_LE(largest_gap(alpha, static_cast<int>(*n)), gap + rounding)
                << alpha << " " << gap;
            // With one mark less a gap is still too large.
            EXPECT_GT(largest_gap(alpha, static_cast<int>(*n) - 1), gap - rounding)
                << alpha << " " << gap;
        }
    }
}

TEST(ThreeGaps, OfAFractionNeverCloseUp) {
    EXPECT_FALSE(marks_until_gap(0.0, 0.1));
    EXPECT_FALSE(marks_until_gap(0.75, 0.2));
    EXPECT_EQ(marks_until_gap(0.75, 0.3), 4.0);
}

TEST(ThreeGaps, ReturnWithTheDenominatorsOfTheContinuedFraction) {
    std::vector<std::int64_t> tried;
    const auto none = [&](std::int64_t k, double distance) {
        EXPECT_NEAR(distance,
                    std::abs(std::remainder(static_cast<double>(k) * std::sqrt(2.0), 1.0)), 1e-15);
        tried.push_back(k);
        return false;
    };
    EXPECT_FALSE(returning_mark(std::sqrt(2.0), 1000, none));
    EXPECT_EQ(tried, (std::vector<std::int64_t>{1, 2, 5, 12, 29, 70, 169, 408, 985}));
    const auto at_once = [](std::int64_t, double distance) { return distance < 1e-12; };
    EXPECT_EQ(returning_mark(0.0, 10, at_once), 1);
    EXPECT_EQ(returning_mark(1.75, 10, at_once), 4);
}

}  // namespace
}  // namespace poinsot::three_gaps_tests
