// The drag of the air: closed forms, balances of T and L, another integrator, and what is refused.
#include "mechanics/torque.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "error/error.h"
#include "mechanics/methods.h"
#include "mechanics/motion.h"
#include "mechanics/motion_errors.h"

namespace poinsot::torque_tests {
namespace {

using Eigen::Vector3d;

MotionProblem slowed(const Vector3d& moments, const Vector3d& omega, const Drag& drag,
                     const std::string& method = "dopri5", double last_time_s = 10.0) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(moments, Physicality::waived);
    problem.start.omega_body = omega;
    problem.torque = drag;
    problem.method.name = method;
    if (method == "dopri5")
        problem.method.tolerance = 1e-12;
    else
        problem.method.step_s = 1e-3;
    problem.last_time_s = last_time_s;
    return problem;
}

const std::vector<std::string> precise_methods{"rk4", "dopri5", "rkmk4"};

TEST(Drag, SlowsASphereExponentiallyAxisByAxis) {
    const Vector3d omega(1.0, -2.0, 3.0), a(0.3, 0.05, 1.0);
    for (const std::string& method : precise_methods)
        for (const double growth : {0.0, 0.4, -0.7}) {
            const Motion motion(slowed({2.0, 2.0, 2.0}, omega, {a, {0, 0, 0}, growth}, method));
            for (const double t : {0.3, 2.0, 7.1, 10.0}) {
                const double grown = growth == 0.0 ? t : std::expm1(growth * t) / growth;
                const Vector3d exact = omega.cwiseProduct((-grown * a).array().exp().matrix());
                EXPECT_LT((motion.at(t).omega_body - exact).norm(), 1e-9 * exact.norm())
                    << method << growth << t;
            }
        }
}

TEST(Drag, SlowsASphereHyperbolicallyAxisByAxis) {
    const Vector3d omega(1.0, -2.0, 3.0), b(0.3, 0.05, 1.0);
    for (const std::string& method : precise_methods) {
        const Motion motion(slowed({2.0, 2.0, 2.0}, omega, {{0, 0, 0}, b}, method));
        for (const double t : {0.3, 2.0, 7.1, 10.0})
            for (int i = 0; i < 3; ++i) {
                const double exact = omega[i] / (1.0 + b[i] * std::abs(omega[i]) * t);
                EXPECT_NEAR(motion.at(t).omega_body[i] / exact, 1.0, 1e-9) << method << t << i;
            }
    }
}

// About one principal axis any body turns by (1 − e^(−at))/a, or ln(1 + bωt)/b.
TEST(Drag, OfAPermanentRotationTurnsTheBodyByItsClosedForm) {
    const double a = 0.2, b = 0.1, rate = 2.0;
    for (const std::string& method : precise_methods)
        for (int axis = 0; axis < 3; ++axis)
            for (const bool is_linear : {true, false}) {
                Drag drag;
                (is_linear ? drag.linear_1_s : drag.quadratic_1_rad)[axis] = is_linear ? a : b;
                const Motion motion(
                    slowed({3.0, 2.0, 1.5}, rate * Vector3d::Unit(axis), drag, method));
                for (const double t : {0.5, 4.0, 10.0}) {
                    const double angle =
                        is_linear ? -rate * std::expm1(-a * t) / a : std::log1p(b * rate * t) / b;
                    const Eigen::Quaterniond exact(Eigen::AngleAxisd(angle, Vector3d::Unit(axis)));
                    EXPECT_LT(angle_between(motion.at(t).space_from_body, exact), 1e-9)
                        << method << axis << is_linear << t;
                }
            }
}

// Equal linear rates keep the polhode: the motion is the free one, in the time (1 − e^(−at))/a.
TEST(Drag, WithEqualRatesIsTheFreeMotionInSlowerTime) {
    const double a = 0.15;
    MotionProblem problem = slowed({3.0, 2.0, 1.5}, {0.4, 1.7, 0.6},
                                   {Vector3d::Constant(a), {0, 0, 0}}, "dopri5", 20.0);
    const Motion motion(problem);
    problem.torque = NoTorque{};
    problem.method = {};
    const Motion free(problem);
    for (const double t : {0.1, 3.0, 11.0, 20.0}) {
        const RotationState state = motion.at(t), exact = free.at(-std::expm1(-a * t) / a);
        EXPECT_LT(angle_between(state.space_from_body, exact.space_from_body), 1e-9) << t;
        EXPECT_LT((state.omega_body - std::exp(-a * t) * exact.omega_body).norm(), 1e-10) << t;
    }
}

Drag any_drag(std::mt19937& random) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    Drag drag;
    for (int i = 0; i < 3; ++i) drag.linear_1_s[i] = 0.3 * part(random);
    for (int i = 0; i < 3; ++i) drag.quadratic_1_rad[i] = 0.2 * part(random);
    drag.growth_1_s = 0.4 * (part(random) - 0.5);
    return drag;
}

