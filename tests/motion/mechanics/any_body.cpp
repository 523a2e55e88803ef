#include "mechanics/any_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "error/error.h"
#include "mechanics/motion.h"
#include "numerics/power_of_two.h"

namespace poinsot::any_body {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using LongVector = Eigen::Matrix<long double, 3, 1>;
using LongMatrix = Eigen::Matrix<long double, 3, 3>;
using LongQuaternion = Eigen::Quaternion<long double>;

// In radians at the start's |ω|, near enough.
constexpr std::array turns{0.37, 23.1, -4.1e5};

Motion motion_of(const Body& body) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_matrix(body.tensor_kg_m2, body.physicality);
    problem.start.omega_body = body.omega_rad_s;
    problem.start.space_from_body = body.attitude;
    return Motion(problem);
}

// L in space and 2T of a state; long double has the exponents that they need.
struct Conserved {
    LongVector momentum;
    long double twice_energy;

    Conserved(const InertiaTensor& inertia, const RotationState& state) {
        const LongMatrix axes = inertia.body_from_principal().cast<long double>();
        const LongVector omega = axes.transpose() * state.omega_body.cast<long double>();
        const LongVector along = inertia.moments_kg_m2().cast<long double>().cwiseProduct(omega);
        const LongQuaternion attitude = state.space_from_body.cast<long double>();
        momentum = attitude.normalized() * LongVector(axes * along);
        twice_energy = along.dot(omega);
    }
};

// What a rounded ω may change: of a body in its principal axes each component of ω keeps its
// digits, of a turned one |ω| does.
std::string conserved_fault(const InertiaTensor& inertia, const RotationState& start,
                            const RotationState& state) {
    constexpr long double rounding = 1e-14L, least = std::numeric_limits<double>::denorm_min();
    const Conserved before(inertia, start), after(inertia, state);
    const long double momentum = before.momentum.norm();
    const long double most_moment = inertia.moments_kg_m2().maxCoeff();
    const long double speed = std::max(start.omega_body.cast<long double>().norm(),
                                       state.omega_body.cast<long double>().norm());
    long double in_momentum = rounding * momentum + 8.0L * least * most_moment;
    long double in_energy =
        rounding * before.twice_energy + 1e-20L * momentum * speed + 8.0L * least * momentum;
    if (!inertia.body_axes_are_principal()) {
        in_momentum = std::max(in_momentum, rounding * most_moment * speed);
        in_energy = std::max(in_energy, rounding * most_moment * speed * speed);
    }
    std::ostringstream fault;
    const long double L_off = (after.momentum - before.momentum).norm();
    const long double T_off = std::abs(after.twice_energy - before.twice_energy);
    if (!(L_off <= in_momentum))
        fault << "L is off by " << L_off / momentum << " of itself at " << state.time_s << " s";
    else if (!(T_off <= in_energy))
        fault << "T is off by " << T_off / before.twice_energy << " of itself at " << state.time_s
              << " s";
    return fault.str();
}

// x·2^exponent if that is exact and far from the smallest doubles, where products lose digits.
template <typename Matrix>
std::optional<Matrix> rescaled(const Matrix& x, int exponent) {
    constexpr double least = 0x1p-960;
    for (const double element : x.reshaped()) {
        const double changed = std::ldexp(element, exponent);
        if (element == 0.0) continue;
        if (!std::isfinite(changed) || std::abs(changed) < least || std::abs(element) < least)
            return std::nullopt;
    }
    return ldexp(x, exponent);
}

double angle_between_attitudes(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return 2.0 * std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

bool names_what_it_refuses(const std::string& message) {
    for (const char* name : {"tensor_kg_m2", "omega_rad_s", "omega t", "attitude", " lies beyond "})
        if (message.find(name) != std::string::npos) return true;
    return false;
}

// The motion in units in which the body's numbers are of order one.
struct Twin {
    Motion motion;
    int omega_exponent;
};
std::optional<Twin> twin_of(const Body& body) {
    Body changed = body;
    const int exponent = exponent_of(body.omega_rad_s);
    const auto tensor = rescaled(body.tensor_kg_m2, -exponent_of(body.tensor_kg_m2));
    const auto omega = rescaled(body.omega_rad_s, -exponent);
    if (!tensor || !omega) return std::nullopt;
    changed.tensor_kg_m2 = *tensor;
    changed.omega_rad_s = *omega;
    return Twin{motion_of(changed), exponent};
}

std::string state_fault(const RotationState& state, const RotationState& other, int exponent) {
    constexpr double rounding = 4e-15;
    const Vector3d omega = ldexp(state.omega_body, -exponent);
    std::ostringstream fault;
    const double omega_off = (omega - other.omega_body).stableNorm();
    const double speed = other.omega_body.stableNorm();
    const double attitude_off =
        angle_between_attitudes(state.space_from_body, other.space_from_body);
    if (!(omega_off <= rounding * speed))
        fault << "in other units omega is off by " << omega_off / speed << " at " << other.time_s;
    else if (!(attitude_off <= rounding))
        fault << "in other units the attitude is off by " << attitude_off << " rad at "
              << other.time_s;
    return fault.str();
}

void measure(const Body& body, Outcome& outcome) {
    const Motion motion = motion_of(body);
    const InertiaTensor& inertia = motion.problem().inertia;
    const int exponent = exponent_of(body.omega_rad_s);
    const RotationState start = motion.at(0.0);
    std::optional<Twin> twin;
    try {
        twin = twin_of(body);
    } catch (const InputError& error) {
        outcome.fault = std::string("refused in other units: ") + error.what();
        return;
    }
    for (const double turn : turns) {
        const double time_s = std::ldexp(turn, -exponent);
        if (!std::isnormal(time_s)) continue;
        const MotionSample sample =
            motion.sample(time_s, {.attitude = true, .herpolhode = true, .euler_angles = true});
        if (!(std::abs(sample.state.space_from_body.norm() - 1.0) <= 1e-15))
            outcome.fault = "the quaternion is not of unit length";
        if (outcome.fault.empty()) outcome.fault = conserved_fault(inertia, start, sample.state);
        if (outcome.fault.empty() && twin) {
            outcome.fault = state_fault(sample.state, twin->motion.at(turn), twin->omega_exponent);
            outcome.is_twin = true;
        }
        if (!outcome.fault.empty()) return;
    }
}

}  // namespace

Outcome moved(const Body& body) {
    Outcome outcome;
    try {
        measure(body, outcome);
    } catch (const InputError& error) {
        outcome.refusal = error.what();
        if (!names_what_it_refuses(outcome.refusal))
            outcome.fault = "refused without a name: " + outcome.refusal;
    }
    return outcome;
}

}  // namespace poinsot::any_body
