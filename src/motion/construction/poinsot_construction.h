// The constants of one free motion and the contact point: the geometry of Poinsot's construction.
// Depends on mechanics only.
//
// Lengths are those of the inertia ellipsoid F(ρ) = ρᵀJρ = 1, in 1/√(kg m²), with ρ = ω/√(2T). Its
// normal at ρ is ∇F = 2Jρ = √(2/T) L. Therefore the ellipsoid touches the invariable plane n·x =
// +√(2T)/L, with n = L/|L|, at the tip of ρ. It rolls on the plane, because the contact point lies
// on the instantaneous axis. All drawings use this plane; the other tangent plane, at −ρ, is not
// drawn. Source: Goldstein, Classical Mechanics §5.6; Landau & Lifshitz, Mechanics §37.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "mechanics/inertia.h"
#include "mechanics/rotation_state.h"

namespace poinsot {

// Deviations of a state from Poinsot's construction; zero for the exact motion.
struct RollingResiduals {
    double contact_plane_gap = 0.0;  // distance of ρ from the plane over the plane's distance
    double tangency_gap = 0.0;       // of the ellipsoid's point of tangency from it, likewise
    double slip = 0.0;             // |ω × r| at that point r, over |ω| and the largest half-axis
    double momentum = 0.0;         // |L(t) − L(0)|/|L(0)|, as vectors in space
    double energy = 0.0;           // |T(t) − T(0)|/T(0)
    double unit_quaternion = 0.0;  // | |q| − 1 |
};

class PoinsotConstruction {
 public:
    // Constructs it from any state of the motion. Throws InputError for ω = 0, which has no
    // invariable plane.
    PoinsotConstruction(const InertiaTensor& inertia, const RotationState& start);

    const InertiaTensor& inertia() const { return inertia_; }

    // 1/√I_i, in the order of the principal axes.
    Eigen::Vector3d half_axes() const;
    // √(2T)/L, the distance of the invariable plane from the centre.
    double plane_distance() const { return plane_distance_; }
    // n = L/|L| in space axes: the plane's normal, from the centre towards the plane.
    const Eigen::Vector3d& normal_space() const { return normal_space_; }

    // T in J and |L| in kg m²/s; may overflow or underflow where the geometry above does not.
    double kinetic_energy_J() const;
    double momentum_kg_m2_s() const;

    // ρ = ω/√(2T): the contact point in body axes and in space axes.
    Eigen::Vector3d contact_body(const Eigen::Vector3d& omega_body) const;
    Eigen::Vector3d contact_space(const RotationState& state) const;
    // ρ's component in the plane, from ω's component perpendicular to L; keeps relative accuracy
    // at any radius.
    Eigen::Vector3d contact_in_plane(const Eigen::Vector3d& herpolhode_space) const;

    // Point of the ellipsoid with the outward normal n, in space axes: computed from the tangency
    // alone, without ω.
    Eigen::Vector3d tangency_point_space(const Eigen::Quaterniond& space_from_body) const;

    RollingResiduals residuals(const RotationState& state) const;

 private:
    InertiaTensor inertia_;
    Eigen::Matrix3d tensor_;       // body axes, kg m²
    int omega_exponent_ = 0;       // ω·2^−exponent has a largest component in [½, 1)
    double sqrt_2T_scaled_ = 0.0;  // √(2T) of the scaled ω
    double plane_distance_ = 0.0;
    Eigen::Vector3d normal_space_;
    Eigen::Vector3d momentum_scaled_space_;
};

// Half-angles of the cones of a symmetric body and the rates at which they roll.
struct RollingCones {
    int symmetry_axis = 2;              // index of the principal axis of symmetry
    double body_half_angle_rad = 0.0;   // between ω and the symmetry axis
    double space_half_angle_rad = 0.0;  // between ω and L
    double body_precession_rad_s =
        0.0;  // Ω = (I₃−I₁)ω₃/I₁, of ω about the symmetry axis, body axes
    double space_precession_rad_s = 0.0;  // L/I₁, of the symmetry axis about L
    bool body_cone_outside =
        true;  // prolate: body cone rolls outside the space cone; oblate: around it
};

// Returns the cones of a body with two equal moments, from ω in body axes; none for a body without
// symmetry or a sphere. Source: Landau & Lifshitz, Mechanics §35; Goldstein §5.6.
std::optional<RollingCones> rolling_cones(const InertiaTensor& inertia,
                                          const Eigen::Vector3d& omega_body);

}  // namespace poinsot
