// Attitude and angular velocity at an instant, and what may be asked of a motion.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace poinsot {

// Attitude and angular velocity at one instant.
struct RotationState {
    double time_s = 0.0;
    Eigen::Quaterniond space_from_body =
        Eigen::Quaterniond::Identity();  // unit; v_space = space_from_body * v_body
    Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  // rad/s, body axes
};

// How a closed form carries its phases. exact: in two words, so that no digit is lost with time.
// fast: in one word, cheaper, with an error that grows by the rounding of a product: by at most
// 2π·2^−53 = 7e-16 rad a turn for the turning about L and as much for that along the polhode, which
// is at most half as fast where the other is fastest. Over families of bodies it grows by 2e-16 in
// the mean and 7e-16 at most.
enum class Tier { exact, fast };
inline constexpr double fast_tier_rad_a_turn = 1.05e-15;

// z-x-z Euler angles R = Rz(φ) Rx(θ) Rz(ψ), φ and ψ unwrapped (continuous in time).
struct EulerAngles {
    double theta_rad = 0.0;
    double phi_rad = 0.0;
    double psi_rad = 0.0;
};

// What is asked of one evaluation; what is not asked is not computed.
struct Quantities {
    bool attitude = true;
    bool herpolhode = false;
    bool euler_angles = false;
};

struct MotionSample {
    RotationState state;  // the attitude is the identity when it was not asked for
    Eigen::Vector3d herpolhode_space =
        Eigen::Vector3d::Zero();  // component of ω perpendicular to L, rad/s, space axes
    EulerAngles euler;
};

}  // namespace poinsot
