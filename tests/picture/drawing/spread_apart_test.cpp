// Names at the ends of curves do not overlap and stay near their curves.
#include "drawing/stage/type/spread_apart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace poinsot {
namespace {

using Numbers = std::vector<double>;

TEST(SpreadApart, DoesNotMoveItemsWithoutOverlap) {
    const Numbers wished{70.0, 10.0, 40.0};
    EXPECT_EQ(spread_apart(wished, {20.0, 20.0, 20.0}, 5.0, 0.0, 100.0), wished);
}

TEST(SpreadApart, MovesTwoOverlappingItemsEqually) {
    const Numbers middles = spread_apart({50.0, 54.0}, {20.0, 10.0}, 3.0, 0.0, 200.0);
    // 18 apart, symmetric about 52.
    EXPECT_DOUBLE_EQ(middles[0], 43.0);
    EXPECT_DOUBLE_EQ(middles[1], 61.0);
}

TEST(SpreadApart, StaysAboveTheLowerLimit) {
    const Numbers middles = spread_apart({1.0, 0.0, 2.0}, {10.0, 10.0, 10.0}, 2.0, 0.0, 100.0);
    EXPECT_EQ(middles, (Numbers{17.0, 5.0, 29.0}));
}

TEST(SpreadApart, KeepsOrderGapAndLeastSquaresAtRandom) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0.0, 400.0);
    std::uniform_real_distribution<double> height(5.0, 30.0);
    constexpr double gap = 4.0;
    constexpr double rounding = 1e-9;
    for (int trial = 0; trial < 300; ++trial) {
        Numbers wished(6);
        Numbers heights(6);
        std::generate(wished.begin(), wished.end(), [&] { return place(random); });
        std::generate(heights.begin(), heights.end(), [&] { return height(random); });
        const Numbers middles = spread_apart(wished, heights, gap, -1e6, 1e6);
        std::vector<std::size_t> order(6);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t i, std::size_t j) { return wished[i] < wished[j]; });
        // Touching items form a block whose mean displacement is zero.
        double displacement = 0.0;
        for (std::size_t k = 0; k < 6; ++k) {
            const std::size_t i = order[k];
            displacement += middles[i] - wished[i];
            if (k == 5) break;
            const std::size_t above = order[k + 1];
            const double room =
                middles[above] - middles[i] - 0.5 * (heights[i] + heights[above]) - gap;
            EXPECT_GE(room, -rounding);
            if (room > rounding) {
                EXPECT_NEAR(displacement, 0.0, rounding);
                displacement = 0.0;
            }
        }
        EXPECT_NEAR(displacement, 0.0, rounding);
    }
}

}  // namespace
}  // namespace poinsot
