// The stepping methods: measured orders, conserved quantities, torques, time spans and refused
// input.
#include "mechanics/methods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "error/error.h"
#include "mechanics/motion.h"
#include "mechanics/stepped/integrated_rotation.h"
#include "mechanics/stepped/moser_veselov_series.h"
#include "mechanics/top/heavy_top.h"

namespace poinsot::methods_tests {
namespace {

constexpr double pi = std::numbers::pi;

MethodChoice stepping(const std::string& name, double step_s) {
    MethodChoice choice;
    choice.name = name;
    choice.step_s = step_s;
    return choice;
}

MotionProblem tumbling(const std::string& method, double last_time_s) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments({3.0, 1.5, 2.2});
    problem.start.omega_body = {0.4, 0.9, -1.1};
    problem.start.space_from_body = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.2).normalized();
    problem.method.name = method;
    problem.last_time_s = last_time_s;
    return problem;
}

double attitude_error(const RotationState& a, const RotationState& b) {
    const Eigen::Vector4d p = a.space_from_body.coeffs();
    const Eigen::Vector4d q = b.space_from_body.coeffs();
    return 2.0 * std::min((p - q).norm(), (p + q).norm());
}

// Error of a method at the end of the span, in attitude and ω, against the exact motion.
double error_at_end(MotionProblem problem) {
    const IntegratedRotation stepped(problem);
    MotionProblem exact = problem;
    exact.method = {};
    const RotationState wanted = Motion(exact).at(problem.last_time_s);
    const RotationState got = stepped.at(problem.last_time_s);
    return std::max(attitude_error(got, wanted), (got.omega_body - wanted.omega_body).norm());
}

double kinetic_energy(const InertiaTensor& inertia, const RotationState& state) {
    return 0.5 * state.omega_body.dot(inertia.matrix_body() * state.omega_body);
}

Eigen::Vector3d momentum_space(const InertiaTensor& inertia, const RotationState& state) {
    return state.space_from_body * (inertia.matrix_body() * state.omega_body);
}

// The largest relative drift of T and of L in space over the steps of a span.
struct Drift {
    double energy = 0.0;
    double momentum = 0.0;
};

Drift drift_of(const MotionProblem& problem) {
    const IntegratedRotation stepped(problem);
    const double energy = kinetic_energy(problem.inertia, problem.start);
    const Eigen::Vector3d momentum = momentum_space(problem.inertia, problem.start);
    Drift drift;
    for (int k = 1; k <= 200; ++k) {
        const RotationState now = stepped.at(problem.last_time_s * k / 200.0);
        drift.energy =
            std::max(drift.energy, std::abs(kinetic_energy(problem.inertia, now) / energy - 1.0));
        drift.momentum =
            std::max(drift.momentum,
                     (momentum_space(problem.inertia, now) - momentum).norm() / momentum.norm());
    }
    return drift;
}

// ---------------------------------------------------------------------------------------------

TEST(Methods, HaveUniqueNamesSourcesAndOrders) {
    std::set<std::string_view> names;
    for (const Method& method : methods()) {
        names.insert(method.name);
        EXPECT_FALSE(method.summary.empty()) << method.name;
        EXPECT_FALSE(method.source.empty()) << method.name;
        EXPECT_FALSE(method.conserves.empty()) << method.name;
        EXPECT_EQ(method.orders.empty(), method.make == nullptr) << method.name;
        EXPECT_EQ(method.takes_step != method.takes_tolerance, method.make != nullptr)
            << method.name;
    }
    const std::set<std::string_view> wanted{"exact",    "euler",     "rk4", "dopri5",
                                            "midpoint", "splitting", "dmv", "rkmk4"};
    EXPECT_EQ(names, wanted);
}

