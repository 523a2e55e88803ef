// The Euler angles of an attitude.
#pragma once

#include "mechanics/rotation_state.h"

namespace poinsot {

// z-x-z, φ and ψ within ±π; φ−ψ is taken as zero where θ is 0 and φ+ψ where it is π.
EulerAngles euler_angles_of(const Eigen::Quaterniond& space_from_body);

}  // namespace poinsot
