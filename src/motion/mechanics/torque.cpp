#include "mechanics/torque.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "error/error.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// The laws, kind by kind. A kind has the functions that differ from those of "none".

void require_finite(bool finite, const char* what) {
    if (!finite) throw InputError(fmt::format("{} of the torque must be finite", what));
}

// Checks the numbers, and turns vectors of body axes into principal axes.
template <typename Kind>
void turn(Kind& /*none*/, const Eigen::Matrix3d& /*principal_from_body*/) {}
// N in N m, principal axes.
template <typename Kind>
Eigen::Vector3d torque_N_m(const Kind& /*none*/, const StepState& /*state*/,
                           const Eigen::Vector3d& /*omega*/) {
    return Eigen::Vector3d::Zero();
}
// An upper bound of |N| in N m that does not depend on ω.
template <typename Kind>
double greatest_N_m(const Kind& /*none*/) {
    return 0.0;
}

// Gravity.
void turn(Gravity& gravity, const Eigen::Matrix3d& principal_from_body) {
    require_finite(std::isfinite(gravity.mgl_N_m), "mgl_N_m");
    require_finite(gravity.arm_body.allFinite(), "the arm");
    if (gravity.arm_body.isZero(0.0)) {
        throw InputError("the arm of gravity is zero; give the direction of the centre of mass");
    }
    gravity.arm_body = principal_from_body * gravity.arm_body.stableNormalized();
}
Eigen::Vector3d torque_N_m(const Gravity& gravity, const StepState& state,
                           const Eigen::Vector3d& /*omega*/) {
    const Eigen::Vector3d vertical =
        state.space_from_principal.conjugate() * Eigen::Vector3d::UnitZ();
    return gravity.mgl_N_m * vertical.cross(gravity.arm_body);
}
double greatest_N_m(const Gravity& gravity) { return std::abs(gravity.mgl_N_m); }

// Constant torques.
void turn(ConstantTorqueInBody& constant, const Eigen::Matrix3d& principal_from_body) {
    require_finite(constant.torque_body_N_m.allFinite(), "torque_body_N_m");
    constant.torque_body_N_m = principal_from_body * constant.torque_body_N_m;
}
Eigen::Vector3d torque_N_m(const ConstantTorqueInBody& constant, const StepState& /*state*/,
                           const Eigen::Vector3d& /*omega*/) {
    return constant.torque_body_N_m;
}
double greatest_N_m(const ConstantTorqueInBody& constant) {
    return constant.torque_body_N_m.norm();
}
void turn(ConstantTorqueInSpace& constant, const Eigen::Matrix3d& /*principal_from_body*/) {
    require_finite(constant.torque_space_N_m.allFinite(), "torque_space_N_m");
}
Eigen::Vector3d torque_N_m(const ConstantTorqueInSpace& constant, const StepState& state,
                           const Eigen::Vector3d& /*omega*/) {
    return state.space_from_principal.conjugate() * constant.torque_space_N_m;
}
double greatest_N_m(const ConstantTorqueInSpace& constant) {
    return constant.torque_space_N_m.norm();
}

// Internal friction, which turns the axes instead: RotationDynamics::rates.
void turn(InternalFriction& friction, const Eigen::Matrix3d& /*principal_from_body*/) {
    require_finite(std::isfinite(friction.rate_1_s), "the rate of internal friction");
    if (friction.rate_1_s < 0.0) {
        throw InputError(fmt::format(
            "the rate of internal friction is {} 1/s; friction takes energy: give a rate ≥ 0",
            friction.rate_1_s));
    }
}

// The drag of the air.
void turn(Drag& drag, const Eigen::Matrix3d& /*principal_from_body*/) {
    require_finite(std::isfinite(drag.growth_1_s), "the growth of the drag");
    for (const Eigen::Vector3d& rates : {drag.linear_1_s, drag.quadratic_1_rad}) {
        require_finite(rates.allFinite(), "a rate of the drag");
        if (rates.minCoeff() < 0.0)
            throw InputError(
                fmt::format("a rate of the drag is {}; the air slows a body: give rates ≥ 0",
                            rates.minCoeff()));
    }
}
Eigen::Vector3d torque_N_m(const Drag& drag, const StepState& state, const Eigen::Vector3d& omega) {
    const Eigen::Vector3d speed = omega.cwiseAbs();
    const double grown = drag.growth_1_s == 0.0 ? 1.0 : std::exp(drag.growth_1_s * state.time_s);
    return -grown * (drag.linear_1_s + drag.quadratic_1_rad.cwiseProduct(speed))
                        .cwiseProduct(state.momentum);
}

// The same torque with its body vectors in principal axes.
Torque in_principal_axes(Torque torque, const InertiaTensor& inertia) {
    const Eigen::Matrix3d principal_from_body = inertia.body_from_principal().transpose();
    std::visit([&](auto& kind) { turn(kind, principal_from_body); }, torque);
    return torque;
}

}  // namespace