TEST(Methods, ConvergeWithTheirOrder) {
    // Halving the step divides the error by 2^order; for each first step the errors lie between
    // rounding and saturation.
    const std::map<std::string, double> first_step{
        {"euler", 1e-3}, {"rk4", 0.05}, {"midpoint", 0.02}, {"splitting", 0.02}, {"rkmk4", 0.05},
        {"dmv2", 0.05},  {"dmv4", 0.1}, {"dmv6", 0.2},      {"dmv8", 0.4},       {"dmv10", 0.5}};
    for (const Method& method : methods()) {
        if (!method.takes_step) continue;
        for (const int order : method.orders) {
            const std::string key =
                std::string(method.name) + (method.orders.size() > 1 ? std::to_string(order) : "");
            MotionProblem problem = tumbling(std::string(method.name), 8.0);
            problem.method.order = order;
            problem.method.step_s = first_step.at(key);
            const double coarse = error_at_end(problem);
            problem.method.step_s = *problem.method.step_s / 2.0;
            const double fine = error_at_end(problem);
            const double measured = std::log2(coarse / fine);
            // Measured 1.000, 4.003, 2.000, 2.000; dmv 2.003, 4.011, 6.041, 8.130, 10.19; 4.109.
            EXPECT_NEAR(measured, order, 0.3) << key << ": " << coarse << ", " << fine;
        }
    }
}

TEST(Methods, Dopri5FollowsItsTolerance) {
    double last = 1.0;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, least_tolerance}) {
        MotionProblem problem = tumbling("dopri5", 20.0);
        problem.method.tolerance = tolerance;
        const double error = error_at_end(problem);
        // Measured 12 times the tolerance at 1e-4, less below, and 1.2e-13 at the smallest.
        EXPECT_LE(error, 40.0 * tolerance + 5e-13) << tolerance;
        EXPECT_LT(error, last);
        last = error;
    }
}

TEST(Methods, ConserveTheQuantitiesOfTheirRow) {
    // 100 periods of some 6.6 s; midpoint, dmv: T and L; splitting, rkmk4: L.
    const auto drift = [](const std::string& method, double step_s, double last_time_s) {
        MotionProblem problem = tumbling(method, last_time_s);
        problem.method.step_s = step_s;
        return drift_of(problem);
    };
    for (const std::string method : {"midpoint", "dmv", "splitting", "rkmk4"}) {
        const Drift d = drift(method, 0.05, 660.0);
        EXPECT_LE(d.momentum, 1e-14) << method;  // measured 1.6e-15
        const bool keeps_energy = method == "midpoint" || method == "dmv";
        // Measured 1.9e-14, after 13,200 steps; splitting 3.4e-4, rkmk4 2.3e-7.
        EXPECT_LE(d.energy, keeps_energy ? 1e-13 : 1e-3) << method;
    }
    // The splitting's energy error is bounded: it is not larger after ten times the time.
    const double early = drift("splitting", 0.05, 660.0).energy;
    const double late = drift("splitting", 0.05, 6600.0).energy;
    EXPECT_LE(late, 1.1 * early);
    EXPECT_GE(early, 1e-6);
    // The Runge–Kutta methods drift in proportion to the time, and Euler's grows.
    const double rk4_ratio = drift("rk4", 0.1, 660.0).energy / drift("rk4", 0.1, 66.0).energy;
    const double rkmk_ratio = drift("rkmk4", 0.1, 660.0).energy / drift("rkmk4", 0.1, 66.0).energy;
    EXPECT_NEAR(rk4_ratio, 10.0, 2.0);
    EXPECT_NEAR(rkmk_ratio, 10.0, 2.0);
    MotionProblem euler = tumbling("euler", 20.0);
    euler.method.step_s = 0.01;
    const IntegratedRotation growing(euler);
    double energy = kinetic_energy(euler.inertia, euler.start);
    for (int second = 1; second <= 20; ++second) {
        const double now = kinetic_energy(euler.inertia, growing.at(second));
        EXPECT_GT(now, energy);
        energy = now;
    }
}

