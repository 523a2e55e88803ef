// Flips against the quarter periods of Jacobi's functions, and against the motion itself.
#include "construction/flips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mechanics/motion.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;

MotionProblem problem_with(const Vector3d& moments, const Vector3d& omega) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(moments);
    problem.start.omega_body = omega;
    return problem;
}

std::optional<Flips> flips_with(const Vector3d& moments, const Vector3d& omega) {
    const MotionProblem problem = problem_with(moments, omega);
    return flips_of(problem, Motion(problem).free_constants());
}

// The changes of sign of a component of ω, by steps and bisection.
std::vector<double> crossings(const Motion& motion, int axis, double first_s, double last_s) {
    std::vector<double> found;
    constexpr int n_steps = 4000;
    const auto value = [&](double t) { return motion.at(t).omega_body[axis]; };
    for (int k = 0; k < n_steps; ++k) {
        double a = first_s + (last_s - first_s) * k / n_steps;
        double b = first_s + (last_s - first_s) * (k + 1) / n_steps;
        if (std::signbit(value(a)) == std::signbit(value(b))) continue;
        for (int round = 0; round < 80; ++round) {
            const double middle = 0.5 * (a + b);
            (std::signbit(value(middle)) == std::signbit(value(a)) ? a : b) = middle;
        }
        found.push_back(0.5 * (a + b));
    }
    return found;
}

TEST(Flips, AreWhereOmegaAlongTheMiddleAxisChangesItsSign) {
    struct Case {
        Vector3d moments, omega;
        int axis;
    };
    for (const Case& one :
         {Case{{3.0, 2.0, 1.0}, {0.01, 2.0, 0.01}, 1}, Case{{3.0, 2.0, 1.0}, {0.02, -2.0, 0.01}, 1},
          Case{{1.0, 3.0, 2.0}, {0.03, 0.02, -1.5}, 2},
          Case{{2.0, 1.0, 3.0}, {1.5, 1e-5, 2e-5}, 0}}) {
        const MotionProblem problem = problem_with(one.moments, one.omega);
        const Motion motion(problem);
        const auto flips = flips_of(problem, motion.free_constants());
        ASSERT_TRUE(flips);
        EXPECT_EQ(flips->axis, one.axis);
        const std::vector<double> times = flips->between(-20.0, 40.0, 1000);
        const std::vector<double> wanted = crossings(motion, one.axis, -20.0, 40.0);
        ASSERT_EQ(times.size(), wanted.size());
        ASSERT_GE(times.size(), 2u);
        // Bisected to rounding of t; measured 3e-14
        for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], wanted[i], 1e-12);
        // Half a period apart, and the limit is kept.
        EXPECT_NEAR(times[1] - times[0], 0.5 * *motion.free_constants().polhode_period_s, 1e-12);
        EXPECT_EQ(flips->between(-20.0, 40.0, 2).size(), 2u);
    }
}

// From ω = (0, ω₂, ω₃): cn u₀ = 0 or sn u₀ = ±1, so that the flip is a quarter period away.
TEST(Flips, FollowAQuarterPeriodAfterTheNearestPointToTheMiddleAxis) {
    const MotionProblem problem = problem_with({1.0, 2.0, 3.0}, {0.0, 1.0, 0.05});
    const FreeRotationConstants constants = Motion(problem).free_constants();
    const auto flips = flips_of(problem, constants);
    ASSERT_TRUE(flips);
    EXPECT_NEAR(std::abs(flips->one_s), 0.25 * *constants.polhode_period_s, 1e-13);
}

TEST(Flips, OfTheSeparatrixIsOne) {
    const auto flips = flips_with({1.0, 2.0, 2.25}, {1.5, 1.0, 2.0});
    ASSERT_TRUE(flips);
    EXPECT_FALSE(flips->interval_s);
    const Motion motion(problem_with({1.0, 2.0, 2.25}, {1.5, 1.0, 2.0}));
    EXPECT_NEAR(motion.at(flips->one_s).omega_body[1], 0.0, 1e-14);
    EXPECT_EQ(flips->between(-100.0, 100.0, 9), std::vector<double>{flips->one_s});
    EXPECT_TRUE(flips->between(50.0, 100.0, 9).empty());
}

TEST(Flips, AreNoneForAWobbleAboutAnotherAxis) {
    EXPECT_FALSE(flips_with({1.0, 2.0, 3.0}, {2.5, 0.4, 0.3}));
    EXPECT_FALSE(flips_with({1.0, 2.0, 3.0}, {0.5, 0.3, 2.5}));
    EXPECT_FALSE(flips_with({1.0, 2.0, 3.0}, {0.0, 2.0, 0.0}));  // permanent
    EXPECT_FALSE(flips_with({1.0, 1.0, 1.8}, {1.5, 0.0, 1.5}));  // symmetric
    EXPECT_FALSE(flips_with({2.0, 2.0, 2.0}, {1.5, 0.0, 1.5}));
    EXPECT_FALSE(flips_with({1.0, 2.0, 3.0}, {0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace poinsot
