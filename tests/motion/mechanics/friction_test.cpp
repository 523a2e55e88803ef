// Friction inside the body: L stays in space to rounding and T never grows, by whatever method and
// however coarse the step; and the motion is that of the equations of motion.
#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "error/error.h"
#include "mechanics/half_life.h"
#include "mechanics/methods.h"
#include "mechanics/motion.h"
#include "mechanics/stepped/integrated_rotation.h"

namespace poinsot::friction_tests {
namespace {

// A body, a start and a friction, seeded; every third spins almost about a principal axis, every
// fourth has two equal moments.
MotionProblem random_problem(int k) {
    std::mt19937 random(static_cast<unsigned>(k) + 1000U);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const auto centred = [&] { return part(random) - 0.5; };
    const double x = 0.1 + part(random), y = 0.1 + part(random), z = 0.1 + part(random);
    Eigen::Vector3d moments(y + z, z + x, x + y);
    if (k % 4 == 0) moments[1] = moments[0];
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(moments, Physicality::waived);
    Eigen::Vector3d omega(centred(), centred(), centred());
    if (k % 3 == 0) omega = Eigen::Vector3d(1.0, 1e-3 * centred(), 1e-3 * centred());
    problem.start.omega_body = omega;
    problem.start.space_from_body =
        Eigen::Quaterniond(centred(), centred(), centred(), centred()).normalized();
    problem.torque = InternalFriction{std::exp(6.0 * centred() - 3.0)};
    return problem;
}

// Radians that the body turns a second at most.
double fastest_turning(const MotionProblem& problem) {
    const Eigen::Vector3d& I = problem.inertia.moments_kg_m2();
    const RotationDynamics dynamics(problem.inertia, problem.torque);
    return I.cwiseProduct(problem.start.omega_body).norm() / I.minCoeff() +
           2.0 * dynamics.greatest_friction_turning_rad_s();
}

Eigen::Vector3d momentum_of(const MotionProblem& problem, const RotationState& state) {
    return state.space_from_body * (problem.inertia.matrix_body() * state.omega_body);
}

double energy_of(const MotionProblem& problem, const RotationState& state) {
    return 0.5 * state.omega_body.dot(problem.inertia.matrix_body() * state.omega_body);
}

std::vector<std::string> methods_with_friction() {
    std::vector<std::string> names;
    for (const Method& method : methods())
        if (method.make != nullptr &&
            can_solve(method, InertiaTensor::from_principal_moments({1.0, 1.0, 1.0}),
                      InternalFriction{1.0}))
            names.emplace_back(method.name);
    return names;
}

TEST(Friction, KeepsMomentumInSpaceAndNeverAddsEnergy) {
    EXPECT_EQ(methods_with_friction().size(), 4u);
    for (const std::string& name : methods_with_friction()) {
        for (int k = 0; k < 30; ++k) {
            MotionProblem problem = random_problem(k);
            problem.method.name = name;
            // From fine steps to a radian of turning each.
            const double turning = fastest_turning(problem);
            const double step_rad = std::array{0.03, 0.3, 1.0}[static_cast<std::size_t>(k % 3)];
            if (find_method(name).takes_step) problem.method.step_s = step_rad / turning;
            problem.last_time_s = 600.0 / turning;
            problem.first_time_s = k % 5 == 0 ? -100.0 / turning : 0.0;
            const IntegratedRotation motion(problem);
            const Eigen::Vector3d momentum = momentum_of(problem, problem.start);
            double energy = HUGE_VAL;
            for (int i = 0; i <= 1000; ++i) {
                const double share = i / 1000.0;
                const RotationState now =
                    motion.at(problem.first_time_s * (1.0 - share) + problem.last_time_s * share);
                // Measured 2.7e-15 over 480,000 instants, and 2.7e-15 for T.
                ASSERT_LE((momentum_of(problem, now) - momentum).norm(), 1e-14 * momentum.norm())
                    << name << " " << k << " at " << now.time_s;
                const double less = energy_of(problem, now);
                ASSERT_LE(less, energy * (1.0 + 1e-14)) << name << " " << k << " at " << now.time_s;
                energy = less;
            }
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Euler's equations with the double bracket, in L and the attitude, by Fehlberg's method of order
// 7(8). This method does not use that L is conserved.

using Numbers = std::array<double, 7>;

RotationState integrated_apart(const MotionProblem& problem, double time_s) {
    namespace odeint = boost::numeric::odeint;
    const Eigen::Vector3d I = problem.inertia.moments_kg_m2();
    const double kappa = std::get<InternalFriction>(problem.torque).rate_1_s * I.sum() / 3.0;
    const Eigen::Vector3d L0 = I.cwiseProduct(problem.start.omega_body);
    const Eigen::Vector4d q0 = problem.start.space_from_body.coeffs();
    Numbers numbers{L0[0], L0[1], L0[2], q0[0], q0[1], q0[2], q0[3]};
    const auto rate = [&](const Numbers& n, Numbers& dn, double) {
        const Eigen::Vector3d L(n[0], n[1], n[2]);
        const Eigen::Vector3d omega = L.cwiseQuotient(I);
        const Eigen::Vector3d turning = L.cross(omega);
        const Eigen::Vector3d momentum_rate = turning + kappa / L.squaredNorm() * L.cross(turning);
        const Eigen::Vector3d axes = omega + kappa / L.squaredNorm() * turning;
        const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
        const Eigen::Vector4d dq =
            (q * Eigen::Quaterniond(0.0, 0.5 * axes[0], 0.5 * axes[1], 0.5 * axes[2])).coeffs();
        for (std::size_t i = 0; i < 3; ++i) dn[i] = momentum_rate[static_cast<Eigen::Index>(i)];
        for (std::size_t i = 0; i < 4; ++i) dn[i + 3] = dq[static_cast<Eigen::Index>(i)];
    };
    odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_fehlberg78<Numbers>>(1e-15, 1e-14), rate,
        numbers, 0.0, time_s, 1e-3);
    RotationState state;
    state.time_s = time_s;
    state.space_from_body =
        Eigen::Quaterniond(numbers[6], numbers[3], numbers[4], numbers[5]).normalized();
    state.omega_body = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]).cwiseQuotient(I);
    return state;
}

double apart(const RotationState& a, const RotationState& b) {
    const Eigen::Quaterniond between = a.space_from_body.conjugate() * b.space_from_body;
    return 2.0 * std::atan2(between.vec().norm(), std::abs(between.w())) +
           (a.omega_body - b.omega_body).norm();
}

TEST(Friction, FollowsEulersEquations) {
    for (int k = 0; k < 12; ++k) {
        MotionProblem problem = random_problem(k);
        problem.last_time_s = 60.0 / fastest_turning(problem);
        const RotationState wanted = integrated_apart(problem, problem.last_time_s);
        problem.method = {.name = "dopri5", .step_s = {}, .tolerance = 1e-12, .order = {}};
        // Starts near the axis of the least moment leave it by e^λt, and their errors as well.
        EXPECT_LE(apart(Motion(problem).at(problem.last_time_s), wanted), 1e-9) << k;
    }
}

TEST(Friction, IsSteppedWithTheOrderOfTheMethod) {
    const MotionProblem problem = random_problem(7);
    const double last_time_s = 20.0 / fastest_turning(problem);
    const RotationState wanted = integrated_apart(problem, last_time_s);
    for (const std::string& name : methods_with_friction()) {
        const Method& method = find_method(name);
        if (!method.takes_step) continue;
        std::array<double, 2> errors{};
        for (const int halved : {0, 1}) {
            MotionProblem stepped = problem;
            stepped.last_time_s = last_time_s;
            stepped.method.name = name;
            stepped.method.step_s =
                (method.orders.back() == 1 ? 0.002 : 0.2) / (1 + halved) / fastest_turning(problem);
            errors[static_cast<std::size_t>(halved)] =
                apart(IntegratedRotation(stepped).at(last_time_s), wanted);
        }
        EXPECT_NEAR(std::log2(errors[0] / errors[1]), method.orders.back(), 0.3)
            << name << ": " << errors[0] << ", " << errors[1];
    }
}

// The excess T − L²/(2 I_max) of the integration apart.
TEST(Friction, HalvesTheEnergyThatItCanTakeAfterTheHalfLife) {
    for (int k = 1; k < 12; ++k) {
        MotionProblem problem = random_problem(k);
        const Eigen::Vector3d& I = problem.inertia.moments_kg_m2();
        const double half_life_s = 30.0 * (k % 4 + 1) / fastest_turning(problem);
        problem.torque = InternalFriction{
            friction_rate_of_half_life(problem.inertia, problem.start.omega_body, half_life_s)};
        const auto excess = [&](const Eigen::Vector3d& omega) {
            const Eigen::Vector3d L = I.cwiseProduct(omega);
            return L.dot(omega) - L.squaredNorm() / I.maxCoeff();
        };
        const Eigen::Vector3d then = integrated_apart(problem, half_life_s).omega_body;
        EXPECT_NEAR(excess(then) / excess(problem.start.omega_body), 0.5, 1e-6) << k;
    }
}

TEST(Friction, RefusesAStepThatDoesNotFollowIt) {
    MotionProblem problem = random_problem(5);
    problem.torque = InternalFriction{1e3};
    problem.last_time_s = 10.0;
    problem.method = {.name = "rk4", .step_s = 0.1, .tolerance = {}, .order = {}};
    try {
        const IntegratedRotation motion(problem);
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find("friction turns the body by"), std::string::npos) << said;
        EXPECT_NE(said.find("give a step_s of at most"), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace poinsot::friction_tests
