// An ellipsoid described by the axes u in which it is the unit sphere about the origin.
#pragma once

#include <Eigen/Core>

#include "shapes/solids.h"

namespace poinsot {

struct UnitSphere {
    explicit UnitSphere(const Ellipsoid& ellipsoid);

    Eigen::Matrix3d axes;    // columns: half-axes, none shorter than 1e-6 of the longest
    Eigen::Matrix3d to_u;    // their inverse: u = to_u (X − centre)
    Eigen::Vector3d centre;  // view axes
};

}  // namespace poinsot
