// The rotation by the smallest angle between two directions.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace poinsot {

// Returns the rotation by the smallest angle that takes the direction of `from` onto that of `to`.
// For opposite directions it is a half turn about a perpendicular axis that Eigen chooses.
// Precondition: neither vector is zero. It has its own source file because Eigen compiles an entire
// SVD wherever the call appears.
Eigen::Quaterniond least_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace poinsot