TEST(Methods, PreprocessAsPrintedByHairerAndVilmart) {
    // s3 and d3 of the paper's theorem, in T and C = L²/2.
    for (const Eigen::Vector3d& moments :
         {Eigen::Vector3d(1.0, 2.0, 2.5), Eigen::Vector3d(2.5, 1.0, 2.0),
          Eigen::Vector3d(2.0, 2.0, 2.0), Eigen::Vector3d(1.0, 1.0, 1.5)}) {
        const Eigen::Vector3d momentum(0.3, -1.2, 0.7);
        const double T = 0.5 * momentum.dot(momentum.cwiseQuotient(moments));
        const double C = 0.5 * momentum.squaredNorm();
        const double product = moments.prod();
        const double s3 =
            -moments.cwiseInverse().sum() * T / 3.0 + moments.sum() * C / (6.0 * product);
        const double d3 = moments.sum() * T / (6.0 * product) - C / (3.0 * product);
        const MoserVeselovSeries series = moser_veselov_series(moments, momentum);
        EXPECT_NEAR(series.s[0] / s3, 1.0, 1e-13);  // measured 4e-15
        EXPECT_NEAR(series.d[0] / d3, 1.0, 1e-13);
    }
    const MoserVeselovSeries rest = moser_veselov_series({1.0, 2.0, 2.5}, Eigen::Vector3d::Zero());
    EXPECT_EQ(rest.s[0], 0.0);
}

TEST(Methods, FollowTheHeavyTopWithTheirOrder) {
    const HeavyTopProblem top{.moment_axial_kg_m2 = 0.5,
                              .mgl_N_m = 1.0,
                              .theta_rad = 0.7,
                              .phi_dot_rad_s = 0.35,
                              .omega3_rad_s = 4.0};
    const std::map<std::string_view, double> first_step{
        {"euler", 2e-4}, {"rk4", 0.02}, {"splitting", 0.02}, {"rkmk4", 0.02}};
    const Gravity gravity{.mgl_N_m = top.mgl_N_m};
    for (const auto& [name, step] : first_step) {
        double error[2];
        for (int i = 0; i < 2; ++i) {
            MotionProblem problem;
            problem.inertia = InertiaTensor::from_principal_moments({1.0, 1.0, 0.5});
            problem.start = start_of(top);
            problem.torque = gravity;
            problem.method = stepping(std::string(name), step / (i + 1));
            problem.last_time_s = 3.0;
            error[i] = error_at_end(problem);
        }
        const double order = find_method(name).orders.back();
        // Measured 1.000, 3.998, 2.000, 3.992.
        EXPECT_NEAR(std::log2(error[0] / error[1]), order, 0.1) << name;
    }
}

TEST(Methods, KeepTheEnergyOfAnAsymmetricTop) {
    // Not integrable, but E and the vertical component of L are conserved.
    for (const Method& method : methods()) {
        MotionProblem problem = tumbling(std::string(method.name), 200.0);
        problem.torque =
            Gravity{.mgl_N_m = 2.0, .arm_body = Eigen::Vector3d(1.0, 2.0, -0.5).normalized()};
        if (!can_solve(method, problem.inertia, problem.torque)) continue;
        if (method.name == "euler") continue;
        if (method.takes_step) problem.method.step_s = method.name == "splitting" ? 0.01 : 0.005;
        if (method.takes_tolerance) problem.method.tolerance = 1e-11;
        const IntegratedRotation stepped(problem);
        const RotationDynamics dynamics(problem.inertia, problem.torque);
        const auto state_of = [&](const RotationState& s) {
            return StepState{s.omega_body.cwiseProduct(problem.inertia.moments_kg_m2()),
                             s.space_from_body};
        };
        const double energy = dynamics.energy_J(state_of(problem.start));
        const double vertical = momentum_space(problem.inertia, problem.start).z();
        double energy_drift = 0.0;
        double vertical_drift = 0.0;
        for (int k = 1; k <= 200; ++k) {
            const RotationState now = stepped.at(k);
            energy_drift =
                std::max(energy_drift, std::abs(dynamics.energy_J(state_of(now)) - energy));
            vertical_drift = std::max(
                vertical_drift, std::abs(momentum_space(problem.inertia, now).z() - vertical));
        }
        // The energy error of the splitting oscillates with the square of its step and does not
        // drift. Measured 1.4e-4 for the splitting, at most 1.4e-9 for the others; L_z 1e-13 and
        // 7e-10.
        const double bound = method.name == "splitting" ? 5e-4 : 1e-8;
        EXPECT_LE(energy_drift, bound) << method.name;
        EXPECT_LE(vertical_drift, method.name == "splitting" ? 1e-12 : 1e-8) << method.name;
    }
}

