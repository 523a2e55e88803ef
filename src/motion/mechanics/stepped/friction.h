// Motion under internal friction: L is constant in space, so only the attitude is integrated
// and ω follows from it. The energy is integrated separately, and never grows.
#pragma once

#include "mechanics/methods.h"

namespace poinsot {

// The excess X of T over the least energy that L allows decays at the rate λ = −d(ln X)/dt ≥ 0. A
// method sums λ over its step as it sums the rotation; then a small rotation corrects the attitude
// to the energy X exp(−Σλh). Backwards in time, the distance from the greatest energy decays
// instead.
//
// λ ≥ 0 at every stage, so with positive weights the energy at the end of a step is not above that
// at its start, however long the step.
class Friction {
 public:
    // The direction of time is that of start.step_s.
    explicit Friction(const MethodStart& start);

    // Whether there is internal friction; the rest is meaningless otherwise.
    bool acts() const { return acts_; }

    // L in principal axes of an attitude, a quaternion of any length but 0, in kg m²/s.
    Eigen::Vector3d momentum_at(const Eigen::Quaterniond& space_from_principal) const;
    // λ of a momentum, in 1/s.
    double decay_1_s(const Eigen::Vector3d& momentum) const;
    bool backwards() const { return backwards_; }
    // Angle in rad by which the body must turn, along the steepest descent, to reduce ln X by one:
    // it converts an error of the decay to an error of the attitude. 0 where friction has no
    // effect.
    double turn_of_decay_rad(const Eigen::Vector3d& momentum) const;
    // The end of a step whose attitude is not yet corrected to its energy; `decay` is the sum of
    // λ|h|.
    StepState settled(const StepState& start, const Eigen::Quaterniond& attitude,
                      double decay) const;

 private:
    Eigen::Vector3d direction_at(const Eigen::Quaterniond& space_from_principal) const;

    bool acts_ = false;
    bool backwards_ = false;
    double momentum_ = 0.0;                                      // |L|
    Eigen::Vector3d direction_space_ = Eigen::Vector3d::Zero();  // of L
    // The energy of each axis relative to the range: 0 for the axis that the spin approaches, 1 for
    // the axis that it leaves. All 0 for a sphere.
    Eigen::Vector3d weight_ = Eigen::Vector3d::Zero();
    double strength_1_s_ = 0.0;  // 2κ (1/I_min − 1/I_max)
};

}  // namespace poinsot
