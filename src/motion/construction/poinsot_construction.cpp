#include "construction/poinsot_construction.h"

#include <algorithm>
#include <cmath>

#include "error/error.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// Angle between two vectors in rad, accurate at 0 and π (no acos).
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d x = ldexp(a, -exponent_of(a));
    const Eigen::Vector3d y = ldexp(b, -exponent_of(b));
    return std::atan2(norm_of(x.cross(y)), x.dot(y));
}

}  // namespace

PoinsotConstruction::PoinsotConstruction(const InertiaTensor& inertia, const RotationState& start)
    : inertia_(inertia), tensor_(inertia.matrix_body()) {
    const double largest = start.omega_body.cwiseAbs().maxCoeff();
    if (!(largest > 0.0)) {
        throw InputError(
            "omega_rad_s is zero: a body at rest has no invariable plane; give an angular "
            "velocity");
    }

    // Scaling by a power of two brings ω to order one, so that T and L neither overflow nor
    // underflow.
    omega_exponent_ = exponent_of(largest);
    const Eigen::Vector3d omega = ldexp(start.omega_body, -omega_exponent_);
    const Eigen::Vector3d momentum = tensor_ * omega;
    sqrt_2T_scaled_ = std::sqrt(omega.dot(momentum));
    momentum_scaled_space_ = start.space_from_body * momentum;
    normal_space_ = momentum_scaled_space_.stableNormalized();
    plane_distance_ = sqrt_2T_scaled_ / norm_of(momentum);
}

Eigen::Vector3d PoinsotConstruction::half_axes() const {
    return inertia_.moments_kg_m2().cwiseSqrt().cwiseInverse();
}

double PoinsotConstruction::kinetic_energy_J() const {
    return std::ldexp(0.5 * sqrt_2T_scaled_ * sqrt_2T_scaled_, 2 * omega_exponent_);
}

double PoinsotConstruction::momentum_kg_m2_s() const {
    return std::ldexp(norm_of(momentum_scaled_space_), omega_exponent_);
}

Eigen::Vector3d PoinsotConstruction::contact_body(const Eigen::Vector3d& omega_body) const {
    return ldexp(omega_body, -omega_exponent_) / sqrt_2T_scaled_;
}

Eigen::Vector3d PoinsotConstruction::contact_space(const RotationState& state) const {
    return state.space_from_body * contact_body(state.omega_body);
}

Eigen::Vector3d PoinsotConstruction::contact_in_plane(
    const Eigen::Vector3d& herpolhode_space) const {
    return contact_body(herpolhode_space);
}

Eigen::Vector3d PoinsotConstruction::tangency_point_space(
    const Eigen::Quaterniond& space_from_body) const {
    // F(r) = 1 with J r ∥ n gives r = J⁻¹n/√(n·J⁻¹n), in principal axes term by term.
    const Eigen::Matrix3d& axes = inertia_.body_from_principal();
    const Eigen::Vector3d n = axes.transpose() * (space_from_body.conjugate() * normal_space_);
    const Eigen::Vector3d inverse_n = n.cwiseQuotient(inertia_.moments_kg_m2());
    return space_from_body * (axes * (inverse_n / std::sqrt(n.dot(inverse_n))));
}

RollingResiduals PoinsotConstruction::residuals(const RotationState& state) const {
    const Eigen::Vector3d omega = ldexp(state.omega_body, -omega_exponent_);
    const Eigen::Vector3d momentum = state.space_from_body * (tensor_ * omega);
    const double twice_T = omega.dot(tensor_ * omega);
    const double twice_T_start = sqrt_2T_scaled_ * sqrt_2T_scaled_;

    RollingResiduals r;
    const Eigen::Vector3d contact = contact_space(state);
    r.contact_plane_gap = std::abs(contact.dot(normal_space_) - plane_distance_) / plane_distance_;
    const Eigen::Vector3d touching = tangency_point_space(state.space_from_body);
    r.tangency_gap = std::abs(touching.dot(normal_space_) - plane_distance_) / plane_distance_;
    const Eigen::Vector3d omega_space = state.space_from_body * omega;
    const double longest = half_axes().maxCoeff();
    r.slip = omega_space.cross(touching / longest).norm() / omega.norm();
    r.momentum = norm_of(momentum - momentum_scaled_space_) / norm_of(momentum_scaled_space_);
    r.energy = std::abs(twice_T - twice_T_start) / twice_T_start;
    r.unit_quaternion = std::abs(state.space_from_body.norm() - 1.0);
    return r;
}

std::optional<RollingCones> rolling_cones(const InertiaTensor& inertia,
                                          const Eigen::Vector3d& omega_body) {
    // The symmetry axis is the one whose moment differs from two equal ones.
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        if (I[j] == I[k] && I[i] != I[j]) axis = i;
    }
    if (axis < 0 || omega_body.isZero(0.0)) return std::nullopt;

    const double largest = omega_body.cwiseAbs().maxCoeff();
    const Eigen::Vector3d omega =
        inertia.body_from_principal().transpose() * (omega_body / largest);
    // Only ratios of the moments matter; those of bodies that nature has are doubles.
    const Eigen::Vector3d moments = ldexp(I, -exponent_of(I));
    const Eigen::Vector3d momentum = moments.cwiseProduct(omega);
    const double I1 = moments[(axis + 1) % 3];
    const double I3 = moments[axis];
    if (!std::isnormal(I1)) return std::nullopt;

    // The cones are drawn about the half of the symmetry axis on ω's side.
    const Eigen::Vector3d symmetry = std::copysign(1.0, omega[axis]) * Eigen::Vector3d::Unit(axis);
    RollingCones cones;
    cones.symmetry_axis = axis;
    cones.body_half_angle_rad = angle_between(omega, symmetry);
    cones.space_half_angle_rad = angle_between(omega, momentum);
    cones.body_precession_rad_s = (I3 - I1) / I1 * omega[axis] * largest;
    cones.space_precession_rad_s = norm_of(momentum) / I1 * largest;
    cones.body_cone_outside = I3 < I1;
    return cones;
}

}  // namespace poinsot
