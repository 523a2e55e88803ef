#include "numerics/least_turn.h"

namespace poinsot {

Eigen::Quaterniond least_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return Eigen::Quaterniond::FromTwoVectors(from, to);
}

}  // namespace poinsot