TEST(Methods, FollowClosedFormsOfConstantTorques) {
    for (const Method& method : methods()) {
        MotionProblem problem = tumbling(std::string(method.name), 5.0);
        const Eigen::Vector3d torque(0.3, -0.2, 0.5);
        problem.torque = ConstantTorqueInSpace{torque};
        if (!can_solve(method, problem.inertia, problem.torque)) continue;
        // L = L0 + N t in space, for every body.
        if (method.takes_step) problem.method.step_s = method.name == "euler" ? 1e-4 : 1e-2;
        // Measured 3e-4 and at most 6e-9.
        const double tolerance = method.name == "euler" ? 1e-3 : 3e-8;
        const Eigen::Vector3d expected =
            momentum_space(problem.inertia, problem.start) + 5.0 * torque;
        const RotationState end = IntegratedRotation(problem).at(5.0);
        EXPECT_LE((momentum_space(problem.inertia, end) - expected).norm(), tolerance)
            << method.name;

        // ω = ω0 + N t/I in the body of a sphere: linear, so that a method that steps in body axes
        // is exact; measured 2e-12, rkmk4 7e-11.
        problem.inertia = InertiaTensor::from_principal_moments({2.0, 2.0, 2.0});
        problem.torque = ConstantTorqueInBody{torque};
        const RotationState spun = IntegratedRotation(problem).at(5.0);
        EXPECT_LE((spun.omega_body - problem.start.omega_body - 2.5 * torque).norm(), 1e-9)
            << method.name;
    }
}

TEST(Methods, DissipationKeepsMomentumAndEndsInTheMajorAxis) {
    for (const std::string name : {"rk4", "dopri5", "rkmk4"}) {
        MotionProblem problem = tumbling(name, 150.0);
        // Spins almost about the axis of the lowest moment, e2.
        problem.start.omega_body = {0.05, 1.0, -0.02};
        problem.torque = InternalFriction{0.5};
        const IntegratedRotation stepped(problem);
        const Eigen::Vector3d momentum = momentum_space(problem.inertia, problem.start);
        double energy = kinetic_energy(problem.inertia, problem.start);
        for (int k = 1; k <= 150; ++k) {
            const RotationState now = stepped.at(k);
            const double less = kinetic_energy(problem.inertia, now);
            EXPECT_LE(less, energy * (1.0 + 1e-14)) << name << " at " << k;
            energy = less;
            EXPECT_LE((momentum_space(problem.inertia, now) - momentum).norm(),
                      1e-14 * momentum.norm())
                << name << " at " << k;
        }
        // T = L²/(2 I1), ω along ±e1, whose moment is the highest.
        EXPECT_NEAR(energy / (momentum.squaredNorm() / 6.0), 1.0, 1e-9) << name;
        const Eigen::Vector3d end = stepped.at(150.0).omega_body;
        EXPECT_LE(std::hypot(end[1], end[2]), 1e-5 * end.norm()) << name;
    }
    // dT/dt = −κ |L × ω|²/L² with κ = rate·tr(I)/3.
    const MotionProblem problem = tumbling("rk4", 1.0);
    const RotationDynamics dynamics(problem.inertia, InternalFriction{0.5});
    const Eigen::Vector3d L =
        problem.start.omega_body.cwiseProduct(problem.inertia.moments_kg_m2());
    const Eigen::Vector3d omega = problem.start.omega_body;
    const double kappa = 0.5 * (3.0 + 1.5 + 2.2) / 3.0;
    const RotationRates rates = dynamics.rates({L, Eigen::Quaterniond::Identity()});
    EXPECT_NEAR(omega.dot(rates.momentum_rate),
                -kappa * L.cross(omega).squaredNorm() / L.squaredNorm(), 1e-15);
    EXPECT_NEAR(L.dot(rates.momentum_rate), 0.0, 1e-15);
}

