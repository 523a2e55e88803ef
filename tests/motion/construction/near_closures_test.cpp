// The fractions near an advance, compared with trying all of them, and the loops that they give.
#include "construction/near_closures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "mechanics/free/free_rotation.h"

namespace poinsot {
namespace {

struct Fraction {
    int p = 0, q = 1;
};

// Every fraction that is nearer than all those with at most its q, by trying them all. Those
// nearest in units of 1/q are the convergents: |q·x − p| is smaller than for every smaller q.
std::vector<Fraction> tried(double x, int most_q) {
    std::vector<Fraction> best;
    double least = INFINITY;
    for (int q = 1; q <= most_q; ++q) {
        const double p = std::round(q * x);
        const double off = std::abs(q * x - p);
        if (!(off < least)) continue;
        least = off;
        if (p >= 1.0) best.push_back({static_cast<int>(p), q});
    }
    return best;
}

TEST(NearClosures, AreTheNearestFractions) {
    std::mt19937 random(13);
    std::uniform_real_distribution<double> number(0.0, 9.0);
    for (int k = 0; k < 2000; ++k) {
        const double x = number(random);
        const std::vector<Closure> found = convergents(x, 40);
        const std::vector<Fraction> wanted = tried(x, 40);
        ASSERT_EQ(found.size(), wanted.size()) << x;
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].turns, wanted[i].p) << x;
            EXPECT_EQ(found[i].periods, wanted[i].q) << x;
            EXPECT_EQ(std::gcd(found[i].turns, found[i].periods), 1) << x;
        }
    }
}

TEST(NearClosures, OfNoNumberAreNone) {
    for (const double turns : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300})
        EXPECT_TRUE(convergents(turns, 1000).empty()) << turns;
}

TEST(NearClosures, EndWithTheFractionItself) {
    const std::vector<Closure> found = convergents(5.0 / 3.0, 12);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.back().turns, 5);
    EXPECT_EQ(found.back().periods, 3);
    EXPECT_TRUE(convergents(NAN, 12).empty());
    EXPECT_TRUE(convergents(-0.7, 12).empty());
}

TEST(NearClosures, CloseTheHerpolhodeByTheChangeThatTheySay) {
    const InertiaTensor body = InertiaTensor::from_principal_moments({1.0, 2.0, 2.9});
    const Eigen::Vector3d spin(1.5, 0.3, 0.75);
    const std::vector<NearClosure> near = near_closures(body, spin, 12);
    ASSERT_GE(near.size(), 2u);
    for (const NearClosure& loop : near) {
        RotationState start;
        start.omega_body = loop.start.omega_body;
        const double turns = *FreeRotation(body, start).constants().advance_per_period_rad /
                             (2.0 * std::numbers::pi);
        EXPECT_NEAR(turns * loop.closure.periods, loop.closure.turns, 1e-11);
        ASSERT_TRUE(loop.start.changed);
        const int i = *loop.start.changed;
        EXPECT_NEAR(loop.relative_change,
                    std::abs(loop.start.omega_body[i] - spin[i]) / spin.norm(), 1e-15);
    }
    EXPECT_LT(near.back().relative_change, near.front().relative_change);
}

TEST(NearClosures, OfAMotionWithoutAPeriodAreNone) {
    const InertiaTensor body = InertiaTensor::from_principal_moments({1.0, 2.0, 2.25});
    EXPECT_TRUE(near_closures(body, {0.0, 0.0, 1.0}, 12).empty());
    EXPECT_TRUE(near_closures(body, {1.5, 1.0, 2.0}, 12).empty());  // the separatrix
}

}  // namespace
}  // namespace poinsot