RotationDynamics::RotationDynamics(const InertiaTensor& inertia, const Torque& torque)
    : moments_(inertia.moments_kg_m2()),
      least_over_moments_((moments_ / moments_.minCoeff()).cwiseInverse()),
      torque_(in_principal_axes(torque, inertia)) {
    if (const auto* friction = std::get_if<InternalFriction>(&torque_)) {
        // By ratios of moments: their sum may overflow, their inverses too.
        friction_1_s_ = friction->rate_1_s * (moments_ / moments_.minCoeff()).sum() / 3.0;
    }
}

Eigen::Vector3d RotationDynamics::torque_on(const StepState& state) const {
    const Eigen::Vector3d omega_principal = omega(state.momentum);
    return std::visit([&](const auto& kind) { return torque_N_m(kind, state, omega_principal); },
                      torque_);
}

RotationRates RotationDynamics::rates(const StepState& state) const {
    const Eigen::Vector3d& L = state.momentum;
    RotationRates rates;
    rates.turning = omega(L);
    if (friction_1_s_ != 0.0) {
        // κ (L × ω)/L² by the direction of L, whose square may be no double.
        const Eigen::Vector3d along = L.stableNormalized();
        rates.turning += friction_1_s_ * along.cross(along.cwiseProduct(least_over_moments_));
    }
    rates.momentum_rate = L.cross(rates.turning);
    if (has_torque()) rates.momentum_rate += torque_on(state);
    return rates;
}

double RotationDynamics::energy_J(const StepState& state) const {
    const double kinetic = 0.5 * state.momentum.dot(omega(state.momentum));
    return kinetic + potential_J(torque_, state.space_from_principal);
}

double potential_J(const Torque& torque, const Eigen::Quaterniond& space_from_axes) {
    const auto* gravity = std::get_if<Gravity>(&torque);
    if (gravity == nullptr) return 0.0;
    const Eigen::Vector3d arm = space_from_axes * gravity->arm_body;
    return gravity->mgl_N_m * arm.z();
}

double RotationDynamics::greatest_free_omega(const Eigen::Vector3d& momentum) const {
    // |ω|² is linear in the squares of L's components, which are linear along the polhode: it is
    // greatest at one of the ends, where the middle or an outer component vanishes.
    std::array<int, 3> axis{0, 1, 2};
    std::sort(axis.begin(), axis.end(), [&](int i, int j) { return moments_[i] < moments_[j]; });
    // In a unit near the least moment, a power of two, so that squares neither over- nor underflow.
    const int exponent = std::ilogb(moments_[axis[0]]);
    Eigen::Vector3d inverse, squares;
    for (int i = 0; i < 3; ++i) {
        inverse[i] = 1.0 / std::ldexp(moments_[axis[i]], -exponent);
        const double scaled = std::ldexp(momentum[axis[i]], -exponent);
        squares[i] = scaled * scaled;
    }
    const double spread = inverse[0] - inverse[2];
    const double now = squares.dot(inverse.cwiseProduct(inverse));
    if (!(spread > 0.0)) return std::sqrt(now);
    // Moving the square of the middle component by −x moves the others by B0 x and B2 x.
    const double share0 = (inverse[1] - inverse[2]) / spread;
    const double share2 = (inverse[0] - inverse[1]) / spread;
    const double slope = share0 * inverse[0] * inverse[0] + share2 * inverse[2] * inverse[2] -
                         inverse[1] * inverse[1];
    const double most = squares[1];
    double least = 0.0;
    if (share0 > 0.0 && share2 > 0.0) {
        least = -std::min(squares[0] / share0, squares[2] / share2);
    }
    return std::sqrt(std::max({now, now + slope * most, now + slope * least}));
}

double RotationDynamics::greatest_friction_turning_rad_s() const {
    return 0.5 * friction_1_s_ * (1.0 - least_over_moments_.minCoeff());
}

double RotationDynamics::greatest_drag_rate_1_s(const Eigen::Vector3d& momentum,
                                                double first_time_s, double last_time_s) const {
    const auto* drag = std::get_if<Drag>(&torque_);
    if (drag == nullptr) return 0.0;
    // T never grows: |ω_i| ≤ √(2T/I_i). In units of the least moment, so that T is a double.
    const Eigen::Vector3d weights = least_over_moments_.cwiseSqrt();
    const double root = norm_of(omega(momentum).cwiseQuotient(weights));
    const Eigen::Vector3d speed = root * weights;
    const double grown =
        std::exp(std::max(drag->growth_1_s * first_time_s, drag->growth_1_s * last_time_s));
    return grown * (drag->linear_1_s + drag->quadratic_1_rad.cwiseProduct(speed)).maxCoeff();
}

double RotationDynamics::greatest_torque_N_m() const {
    return std::visit([](const auto& kind) { return greatest_N_m(kind); }, torque_);
}

}  // namespace poinsot