TEST(IntegratedRotation, GivesTheSameStateForTheSameInstant) {
    for (const Method& method : methods()) {
        if (method.make == nullptr) continue;
        MotionProblem problem = tumbling(std::string(method.name), 10.0);
        problem.first_time_s = -4.0;
        const IntegratedRotation stepped(problem);
        problem.last_time_s = 3.0;
        problem.first_time_s = -2.0;
        problem.method.step_s =
            method.takes_step ? std::optional<double>(stepped.step_s()) : std::nullopt;
        const IntegratedRotation shorter(problem);
        for (const double t : {2.7, -1.9, 0.0, 1.0, -0.3, 2.7, 1e-9}) {
            const RotationState one = stepped.at(t);
            const RotationState other = shorter.at(t);
            EXPECT_EQ(one.omega_body, other.omega_body) << method.name;
            EXPECT_EQ(one.space_from_body.coeffs(), other.space_from_body.coeffs()) << method.name;
            EXPECT_NEAR(one.space_from_body.norm(), 1.0, 4e-16);
        }
        EXPECT_LE(attitude_error(stepped.at(0.0), problem.start), 1e-15);
    }
}

TEST(IntegratedRotation, IsAccurateBetweenItsSteps) {
    // With the default step, which is used if a scene only names the method. Measured 0.38, 1.5e-8,
    // 2e-9, 2.5e-3, 6.4e-4, 8.6e-14, 2.6e-8.
    const std::map<std::string_view, double> bound{
        {"euler", 1.0},      {"rk4", 1e-7},  {"dopri5", 1e-8}, {"midpoint", 1e-2},
        {"splitting", 2e-3}, {"dmv", 5e-13}, {"rkmk4", 1e-7}};
    for (const Method& method : methods()) {
        if (method.make == nullptr) continue;
        MotionProblem problem = tumbling(std::string(method.name), 20.0);
        problem.first_time_s = -20.0;
        const IntegratedRotation stepped(problem);
        problem.method = {};
        const Motion exact(problem);
        double worst = 0.0;
        for (int k = -97; k <= 97; ++k) {
            const double t = k * 0.2061;
            worst = std::max(worst, attitude_error(stepped.at(t), exact.at(t)));
        }
        EXPECT_LE(worst, bound.at(method.name)) << method.name;
    }
}

TEST(IntegratedRotation, LimitsItsMemory) {
    // About every eighth of 200,000 states is kept; those between are computed again by steps.
    MotionProblem problem = tumbling("rk4", 200.0);
    problem.method.step_s = 1e-3;
    const IntegratedRotation all(problem);
    EXPECT_EQ(all.counters().n_steps, 200000);
    EXPECT_EQ(all.counters().n_right_hand_sides, 800000);
    EXPECT_LE(all.n_kept_states(), IntegratedRotation::max_kept_states + 1);
    EXPECT_GE(all.n_kept_states(), IntegratedRotation::max_kept_states / 2);
    problem.last_time_s = 30.0;
    const IntegratedRotation few(problem);
    for (const double t : {0.0125, 3.3333, 17.0001, 29.9995}) {
        StepCounters cost;
        EXPECT_EQ(all.at(t, cost).omega_body, few.at(t).omega_body);
        EXPECT_LE(cost.n_steps, 9);
    }
    problem.method = {};
    problem.method.name = "dopri5";
    problem.method.tolerance = 1e-12;
    problem.last_time_s = 5000.0;
    const IntegratedRotation adaptive(problem);
    EXPECT_LE(adaptive.n_kept_states(), IntegratedRotation::max_kept_states + 1);
    EXPECT_GT(adaptive.counters().n_steps, 40000);
}

