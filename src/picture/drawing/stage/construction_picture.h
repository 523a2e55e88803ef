// Poinsot's construction in the axes and lengths of the picture.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string_view>

#include "construction/poinsot_construction.h"
#include "construction/polhode.h"
#include "drawing/stage/drawer.h"
#include "mechanics/motion_problem.h"

namespace poinsot {

// Poinsot's construction in picture axes: the fixed centre is the origin, z is up, and the
// ellipsoid's largest half-axis is 1. If the plane is below, L points down along −z: this is the
// picture with L up, rotated by half a turn about its x axis (not mirrored), so that the right-hand
// rule holds for every arrow.
struct ConstructionPicture {
    PoinsotConstruction construction;
    Polhode polhode;
    std::optional<RollingCones> cones;
    double picture_per_rho = 1.0;
    Eigen::Quaterniond picture_from_space = Eigen::Quaterniond::Identity();
    Eigen::Vector3d half_axes = Eigen::Vector3d::Ones();
    Eigen::Vector3d normal = -Eigen::Vector3d::UnitZ();  // n = L/|L|, from the centre to the plane
    double plane_distance = 1.0;
    double herpolhode_radius = 0.0;  // outer radius of the annulus
    // Whether friction or drag reduces T: then the plane's distance at an instant is that instant's
    // √(2T)/L, and ρ is computed with the instant's T. The values above are those at the start.
    bool dissipates = false;
    // Whether drag also changes L: then the space axes of the picture turn with L, so that the
    // plane stays normal to z.
    bool is_slowed = false;

    // `plane`: "below" or "above", as [construction] says.
    ConstructionPicture(const MotionProblem& problem, std::string_view plane);

    // Foot of L on the plane; of a dissipating body, at the start or at an instant.
    Eigen::Vector3d foot() const { return plane_distance * normal; }
    Eigen::Vector3d foot(const FrameInput& instant) const;
    // √(T(0)/T) for this ω: 1 if T is conserved.
    double rho_growth(const Eigen::Vector3d& omega_body) const;
    // √(2T)/L for this ω over its value at the start: 1 if T and L are conserved.
    double plane_approach(const Eigen::Vector3d& omega_body) const;
    // ρ = ω/√(2T) in body axes, in the ellipsoid's lengths.
    Eigen::Vector3d contact_body(const Eigen::Vector3d& omega_body) const;

    // Columns are e1, e2, e3 in picture axes.
    Eigen::Matrix3d principal_axes(const FrameInput& instant) const;
    Eigen::Quaterniond picture_from_body(const FrameInput& instant) const;
    // The tip of ρ, where ellipsoid and plane touch.
    Eigen::Vector3d contact(const FrameInput& instant) const;
};

}  // namespace poinsot
