// Flips against the quarter periods of Jacobi's functions, and against the motion itself.
#include "construction/flips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
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

// The angle between a principal axis and L, in space.
double angle_to_momentum(const Motion& motion, const Vector3d& moments, int axis, double t) {
    const RotationState state = motion.at(t);
    const Vector3d momentum =
        state.space_from_body * Vector3d(moments.cwiseProduct(state.omega_body));
    const Vector3d e = state.space_from_body * Vector3d::Unit(axis);
    return std::atan2(e.cross(momentum).norm(), e.dot(momentum));
}

// What is said of random bodies, against their attitudes: the encircled axis keeps its side of L
// and stays within the angle said, the middle axis swings between the two angles said, and the body
// turns over if and only if the middle axis comes within 45° of L and of −L.
TEST(Flips, SayWhichAxisKeepsItsSideAndHowFarTheMiddleOneSwings) {
    std::mt19937 engine(11);
    std::uniform_real_distribution<double> moment(1.0, 3.0), component(-2.0, 2.0);
    int n_turning = 0, n_wobbling = 0;
    for (int body = 0; body < 200; ++body) {
        Vector3d moments(moment(engine), moment(engine), moment(engine));
        if (moments.maxCoeff() > 0.95 * (moments.sum() - moments.maxCoeff())) continue;
        const Vector3d omega(component(engine), component(engine), component(engine));
        const MotionProblem problem = problem_with(moments, omega);
        const Motion motion(problem);
        const auto swing = swing_of(problem);
        const double period_s = motion.free_constants().polhode_period_s.value_or(0.0);
        if (!swing || period_s > 200.0) continue;
        constexpr int n = 2000;
        const double quarter = 0.25 * std::numbers::pi;
        double least = 4.0, most = 0.0, kept = 0.0;
        bool leads[2] = {false, false};  // the middle axis is nearest to L, or to −L
        for (int k = 0; k < n; ++k) {
            const double t = period_s * k / n;
            const double middle = angle_to_momentum(motion, moments, swing->middle, t);
            double encircled = angle_to_momentum(motion, moments, swing->encircled, t);
            if (!swing->is_along_momentum) encircled = std::numbers::pi - encircled;
            least = std::min(least, middle), most = std::max(most, middle);
            kept = std::max(kept, encircled);
            leads[0] |= middle < quarter;
            leads[1] |= middle > std::numbers::pi - quarter;
            EXPECT_LT(encircled, 2.0 * quarter) << "it keeps its side";
            if (swing->turns_over()) continue;
            for (int i = 0; i < 3; ++i) {
                if (i == swing->encircled) continue;
                const double angle = angle_to_momentum(motion, moments, i, t);
                EXPECT_GT(std::min(angle, std::numbers::pi - angle), quarter) << i;
            }
        }
        EXPECT_NEAR(least, swing->least_rad, 1e-3);
        EXPECT_GT(least, swing->least_rad - 1e-7);
        EXPECT_NEAR(most, std::numbers::pi - swing->least_rad, 1e-3);
        EXPECT_NEAR(kept, 2.0 * quarter - swing->least_rad, 1e-3);
        const auto flips = flips_of(problem, motion.free_constants());
        EXPECT_EQ(flips.has_value(), swing->turns_over());
        if (std::abs(swing->least_rad - quarter) > 2e-3) {
            EXPECT_EQ(leads[0] && leads[1], swing->turns_over());
        }
        ++(swing->turns_over() ? n_turning : n_wobbling);
        if (!flips) continue;
        // The middle axis passes the plane normal to L at the instants said, twice in a period.
        EXPECT_EQ(flips->between(0.0, 10.0 * period_s, 100).size(), 20u);
        for (const double t : flips->between(0.0, period_s, 100))
            EXPECT_NEAR(angle_to_momentum(motion, moments, swing->middle, t), 2.0 * quarter, 1e-9);
    }
    EXPECT_GT(n_turning, 30);
    EXPECT_GT(n_wobbling, 30);
}

// A book whose middle axis swings from 15.9° to 164.1° turns over.
TEST(Flips, AreThoseOfABookThatStandsOnItsHead) {
    const auto flips = flips_with({4.0, 3.0, 1.5}, {-1.0, 1.1, 1.7});
    ASSERT_TRUE(flips);
    const auto swing = swing_of(problem_with({4.0, 3.0, 1.5}, {-1.0, 1.1, 1.7}));
    ASSERT_TRUE(swing);
    // L² = 33.3925 and 2T = 11.965, so L₂² is at most I₂(L² − 2T I₃)/(I₂ − I₃) = 30.89.
    EXPECT_NEAR(std::cos(swing->least_rad), std::sqrt(30.89 / 33.3925), 1e-12);
}

// Sampled flips of a motion that is computed step by step are those of the closed form; a torque
// that brakes it ends them.
TEST(Flips, OfASteppedMotionAreSampled) {
    MotionProblem problem = problem_with({3.0, 2.0, 1.0}, {0.02, 2.0, 0.01});
    const auto wanted =
        flips_of(problem, Motion(problem).free_constants())->between(0.0, 40.0, 100);
    problem.method.name = "rkmk4";
    problem.method.step_s = 0.01;
    problem.last_time_s = 40.0;
    const auto found = sampled_flips(Motion(problem), 0.0, 40.0);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), wanted.size());
    ASSERT_GE(found->size(), 3u);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR((*found)[i], wanted[i], 1e-5);
    // A wobble has none, though ω along the middle axis changes its sign.
    EXPECT_TRUE(
        sampled_flips(Motion(problem_with({1.0, 2.0, 3.0}, {2.5, 0.4, 0.3})), 0.0, 40.0)->empty());
    EXPECT_TRUE(
        sampled_flips(Motion(problem_with({1.0, 1.0, 1.8}, {1.5, 0.0, 1.5})), 0.0, 9.0)->empty());
    EXPECT_FALSE(sampled_flips(Motion(problem_with({3.0, 2.0, 1.0}, {0.02, 2.0, 0.01})), 0.0, 1e9));
}

}  // namespace
}  // namespace poinsot
