// Attitude and angular velocity at an instant, and the quantities that a motion can compute.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "numerics/power_of_two.h"

namespace poinsot {

// Attitude and angular velocity at one instant.
struct RotationState {
    double time_s = 0.0;
    Eigen::Quaterniond space_from_body =
        Eigen::Quaterniond::Identity();  // unit; v_space = space_from_body * v_body
    Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  // rad/s, body axes
};

// z-x-z Euler angles R = Rz(φ) Rx(θ) Rz(ψ), φ and ψ unwrapped (continuous in time).
struct EulerAngles {
    double theta_rad = 0.0;
    double phi_rad = 0.0;
    double psi_rad = 0.0;
};

// The quantities that one evaluation computes; others are left out.
struct Quantities {
    bool attitude = true;
    bool herpolhode = false;
    bool euler_angles = false;
};

// ω's component perpendicular to L: ω − L (ω·L)/L² = (L × ω) × L/L², and L × ω vanishes with the
// differences of the moments, so that nothing cancels for small wobbles. L is scaled by a power of
// two, because its square may over- or underflow.
inline Eigen::Vector3d omega_across_momentum(const Eigen::Vector3d& momentum,
                                             const Eigen::Vector3d& omega) {
    const double largest = momentum.cwiseAbs().maxCoeff();
    if (!(largest > 0.0)) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d scaled = ldexp(momentum, -exponent_of(largest));
    return scaled.cross(omega).cross(scaled) / scaled.squaredNorm();
}

struct MotionSample {
    RotationState state;  // the attitude is the identity when it was not requested
    Eigen::Vector3d herpolhode_space =
        Eigen::Vector3d::Zero();  // component of ω perpendicular to L, rad/s, space axes
    EulerAngles euler;
};

}  // namespace poinsot
