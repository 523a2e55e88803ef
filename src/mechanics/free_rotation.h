// The torque-free rotation of a rigid body, exact at any instant: Jacobi's solution by theta
// functions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "mechanics/inertia.h"
#include "mechanics/regime.h"
#include "mechanics/rotation_state.h"

namespace poinsot {

// Constants of a torque-free motion. What a regime does not have is empty: no period is listed on
// the separatrix (it is infinite), in permanent rotation or at rest.
struct FreeRotationConstants {
    double kinetic_energy_J = 0.0;  // T; infinite or zero where a double cannot hold it
    double momentum_kg_m2_s = 0.0;  // |L|
    Eigen::Vector3d momentum_space = Eigen::Vector3d::Zero();  // L, kg m²/s, space axes
    int encircled_axis = 2;              // index of the principal axis that the polhode encircles
    double modulus = 0.0;                // k of the Jacobi functions
    double complementary_modulus = 1.0;  // k′, not formed from k: accurate when tiny
    std::optional<double> polhode_period_s;        // time in which ω returns in body axes
    double mean_advance_rate_rad_s = 0.0;          // mean rate of ω about L, space axes
    std::optional<double> advance_per_period_rad;  // herpolhode's angle in one polhode period
    // Least and greatest |ω perpendicular to L|, rad/s.
    double least_herpolhode_radius_rad_s = 0.0;
    double greatest_herpolhode_radius_rad_s = 0.0;
};

// Immutable; every instant costs the same.
class FreeRotation {
 public:
    // From a state at start.time_s. Throws InputError if ω or the attitude is not finite, if the
    // attitude is zero, or if L overflows.
    FreeRotation(const InertiaTensor& inertia, const RotationState& start);

    // Throws InputError if ω t overflows.
    RotationState at(double time_s) const;
    // Euler angles are those of the attitude, z-x-z, φ and ψ in (−π, π], not unwrapped.
    MotionSample sample(double time_s, Quantities wanted) const;

    Regime regime() const { return regime_; }
    const FreeRotationConstants& constants() const { return constants_; }

 private:
    struct Frame;
    Frame frame(long double time_s) const;
    Frame trigonometric_frame(long double time_s, long double cycles, bool odd) const;

    Regime regime_ = Regime::at_rest;
    FreeRotationConstants constants_;
    InertiaTensor inertia_;
    RotationState start_;
    std::array<int, 3> axis_{0, 1, 2};
    std::array<long double, 3> sign_{1, 1, 1};
    std::array<long double, 3> amplitude_{0, 0, 0};
    std::array<long double, 3> moments_{1, 1, 1};
    std::array<long double, 3> delta_{0, 0, 0};
    std::array<long double, 4> frame_from_start_{1, 0, 0, 0};
    long double L_ = 0, lambda_ = 0, u0_ = 0, K_ = 0, Kp_ = 0, s_ = 1, mean_rate_ = 0, F_ = 0;
};

}  // namespace poinsot