TEST(IntegratedRotation, WorksInTheUsersBodyAxes) {
    // The same body given by a full tensor in rotated axes.
    const Eigen::Quaterniond turned = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized();
    const Eigen::Matrix3d R = turned.toRotationMatrix();
    for (const std::string name : {"rk4", "dopri5", "midpoint", "splitting", "dmv", "rkmk4"}) {
        const MotionProblem plain = tumbling(name, 5.0);
        MotionProblem other = plain;
        other.inertia = InertiaTensor::from_matrix(R * plain.inertia.moments_kg_m2().asDiagonal() *
                                                   R.transpose());
        other.start.omega_body = turned * plain.start.omega_body;
        other.start.space_from_body = plain.start.space_from_body * turned.conjugate();
        MotionSample a = IntegratedRotation(plain).sample(4.3, {.herpolhode = true});
        const MotionSample b = IntegratedRotation(other).sample(4.3, {.herpolhode = true});
        a.state.space_from_body = a.state.space_from_body * turned.conjugate();
        // The principal axes may have another order, which affects the splitting.
        const double tolerance = name == "splitting" ? 2e-2 : name == "dopri5" ? 1e-7 : 1e-11;
        EXPECT_LE(attitude_error(a.state, b.state), tolerance) << name;
        EXPECT_LE((turned * a.state.omega_body - b.state.omega_body).norm(), tolerance) << name;
        EXPECT_LE((a.herpolhode_space - b.herpolhode_space).norm(), tolerance) << name;
    }
}

TEST(IntegratedRotation, ReturnsTheEulerAnglesOfItsAttitude) {
    const HeavyTopProblem top{.moment_axial_kg_m2 = 0.5,
                              .mgl_N_m = 1.0,
                              .theta_rad = 0.7,
                              .phi_dot_rad_s = 0.35,
                              .omega3_rad_s = 8.0};
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments({1.0, 1.0, 0.5});
    problem.start = start_of(top);
    problem.torque = Gravity{.mgl_N_m = 1.0};
    problem.method = stepping("rkmk4", 1e-3);
    problem.last_time_s = 6.0;
    const IntegratedRotation stepped(problem);
    const HeavyTop exact(top);
    for (const double t : {0.0, 0.4, 2.0, 6.0}) {
        const EulerAngles got = stepped.sample(t, {.euler_angles = true}).euler;
        const EulerAngles wanted = exact.euler_angles(t);
        EXPECT_NEAR(got.theta_rad, wanted.theta_rad, 1e-9);
        EXPECT_NEAR(std::remainder(got.phi_rad - wanted.phi_rad, 2 * pi), 0.0, 1e-9);
        EXPECT_NEAR(std::remainder(got.psi_rad - wanted.psi_rad, 2 * pi), 0.0, 1e-9);
        EXPECT_LE(std::abs(got.psi_rad), pi);
    }
}

TEST(RotationDynamics, BoundsTheFreeAngularVelocity) {
    for (const Eigen::Vector3d& omega :
         {Eigen::Vector3d(0.4, 0.9, -1.1), Eigen::Vector3d(1, 0.1, 0.2), Eigen::Vector3d(0.1, 1, 0),
          Eigen::Vector3d(0, 0.02, 1)}) {
        MotionProblem problem = tumbling("exact", 0.0);
        problem.start.omega_body = omega;
        const Motion motion(problem);
        double greatest = 0.0;
        for (int k = 0; k < 4000; ++k) {
            greatest = std::max(greatest, motion.at(k * 0.02).omega_body.norm());
        }
        const RotationDynamics dynamics(problem.inertia, NoTorque{});
        const double bound =
            dynamics.greatest_free_omega(omega.cwiseProduct(problem.inertia.moments_kg_m2()));
        EXPECT_GE(bound, greatest * (1 - 1e-12));
        EXPECT_LE(bound, greatest * 1.001);
    }
}