MotionProblem any_problem(unsigned seed, const std::string& method = "dopri5") {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    Vector3d sides, omega;
    for (double& side : sides) side = 0.1 + part(random);
    for (double& w : omega) w = 4.0 * (part(random) - 0.5);
    const Drag drag = any_drag(random);
    return slowed(Vector3d::Constant(sides.sum()) - sides, omega, drag, method, 8.0);
}

// Torque in body axes by the formula of the scene reference.
Vector3d torque_of(const MotionProblem& problem, const RotationState& state) {
    const auto& drag = std::get<Drag>(problem.torque);
    Vector3d torque;
    for (int i = 0; i < 3; ++i)
        torque[i] =
            -(drag.linear_1_s[i] + drag.quadratic_1_rad[i] * std::abs(state.omega_body[i])) *
            std::exp(drag.growth_1_s * state.time_s) * problem.inertia.moments_kg_m2()[i] *
            state.omega_body[i];
    return torque;
}

// What the torque takes of T, ∫ ω·N dt, and of L in space, ∫ q N dt, by Simpson's rule, is what T
// and L lose.
TEST(Drag, TakesOfEnergyAndMomentumWhatItsTorqueDoes) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const MotionProblem problem = any_problem(seed);
        const Motion motion(problem);
        const Vector3d& moments = problem.inertia.moments_kg_m2();
        const auto momentum = [&](const RotationState& state) -> Vector3d {
            return state.space_from_body * moments.cwiseProduct(state.omega_body);
        };
        const auto energy = [&](const RotationState& state) {
            return 0.5 * moments.dot(state.omega_body.cwiseAbs2());
        };
        constexpr int n = 4000;
        double work = 0.0;
        Vector3d impulse = Vector3d::Zero();
        for (int k = 0; k <= n; ++k) {
            const RotationState state = motion.at(8.0 * k / n);
            const double weight = (k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * 8.0 / n / 3.0;
            const Vector3d torque = torque_of(problem, state);
            work += weight * torque.dot(state.omega_body);
            impulse += weight * (state.space_from_body * torque);
        }
        const RotationState first = motion.at(0.0), last = motion.at(8.0);
        EXPECT_NEAR(energy(last) - energy(first), work, 1e-8 * energy(first)) << seed;
        EXPECT_LT((momentum(last) - momentum(first) - impulse).norm(),
                  1e-8 * momentum(first).norm())
            << seed;
        EXPECT_LT(work, 0.0);
    }
}

// Euler's equations for ω and dR/dt = R [ω]×, by a method of order 8 in long double: other
// variables and another method than ours.
RotationState by_another_method(const MotionProblem& problem, double time_s) {
    using Numbers = std::array<long double, 12>;
    namespace odeint = boost::numeric::odeint;
    const auto& drag = std::get<Drag>(problem.torque);
    const Vector3d& I = problem.inertia.moments_kg_m2();
    const auto slope = [&](const Numbers& x, Numbers& rate, long double t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            const auto at = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
            const long double braking =
                (drag.linear_1_s[at(i)] + drag.quadratic_1_rad[at(i)] * std::abs(x[i])) *
                std::exp(drag.growth_1_s * t);
            rate[i] = (static_cast<long double>(I[at(j)]) - I[at(k)]) / I[at(i)] * x[j] * x[k] -
                      braking * x[i];
            for (std::size_t row = 0; row < 3; ++row)
                rate[3 + 3 * row + i] = x[3 + 3 * row + j] * x[k] - x[3 + 3 * row + k] * x[j];
        }
    };
    Numbers x{problem.start.omega_body[0],
              problem.start.omega_body[1],
              problem.start.omega_body[2],
              1,
              0,
              0,
              0,
              1,
              0,
              0,
              0,
              1};
    odeint::integrate_adaptive(
        odeint::make_controlled(1e-18L, 1e-18L,
                                odeint::runge_kutta_fehlberg78<Numbers, long double>()),
        slope, x, 0.0L, static_cast<long double>(time_s), 1e-3L);
    RotationState state{time_s, Eigen::Quaterniond::Identity(), Vector3d::Zero()};
    Eigen::Matrix3d turn;
    for (int row = 0; row < 3; ++row) {
        state.omega_body[row] = static_cast<double>(x[static_cast<std::size_t>(row)]);
        for (int column = 0; column < 3; ++column)
            turn(row, column) =
                static_cast<double>(x[static_cast<std::size_t>(3 + 3 * row + column)]);
    }
    state.space_from_body = Eigen::Quaterniond(turn).normalized();
    return state;
}

TEST(Drag, FollowsEulersEquations) {
    for (unsigned seed = 21; seed <= 32; ++seed)
        for (const std::string& method : precise_methods) {
            const MotionProblem problem = any_problem(seed, method);
            const Motion motion(problem);
            for (const double t : {1.0, 4.7, 8.0}) {
                const RotationState exact = by_another_method(problem, t), state = motion.at(t);
                EXPECT_LT(angle_between(state.space_from_body, exact.space_from_body), 1e-9)
                    << method << seed << t;
                EXPECT_LT((state.omega_body - exact.omega_body).norm(), 1e-9) << method << seed;
            }
        }
}

