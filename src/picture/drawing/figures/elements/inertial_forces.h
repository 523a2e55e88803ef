// The inertial forces on the point masses of a body, as arrows for the object panel.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "drawing/stage/stage_context.h"

namespace poinsot {

// The forces of all masses in one scale: the longest centrifugal force of the film is 1.25 times
// as long as the body's reach.
class InertialForces {
 public:
    // Throws InputError for a body that is not given as point masses, and for internal friction.
    InertialForces(const StageContext& stage, double reach_m);

    // Of one mass, body axes, in units of the reach: from the mass the centrifugal force, and from
    // the tip of that the Euler force, so that its tip is that of their sum.
    struct Arrows {
        Eigen::Vector3d mass, centrifugal_tip, euler_tip;
    };
    std::vector<Arrows> at(const RotationState& state) const;

 private:
    const StageContext* stage_;
    double reach_m_;
    double per_N_ = 0.0;
};

}  // namespace poinsot
