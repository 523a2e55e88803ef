// The start of a torque-free motion from its conserved quantities: T and L choose the polhode, and
// a direction the point on it.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "mechanics/inertia.h"

namespace poinsot {

// T, and L or the distance √(2T)/L of the invariable plane from the fixed centre.
struct ConservedQuantities {
    double energy_J = 0.0;                   // positive
    std::optional<double> momentum_kg_m2_s;  // positive; one of these two is given
    std::optional<double> plane_distance;    // 1/√(kg m²), positive
};

struct PolhodeStart {
    Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  // rad/s
    // Whether L² = 2T·I₂ holds exactly, I₂ being the middle one of three different moments; ω is
    // rounded, so that it does not say so itself.
    bool on_separatrix = false;
};

// The point of the polhode that the half-plane through the encircled axis and the direction (body
// axes) meets. On the separatrix this axis is that of the largest moment, as in FreeRotation. By
// default, or for a direction along that axis, the half-plane is spanned by the axes of the largest
// and the smallest moment.
//
// Few numbers such as √(2T·I) are exact decimals, and a calculation in doubles may miss the nearest
// double by one. L is therefore taken as √(2T·I) of a principal moment I if it is the nearest
// double or one of its neighbours, and so is the plane's distance as 1/√I.
//
// Throws InputError that names the quantity and gives its range if no rotation of the body has
// these.
PolhodeStart start_on_polhode(const InertiaTensor& inertia, const ConservedQuantities& conserved,
                              const std::optional<Eigen::Vector3d>& direction_body = {});

}  // namespace poinsot