// Half the step divides the error by 2 to the order: about, since other terms remain.
TEST(Drag, IsSteppedWithTheOrderOfTheMethod) {
    for (const auto& [method, order] :
         {std::pair{"euler", 1.0}, std::pair{"rk4", 4.0}, std::pair{"rkmk4", 4.0}}) {
        MotionProblem problem = any_problem(41, method);
        const RotationState exact = by_another_method(problem, 8.0);
        std::array<double, 2> errors{};
        for (const int k : {0, 1}) {
            problem.method.step_s = (order == 1.0 ? 0.002 : 0.04) / (1 + k);
            const RotationState state = Motion(problem).at(8.0);
            errors[static_cast<std::size_t>(k)] =
                angle_between(state.space_from_body, exact.space_from_body);
        }
        EXPECT_NEAR(std::log2(errors[0] / errors[1]), order, 0.25) << method;
    }
}

// A long decay keeps its digits: what is left of ω is right relative to itself.
TEST(Drag, KeepsTheDigitsOfASlowBody) {
    MotionProblem problem =
        slowed({2.0, 2.0, 2.0}, {1.0, 0.5, 2.0}, {{1.0, 1.0, 1.01}, {0, 0, 0}}, "dopri5", 200.0);
    problem.method.tolerance = 1e-10;
    const RotationState state = Motion(problem).at(200.0);
    EXPECT_NEAR(state.omega_body[0] / std::exp(-200.0), 1.0, 1e-6);
    EXPECT_NEAR(state.omega_body[2] / (2.0 * std::exp(-202.0)), 1.0, 1e-6);
}

// No unit is special: a body a thousand times as heavy moves alike, and one that turns and is
// slowed a thousand times as fast does in a thousandth of the time; at the ends of the range, too.
TEST(Drag, DoesNotDependOnUnits) {
    const Drag drag{{0.2, 0.1, 0.3}, {0.05, 0.2, 0.1}, 0.1};
    const Vector3d moments(3.0, 2.0, 1.5), omega(0.4, 1.7, 0.6);
    const RotationState plain = Motion(slowed(moments, omega, drag)).at(10.0);
    for (const int power : {10, -300, 300}) {
        const double unit = std::ldexp(1.0, power);
        const RotationState heavy = Motion(slowed(unit * moments, omega, drag)).at(10.0);
        EXPECT_EQ(heavy.omega_body, plain.omega_body) << power;
        const Drag quick{unit * drag.linear_1_s, drag.quadratic_1_rad, unit * drag.growth_1_s};
        MotionProblem problem = slowed(moments, unit * omega, quick, "dopri5", 10.0 / unit);
        const RotationState state = Motion(problem).at(10.0 / unit);
        EXPECT_LT((state.omega_body / unit - plain.omega_body).norm(), 1e-9) << power;
        EXPECT_LT(angle_between(state.space_from_body, plain.space_from_body), 1e-9) << power;
    }
}

std::string refusal(const MotionProblem& problem) {
    try {
        const Motion motion(problem);
    } catch (const InputError& error) {
        return error.what();
    }
    return "not refused";
}

void expect_said(const std::string& said, const char* part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
}

TEST(Drag, RefusesWhatItCannotFollow) {
    const Vector3d moments(3.0, 2.0, 1.5), omega(0.4, 1.7, 0.6);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    expect_said(refusal(slowed(moments, omega, {{0.1, -0.2, 0.1}})), "give rates ≥ 0");
    expect_said(refusal(slowed(moments, omega, {{0, 0, 0}, {0.1, 0.2, -0.1}})), "give rates ≥ 0");
    expect_said(refusal(slowed(moments, omega, {{0.1, infinity, 0.1}})), "must be finite");
    expect_said(refusal(slowed(moments, omega, {{0.1, 0.1, 0.1}, {0, 0, 0}, infinity})),
                "must be finite");
    expect_said(refusal(slowed(moments, omega, {{0.1, 0.1, 0.1}, {0, 0, 0}, 1e3})),
                "leave the range of double-precision numbers");
    expect_said(refusal(slowed(moments, omega, {{1e4, 0.1, 0.1}}, "rk4")),
                "give a step_s of at most");
    for (const char* method : {"midpoint", "splitting", "dmv"})
        expect_said(refusal(slowed(moments, omega, {{0.1, 0.1, 0.1}}, method)),
                    "choose one of euler, rk4, dopri5, rkmk4");
    MotionProblem exact = slowed(moments, omega, {{0.1, 0.1, 0.1}});
    exact.method = {};
    expect_said(refusal(exact), "has no solution for the torque \"drag of the air\"");
}

}  // namespace
}  // namespace poinsot::torque_tests
