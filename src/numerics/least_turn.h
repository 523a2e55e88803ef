// The least turn between two directions.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace poinsot {

// The turn by the least angle that takes the direction of `from` onto that of `to`, neither zero;
// between opposite directions, the half turn about an axis across them that Eigen chooses. In a
// file of its own, since Eigen has a whole SVD compiled wherever it is asked.
Eigen::Quaterniond least_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace poinsot
