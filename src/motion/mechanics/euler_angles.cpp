#include "mechanics/euler_angles.h"

#include <cmath>
#include <numbers>

namespace poinsot {

EulerAngles euler_angles_of(const Eigen::Quaterniond& q) {
    // R = Rz(φ)Rx(θ)Rz(ψ): w, z = cos(θ/2)·cos, sin((φ+ψ)/2); x, y = sin(θ/2)·cos, sin((φ−ψ)/2).
    const double half_sum = q.w() == 0.0 && q.z() == 0.0 ? 0.0 : std::atan2(q.z(), q.w());
    const double half_difference = q.x() == 0.0 && q.y() == 0.0 ? 0.0 : std::atan2(q.y(), q.x());
    EulerAngles angles;
    angles.theta_rad = 2.0 * std::atan2(std::hypot(q.x(), q.y()), std::hypot(q.w(), q.z()));
    angles.phi_rad = std::remainder(half_sum + half_difference, 2.0 * std::numbers::pi);
    angles.psi_rad = std::remainder(half_sum - half_difference, 2.0 * std::numbers::pi);
    return angles;
}

}  // namespace poinsot
