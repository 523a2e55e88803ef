// Montgomery's phase: the turn of the body about L after one polhode period, which the attitude
// shows, is 2TP/L less the solid angle, which only ω enters.
#include "construction/montgomery_phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mechanics/free/free_rotation.h"

namespace poinsot {
namespace {

constexpr double pi = std::numbers::pi;

MotionProblem problem_of_phase(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(moments, Physicality::waived);
    problem.start.omega_body = omega;
    return problem;
}

// The angle about L between the attitudes at the start and a period later, in [−π, π].
double turned_about_momentum(const MotionProblem& problem, double period_s) {
    const FreeRotation motion(problem.inertia, problem.start, problem.on_separatrix);
    const double from_s = problem.start.time_s;
    const Eigen::Quaterniond turn = motion.at(from_s + period_s).space_from_body *
                                    motion.at(from_s).space_from_body.conjugate();
    const Eigen::Vector3d along = motion.constants().momentum_space.stableNormalized();
    EXPECT_LT(turn.vec().cross(along).norm(), 1e-12 * (1.0 + period_s)) << "L is not the axis";
    return std::remainder(2.0 * std::atan2(turn.vec().dot(along), turn.w()), 2.0 * pi);
}

double off_by(double angle, double other) {
    return std::abs(std::remainder(angle - other, 2 * pi));
}

// A real body with an attitude and axes of its own, and any ω.
MotionProblem random_problem(std::mt19937_64& random) {
    std::uniform_real_distribution<double> share(0.02, 1.0);
    std::normal_distribution<double> normal;
    const auto vector = [&] {
        return Eigen::Vector3d(normal(random), normal(random), normal(random));
    };
    const auto attitude = [&] {
        return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized();
    };
    const Eigen::Vector3d squares(share(random), share(random), share(random));
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_axes(
        Eigen::Vector3d(squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]),
        attitude().toRotationMatrix());
    problem.start.omega_body = vector();
    problem.start.space_from_body = attitude();
    return problem;
}

// The claim: for 10,000 bodies the identity holds to 1e-13, relative to the turn where it is longer
// than a radian. Measured: 9e-16.
TEST(MontgomeryPhase, IsTheDynamicPartLessTheSolidAngle) {
    std::mt19937_64 random(38);
    for (int k = 0; k < 10000; ++k) {
        const MotionProblem problem = random_problem(random);
        const auto phase = montgomery_phase(problem);
        ASSERT_TRUE(phase);
        const double scale = 1.0 + phase->dynamic_rad;
        EXPECT_NEAR(phase->turned_rad, phase->dynamic_rad - phase->solid_angle_rad, 1e-13 * scale);
        EXPECT_LT(off_by(turned_about_momentum(problem, phase->period_s),
                         phase->dynamic_rad - phase->solid_angle_rad),
                  1e-13 * scale)
            << k;
        EXPECT_LT(std::abs(phase->solid_angle_rad), 2.0 * pi);
    }
}

// The area of the triangles between the axis and the path of L, whose sum is within 1e-5 of the
// area for 2000 of them.
TEST(MontgomeryPhase, HasTheAreaOfTheEnclosedPart) {
    for (const Eigen::Vector3d& omega :
         {Eigen::Vector3d(1.4, 0.5, 1.6), Eigen::Vector3d(1.4, 0.5, -0.3),
          Eigen::Vector3d(0.2, -1.9, 0.3), Eigen::Vector3d(-2.0, 0.5, 0.1)}) {
        const MotionProblem problem = problem_of_phase({1.0, 2.0, 2.9}, omega);
        const auto phase = montgomery_phase(problem);
        ASSERT_TRUE(phase);
        const FreeRotation motion(problem.inertia, problem.start);
        const int a = motion.constants().encircled_axis;
        const Eigen::Vector3d axis = std::copysign(1.0, omega[a]) * Eigen::Vector3d::Unit(a);
        const auto direction = [&](double t) {
            return (problem.inertia.matrix_body() * motion.at(t).omega_body).normalized().eval();
        };
        double area = 0.0;
        constexpr int n = 2000;
        for (int k = 0; k < n; ++k) {
            const Eigen::Vector3d from = direction(phase->period_s * k / n);
            const Eigen::Vector3d to = direction(phase->period_s * (k + 1) / n);
            // A spherical triangle: Van Oosterom & Strackee (1983).
            area += 2.0 * std::atan2(axis.dot(from.cross(to)),
                                     1.0 + axis.dot(from) + from.dot(to) + to.dot(axis));
        }
        EXPECT_NEAR(phase->solid_angle_rad, area, 1e-5) << omega.transpose();
    }
}

// ω of a symmetric body moves on a circle: the solid angle is a cap of 2π(1 − cos), the period
// 2π/Ω.
TEST(MontgomeryPhase, OfASymmetricBodyIsACap) {
    for (const double I3 : {1.2, 3.0}) {
        const MotionProblem problem = problem_of_phase({2.0, 2.0, I3}, {0.4, 0.3, 1.0});
        const auto phase = montgomery_phase(problem);
        ASSERT_TRUE(phase);
        const double cosine = I3 / std::hypot(2.0 * 0.5, I3);
        EXPECT_NEAR(phase->period_s, 2.0 * pi / std::abs((I3 - 2.0) / 2.0), 1e-14);
        EXPECT_NEAR(phase->solid_angle_rad, std::copysign(2.0 * pi * (1.0 - cosine), I3 - 2.0),
                    1e-14);
    }
}

// Beside the separatrix the path of L is nearly two half great circles through the middle axis: the
// solid angle is that of a lune, twice the angle between their planes.
TEST(MontgomeryPhase, BesideTheSeparatrixIsALune) {
    const Eigen::Vector3d moments(1.0, 2.0, 2.25);
    for (const double nudge : {1e-3, 1e-8, 1e-150}) {
        // L at the middle axis, but for a nudge towards the axis of the largest moment.
        const MotionProblem problem = problem_of_phase(moments, {0.0, 1.0, nudge});
        const auto phase = montgomery_phase(problem);
        ASSERT_TRUE(phase);
        // On the separatrix (L₁/L₃)² = (1/I₂ − 1/I₃)/(1/I₁ − 1/I₂); from e₃ that is the tangent of
        // half the lune's angle.
        const double half_rad = std::atan(std::sqrt((1.0 / 2.0 - 1.0 / 2.25) / (1.0 - 1.0 / 2.0)));
        EXPECT_NEAR(phase->solid_angle_rad, 4.0 * half_rad, 4.0 * nudge + 1e-13) << nudge;
        const double scale = 1.0 + phase->dynamic_rad;
        EXPECT_NEAR(phase->turned_rad, phase->dynamic_rad - phase->solid_angle_rad, 1e-14 * scale);
    }
}

TEST(MontgomeryPhase, HasNoUnits) {
    const auto phase = montgomery_phase(problem_of_phase({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}));
    ASSERT_TRUE(phase);
    for (const double by : {0x1p500, 0x1p-500}) {
        const auto other = montgomery_phase(
            problem_of_phase(by * Eigen::Vector3d(1.0, 2.0, 2.9), {1.4, 0.5, 1.6}));
        ASSERT_TRUE(other);
        EXPECT_DOUBLE_EQ(other->dynamic_rad, phase->dynamic_rad);
        EXPECT_DOUBLE_EQ(other->solid_angle_rad, phase->solid_angle_rad);
    }
}

TEST(MontgomeryPhase, NeedsAPeriodAndNoTorque) {
    EXPECT_FALSE(montgomery_phase(problem_of_phase({1.0, 2.0, 2.25}, {0.0, 0.0, 1.0})));
    EXPECT_FALSE(
        montgomery_phase(problem_of_phase({1.0, 2.0, 2.25}, {1.5, 1.0, 2.0})));  // separatrix
    MotionProblem problem = problem_of_phase({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6});
    problem.torque = InternalFriction{0.1};
    EXPECT_FALSE(montgomery_phase(problem));
}

}  // namespace
}  // namespace poinsot
