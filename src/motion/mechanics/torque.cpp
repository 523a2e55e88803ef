#include "mechanics/torque.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "error/error.h"

namespace poinsot {

namespace {

constexpr std::array<std::string_view, std::variant_size_v<Torque>> torque_names{
    "none", "gravity", "constant in the body", "constant in space", "internal dissipation", "drag"};

void require_finite(bool finite, const char* what) {
    if (!finite) throw InputError(fmt::format("{} of the torque must be finite", what));
}

// The same torque with its body vectors in principal axes.
Torque in_principal_axes(const Torque& torque, const InertiaTensor& inertia) {
    const Eigen::Matrix3d principal_from_body = inertia.body_from_principal().transpose();
    Torque turned = torque;
    if (auto* gravity = std::get_if<GravityTorque>(&turned)) {
        require_finite(std::isfinite(gravity->mgl_N_m), "mgl_N_m");
        require_finite(gravity->arm_body.allFinite(), "the arm");
        if (gravity->arm_body.isZero(0.0)) {
            throw InputError(
                "the arm of gravity is zero; give the direction of the centre of mass");
        }
        gravity->arm_body = principal_from_body * gravity->arm_body.stableNormalized();
    } else if (auto* fixed = std::get_if<ConstantBodyTorque>(&turned)) {
        require_finite(fixed->torque_body_N_m.allFinite(), "torque_body_N_m");
        fixed->torque_body_N_m = principal_from_body * fixed->torque_body_N_m;
    } else if (auto* space = std::get_if<ConstantSpaceTorque>(&turned)) {
        require_finite(space->torque_space_N_m.allFinite(), "torque_space_N_m");
    } else if (auto* friction = std::get_if<DissipationTorque>(&turned)) {
        require_finite(std::isfinite(friction->rate_1_s), "the rate of dissipation");
        if (friction->rate_1_s < 0.0) {
            throw InputError(fmt::format(
                "the rate of dissipation is {} 1/s; friction takes energy: give a rate ≥ 0",
                friction->rate_1_s));
        }
    } else if (auto* drag = std::get_if<DragTorque>(&turned)) {
        require_finite(std::isfinite(drag->growth_1_s), "the growth of the drag");
        for (const Eigen::Vector3d& rates : {drag->linear_1_s, drag->quadratic_1_rad}) {
            require_finite(rates.allFinite(), "a rate of the drag");
            if (rates.minCoeff() < 0.0)
                throw InputError(
                    fmt::format("a rate of the drag is {}; the air slows a body: give rates ≥ 0",
                                rates.minCoeff()));
        }
    }
    return turned;
}

}  // namespace

std::string_view name_of(const Torque& torque) { return torque_names.at(torque.index()); }

RotationDynamics::RotationDynamics(const InertiaTensor& inertia, const Torque& torque)
    : moments_(inertia.moments_kg_m2()),
      least_over_moments_((moments_ / moments_.minCoeff()).cwiseInverse()),
      torque_(in_principal_axes(torque, inertia)) {
    if (const auto* friction = std::get_if<DissipationTorque>(&torque_)) {
        // By ratios of moments: their sum may overflow, their inverses too.
        dissipation_1_s_ = friction->rate_1_s * (moments_ / moments_.minCoeff()).sum() / 3.0;
    }
}

Eigen::Vector3d RotationDynamics::torque_on(const StepState& state) const {
    if (const auto* gravity = std::get_if<GravityTorque>(&torque_)) {
        const Eigen::Vector3d vertical =
            state.space_from_principal.conjugate() * Eigen::Vector3d::UnitZ();
        return gravity->mgl_N_m * vertical.cross(gravity->arm_body);
    }
    if (const auto* fixed = std::get_if<ConstantBodyTorque>(&torque_)) {
        return fixed->torque_body_N_m;
    }
    if (const auto* space = std::get_if<ConstantSpaceTorque>(&torque_)) {
        return state.space_from_principal.conjugate() * space->torque_space_N_m;
    }
    if (const auto* drag = std::get_if<DragTorque>(&torque_)) {
        const Eigen::Vector3d speed = omega(state.momentum).cwiseAbs();
        const double grown =
            drag->growth_1_s == 0.0 ? 1.0 : std::exp(drag->growth_1_s * state.time_s);
        return -grown * (drag->linear_1_s + drag->quadratic_1_rad.cwiseProduct(speed))
                            .cwiseProduct(state.momentum);
    }
    return Eigen::Vector3d::Zero();
}

RotationRates RotationDynamics::rates(const StepState& state) const {
    const Eigen::Vector3d& L = state.momentum;
    RotationRates rates;
    rates.turning = omega(L);
    if (dissipation_1_s_ != 0.0) {
        // κ (L × ω)/L² by the direction of L, whose square may be no double.
        const Eigen::Vector3d along = L.stableNormalized();
        rates.turning += dissipation_1_s_ * along.cross(along.cwiseProduct(least_over_moments_));
    }
    rates.momentum_rate = L.cross(rates.turning);
    if (has_torque()) rates.momentum_rate += torque_on(state);
    return rates;
}

double RotationDynamics::energy_J(const StepState& state) const {
    const double kinetic = 0.5 * state.momentum.dot(omega(state.momentum));
    const auto* gravity = std::get_if<GravityTorque>(&torque_);
    if (gravity == nullptr) return kinetic;
    const Eigen::Vector3d arm = state.space_from_principal * gravity->arm_body;
    return kinetic + gravity->mgl_N_m * arm.z();
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
    return 0.5 * dissipation_1_s_ * (1.0 - least_over_moments_.minCoeff());
}

double RotationDynamics::greatest_drag_rate_1_s(const Eigen::Vector3d& momentum,
                                                double first_time_s, double last_time_s) const {
    const auto* drag = std::get_if<DragTorque>(&torque_);
    if (drag == nullptr) return 0.0;
    // T never grows: |ω_i| ≤ √(2T/I_i). In units of the least moment, so that T is a double.
    const Eigen::Vector3d weights = least_over_moments_.cwiseSqrt();
    const double root = omega(momentum).cwiseQuotient(weights).stableNorm();
    const Eigen::Vector3d speed = root * weights;
    const double grown =
        std::exp(std::max(drag->growth_1_s * first_time_s, drag->growth_1_s * last_time_s));
    return grown * (drag->linear_1_s + drag->quadratic_1_rad.cwiseProduct(speed)).maxCoeff();
}

double RotationDynamics::greatest_torque_N_m() const {
    if (const auto* gravity = std::get_if<GravityTorque>(&torque_)) {
        return std::abs(gravity->mgl_N_m);
    }
    if (const auto* fixed = std::get_if<ConstantBodyTorque>(&torque_)) {
        return fixed->torque_body_N_m.norm();
    }
    if (const auto* space = std::get_if<ConstantSpaceTorque>(&torque_)) {
        return space->torque_space_N_m.norm();
    }
    return 0.0;
}

}  // namespace poinsot
