// The Euler angles of an attitude.
#pragma once

#include "mechanics/rotation_state.h"

namespace poinsot {

// Returns the z-x-z Euler angles, φ and ψ within ±π; φ−ψ is set to zero where θ = 0, and φ+ψ where
// θ = π.
EulerAngles euler_angles_of(const Eigen::Quaterniond& space_from_body);

}  // namespace poinsot