// A refused problem, and text that its message must contain.
std::string message_of(const MotionProblem& problem) {
    try {
        const Motion motion(problem);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

void expect_in(const std::string& part, const std::string& whole) {
    EXPECT_NE(whole.find(part), std::string::npos) << "\"" << part << "\" is not in: " << whole;
}

TEST(Methods, RefuseInvalidInputWithOneLine) {
    expect_in("did you mean \"rk4\"", message_of(tumbling("rk5", 1.0)));
    MotionProblem problem = tumbling("rk4", 1.0);
    for (const double step : {0.0, -0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
        problem.method.step_s = step;
        expect_in("positive number of seconds", message_of(problem));
    }
    problem.method.step_s = 1.5;
    expect_in("longer than the 1 s", message_of(problem));
    problem.method.step_s = 1e-12;
    expect_in("give at least 1e-09 s", message_of(problem));
    problem.method.step_s = 1e-2;
    problem.method.order = 3;
    expect_in("its orders are 4", message_of(problem));
    problem.method.order.reset();
    problem.method.tolerance = 1e-6;
    expect_in("takes no tolerance; give step_s", message_of(problem));

    problem = tumbling("dopri5", 1.0);
    for (const double tolerance : {0.0, -1.0, 1e-18, std::nan("")}) {
        problem.method.tolerance = tolerance;
        expect_in("give 1e-14 or more", message_of(problem));
    }
    problem.method.tolerance = 2.0;
    expect_in("below 1", message_of(problem));
    problem.method.tolerance.reset();
    problem.method.step_s = 0.1;
    expect_in("takes no step_s; give tolerance", message_of(problem));

    problem = tumbling("exact", 1.0);
    problem.method.step_s = 0.1;
    expect_in("needs neither", message_of(problem));
    problem.method.step_s.reset();
    problem.method.order = 2;
    expect_in("has only one order", message_of(problem));

    problem = tumbling("exact", 1.0);
    problem.torque = Gravity{.mgl_N_m = 1.0};
    expect_in("choose one of euler, rk4, dopri5, splitting, rkmk4", message_of(problem));
    problem.torque = ConstantTorqueInBody{{1.0, 0.0, 0.0}};
    expect_in("choose one of euler, rk4, dopri5, rkmk4", message_of(problem));
    problem = tumbling("dmv", 1.0);
    problem.torque = InternalFriction{1.0};
    expect_in("internal friction", message_of(problem));

    // A step so long that the implicit equation has no solution.
    problem = tumbling("dmv", 100.0);
    problem.method.step_s = 20.0;
    expect_in("shorter step_s", message_of(problem));
    // Euler's method diverges: it is refused and does not return NaN.
    problem = tumbling("euler", 1e4);
    problem.method.step_s = 5.0;
    expect_in("overflows", message_of(problem));

    problem = tumbling("rk4", 1.0);
    problem.torque = Gravity{.mgl_N_m = std::nan("")};
    expect_in("mgl_N_m", message_of(problem));
    problem.torque = Gravity{.mgl_N_m = 1.0, .arm_body = Eigen::Vector3d::Zero()};
    expect_in("arm of gravity is zero", message_of(problem));
    problem.torque = InternalFriction{-1.0};
    expect_in("rate ≥ 0", message_of(problem));
    problem = tumbling("rk4", 1.0);
    problem.start.omega_body[1] = std::nan("");
    expect_in("not finite", message_of(problem));

    const IntegratedRotation stepped(tumbling("rk4", 1.0));
    EXPECT_THROW(stepped.at(1.1), InputError);
    EXPECT_THROW(stepped.at(-0.1), InputError);
    EXPECT_THROW(stepped.at(std::nan("")), InputError);
}

TEST(Methods, ExactAcceptsZeroGravityAsNoTorque) {
    MotionProblem problem = tumbling("exact", 1.0);
    const RotationState free = Motion(problem).at(3.0);
    problem.torque = Gravity{.mgl_N_m = 0.0};
    const Motion motion(problem);
    EXPECT_EQ(motion.at(3.0).omega_body, free.omega_body);
    EXPECT_NE(motion.free_rotation(), nullptr);
}

// Neither stepped for ever nor to numbers that are none.
TEST(IntegratedRotation, RefusesWhatNoStepAdvances) {
    for (const double spin : {1e150, 1e200, 1e300}) {
        for (const Torque& torque : {Torque(NoTorque{}), Torque(InternalFriction{1e-3})}) {
            MotionProblem problem = tumbling("dopri5", 1e100);
            problem.start.omega_body *= spin;
            problem.torque = torque;
            try {
                IntegratedRotation::probe(problem, 1000);
                // A thousand steps are nothing of the span.
                EXPECT_LT(IntegratedRotation::probe(problem, 1000).share, 1e-90) << spin;
            } catch (const InputError& error) {
                EXPECT_GT(std::string(error.what()).size(), 0u);
            }
        }
    }
    // A time of which the largest step is less than the last place.
    MotionProblem late = tumbling("dopri5", 1e30);
    late.start.time_s = 0.0;
    late.start.omega_body *= 1e300;
    expect_in("does not advance", message_of(late));
}

// An instant beyond the end costs what one before it does.
TEST(IntegratedRotation, StepsOnceThroughWhatIsDrawnBeyondTheEnd) {
    for (const std::string name : {"rk4", "dopri5"}) {
        MotionProblem problem = tumbling(name, 1.0);
        if (name == "rk4") problem.method.step_s = 1e-3;
        problem.overshoot_s = 8.0;
        const IntegratedRotation motion(problem);
        StepCounters counters;
        motion.at(8.9, counters);
        EXPECT_LE(counters.n_steps, 2) << name;
    }
}

TEST(IntegratedRotation, HoldsABodyAtRestAndAnInstant) {
    for (const Method& method : methods()) {
        if (method.make == nullptr) continue;
        MotionProblem problem = tumbling(std::string(method.name), 5.0);
        problem.start.omega_body.setZero();
        const IntegratedRotation rest(problem);
        EXPECT_EQ(rest.at(4.0).omega_body, Eigen::Vector3d::Zero()) << method.name;
        EXPECT_LE(attitude_error(rest.at(4.0), problem.start), 1e-15) << method.name;
        const MotionProblem instant = tumbling(std::string(method.name), 0.0);
        const RotationState only = IntegratedRotation(instant).at(0.0);
        EXPECT_LE((only.omega_body - instant.start.omega_body).norm(), 1e-15) << method.name;
    }
}

// L² over- or underflows; ω does not know the unit of the moments.
TEST(IntegratedRotation, HasAHerpolhodeInEveryUnitOfMoments) {
    const MotionProblem usual = tumbling("rk4", 2.0);
    constexpr Quantities wanted{.attitude = true, .herpolhode = true};
    const Eigen::Vector3d expected = Motion(usual).sample(1.7, wanted).herpolhode_space;
    for (const int exponent : {-900, -540, 540, 724}) {
        MotionProblem scaled = usual;
        // moments_kg_m2() has an order of its own.
        const Eigen::Vector3d moments = usual.inertia.matrix_body().diagonal();
        scaled.inertia = InertiaTensor::from_principal_moments(moments * std::ldexp(1.0, exponent));
        const Eigen::Vector3d herpolhode = Motion(scaled).sample(1.7, wanted).herpolhode_space;
        EXPECT_LE((herpolhode - expected).norm(), 1e-14 * expected.norm()) << exponent;
    }
}

}  // namespace
}  // namespace poinsot::methods_tests
