// The friction for a half-life, compared with the closed form of symmetric bodies and with the
// motion.
#include "mechanics/half_life.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "error/error.h"
#include "mechanics/motion.h"

namespace poinsot {
namespace {

// T − L²/(2 I_max) of a state.
double excess_J(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
    const Eigen::Vector3d L = moments.cwiseProduct(omega);
    return 0.5 * (L.dot(omega) - L.squaredNorm() / moments.maxCoeff());
}

double share_left(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, double half_life_s,
                  double time_s) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(moments);
    problem.start.omega_body = omega;
    problem.torque =
        InternalFriction{friction_rate_of_half_life(problem.inertia, omega, half_life_s)};
    problem.method = {.name = "dopri5", .step_s = {}, .tolerance = 1e-11, .order = {}};
    problem.last_time_s = time_s;
    return excess_J(moments, Motion(problem).at(time_s).omega_body) / excess_J(moments, omega);
}

// With two equal moments tan²θ = tan²θ₀ exp(∓2κ|1/I1 − 1/I3| t), θ the tilt of L from e3: the
// excess is proportional to sin²θ for an oblate body and to cos²θ for a prolate one.
TEST(HalfLife, MatchesTheClosedFormsOfSymmetricBodies) {
    for (const Eigen::Vector3d& I :
         {Eigen::Vector3d(1.0, 1.0, 1.7), Eigen::Vector3d(1.25, 1.25, 0.16)}) {
        for (const double half_life_s : {0.3, 4.0, 60.0}) {
            const Eigen::Vector3d omega(0.4, 0.1, 3.0);
            const Eigen::Vector3d L = I.cwiseProduct(omega);
            const double tan2 = L.head<2>().squaredNorm() / (L[2] * L[2]);
            const bool oblate = I[2] > I[0];
            // sin² (oblate) or cos² (prolate) is halved.
            const double share = oblate ? tan2 / (1.0 + tan2) : 1.0 / (1.0 + tan2);
            const double left = 0.5 * share;
            const double tan2_then = oblate ? left / (1.0 - left) : (1.0 - left) / left;
            const double friction = std::abs(std::log(tan2_then / tan2)) /
                                    (2.0 * std::abs(1.0 / I[0] - 1.0 / I[2]) * half_life_s);
            const double rate = friction_rate_of_half_life(InertiaTensor::from_principal_moments(I),
                                                           omega, half_life_s);
            // Measured 1e-11 at most.
            EXPECT_NEAR(rate * I.sum() / 3.0, friction, 1e-9 * friction) << I.transpose();
        }
    }
}

TEST(HalfLife, HoldsForAnyBodyAndStart) {
    const Eigen::Vector3d I(3.0, 2.0, 1.0);
    for (const Eigen::Vector3d& omega :
         {Eigen::Vector3d(0.05, 0.02, 2.0), Eigen::Vector3d(0.01, 2.0, 0.01),
          Eigen::Vector3d(1.0, 0.7, -0.4), Eigen::Vector3d(2.0, 0.1, 0.0)})
        for (const double half_life_s : {0.5, 12.0, 150.0})
            // T drifts within the tolerance of the steps. Measured 3e-8.
            EXPECT_NEAR(share_left(I, omega, half_life_s, half_life_s), 0.5, 1e-6)
                << omega.transpose() << " " << half_life_s;
}

// For long half-lives the mean over each polhode replaces stepping: κ times the half-life is
// constant.
TEST(HalfLife, OfThousandsOfTurnsUsesTheMean) {
    const auto inertia = InertiaTensor::from_principal_moments({3.0, 2.0, 1.0});
    const Eigen::Vector3d omega(0.05, 0.02, 2.0);
    const auto product = [&](double turns) {
        const double half_life_s = turns * std::numbers::pi;  // ω turns once in π seconds
        return half_life_s * friction_rate_of_half_life(inertia, omega, half_life_s);
    };
    const double stepped = product(1400.0);
    EXPECT_NEAR(product(1600.0) / stepped, 1.0, 1e-3);  // measured 4e-5
    EXPECT_NEAR(product(1e7) / stepped, 1.0, 1e-3);
}

TEST(HalfLife, ScalesWithBodyAndSpin) {
    const Eigen::Vector3d I(3.0, 2.0, 1.0);
    const Eigen::Vector3d omega(0.4, 1.0, -0.3);
    const double rate =
        friction_rate_of_half_life(InertiaTensor::from_principal_moments(I), omega, 5.0);
    // A body a thousand times as heavy, and one that spins and dissipates a hundred times as fast.
    EXPECT_NEAR(
        friction_rate_of_half_life(InertiaTensor::from_principal_moments(1e3 * I), omega, 5.0),
        rate, 1e-12 * rate);
    EXPECT_NEAR(
        friction_rate_of_half_life(InertiaTensor::from_principal_moments(I), 1e2 * omega, 0.05),
        1e2 * rate, 1e-10 * rate);
}

// ⟨|L × ω|²⟩/L² over a polhode, from samples of one period.
TEST(HalfLife, MeanDissipationIsThatOfTheMotion) {
    for (const Eigen::Vector3d& omega :
         {Eigen::Vector3d(0.3, 0.4, 2.0), Eigen::Vector3d(2.0, 0.4, 0.3)}) {
        const Eigen::Vector3d I(3.0, 2.0, 1.0);
        MotionProblem problem;
        problem.inertia = InertiaTensor::from_principal_moments(I);
        problem.start.omega_body = omega;
        const Motion motion(problem);
        const double period_s = *motion.free_rotation()->constants().polhode_period_s;
        constexpr int n = 4096;  // a periodic function's mean converges at once
        double mean = 0.0;
        for (int k = 0; k < n; ++k) {
            const Eigen::Vector3d w = motion.at(period_s * k / n).omega_body;
            const Eigen::Vector3d L = I.cwiseProduct(w);
            mean += L.cross(w).squaredNorm() / L.squaredNorm() / n;
        }
        const Eigen::Vector3d L = I.cwiseProduct(omega);
        EXPECT_NEAR(mean_burning(I, L.norm(), L.dot(omega)), mean, 1e-12);
    }
}

// Starts as close to an axis as is accepted, moments that differ in their last digits, half-lives
// from much shorter to much longer than a turn: half of the energy is lost at the half-life, which
// is found in a bounded number of steps. Compared with the closed form of symmetric bodies, in the
// tangent of the tilt; a body that starts near the axis of the least moment turns over.
TEST(HalfLife, HoldsNearTheAxesAndForAlmostEqualMoments) {
    struct Case {
        Eigen::Vector3d moments;
        Eigen::Vector3d omega;
        int axis;
    };
    const std::array cases{Case{{2.0, 2.0, 1.0}, {1e-9, 3.0, 1e-9}, 2},
                           Case{{2.0, 2.0, 1.0}, {3e-9, 1e-10, 3.0}, 2},
                           Case{{1.0, 1.0, 1.7}, {1.0, 1e-9, 1e-9}, 2},
                           Case{{1.0, 1.0, 1.0 + 1e-9}, {1.0, 0.5, 0.3}, 2},
                           Case{{1.0, 1.0, 1e-6}, {1e-3, 0.0, 1.0}, 2}};
    for (const Case& c : cases) {
        const Eigen::Vector3d L = c.moments.cwiseProduct(c.omega);
        // Squares of the tangents of L's tilt from the axis, at the start and at the half-life.
        const double across = L.head<2>().squaredNorm();
        const double along = L[2] * L[2];
        const bool oblate = c.moments[2] > c.moments[0];
        const double ratio =
            oblate ? (across + along) / along + 1.0 : (across + along) / across + 1.0;
        for (const double half_life_s : {1e-200, 1e-3, 1.0, 1e3, 1e7, 1e200}) {
            const double friction =
                std::log(ratio) /
                (2.0 * std::abs(c.moments[2] - c.moments[0]) / (c.moments[0] * c.moments[2])) /
                half_life_s;
            const double rate = friction_rate_of_half_life(
                InertiaTensor::from_principal_moments(c.moments, Physicality::waived), c.omega,
                half_life_s);
            EXPECT_NEAR(rate * c.moments.sum() / 3.0 / friction, 1.0, 1e-7)
                << c.moments.transpose() << " " << c.omega.transpose() << " " << half_life_s;
        }
    }
}

TEST(HalfLife, IsRefusedWhereNoDoubleIsTheFriction) {
    const auto inertia = InertiaTensor::from_principal_moments({3.0, 2.0, 1.0});
    for (const double half_life_s : {5e-324, 1e-309, 1.7e308})
        for (const double spin : {1e-300, 1.0, 1e300}) {
            try {
                const double rate = friction_rate_of_half_life(
                    inertia, spin * Eigen::Vector3d(0.4, 1.0, -0.3), half_life_s);
                EXPECT_TRUE(std::isnormal(rate)) << half_life_s << " " << spin;
            } catch (const InputError& error) {
                EXPECT_NE(std::string(error.what()).find("give a half-life"), std::string::npos)
                    << error.what();
            }
        }
}

TEST(HalfLife, IsRefusedOnAPrincipalAxis) {
    const auto inertia = InertiaTensor::from_principal_moments({3.0, 2.0, 1.0});
    for (const Eigen::Vector3d& omega :
         {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(1.0, 0.0, 0.0),
          Eigen::Vector3d(0.0, -2.0, 0.0), Eigen::Vector3d(0.0, 0.0, 3.0)})
        EXPECT_THROW(friction_rate_of_half_life(inertia, omega, 1.0), InputError);
    // In the plane of two equal moments ω is constant, too.
    const auto disc = InertiaTensor::from_principal_moments({1.0, 1.0, 2.0});
    EXPECT_THROW(friction_rate_of_half_life(disc, {0.3, 0.4, 0.0}, 1.0), InputError);
    EXPECT_THROW(friction_rate_of_half_life(InertiaTensor::from_principal_moments({2.0, 2.0, 2.0}),
                                            {0.1, 0.2, 0.3}, 1.0),
                 InputError);
}

}  // namespace
}  // namespace poinsot
