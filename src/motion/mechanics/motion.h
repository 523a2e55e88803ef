// The motion of a rigid body as an immutable value that can be evaluated at any instant.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>

#include "mechanics/free/free_rotation.h"
#include "mechanics/motion_problem.h"
#include "mechanics/regime.h"
#include "mechanics/rotation_state.h"
#include "mechanics/stepped/integrated_rotation.h"
#include "mechanics/stop_check.h"
#include "mechanics/top/heavy_top.h"

namespace poinsot {

// Chooses the regime once, at construction. Exact motions cost the same at every instant; stepped
// ones cover the problem's time span and throw InputError outside it.
class Motion {
 public:
    // Throws InputError for what cannot be computed: an unknown method (with the nearest), exact
    // with a torque that has no closed form (with the list of methods that can), a step that is not
    // positive, overflow of L or ω t; and if a stop is requested while it steps.
    explicit Motion(const MotionProblem& problem, const StopCheck& stop = {});

    // Throw InputError for a time that the motion does not reach, and where a quantity lies beyond
    // the range of double: what they return is finite.
    RotationState at(double time_s) const;
    MotionSample sample(double time_s, const Quantities& wanted) const;

    Regime regime() const;

    // Whether an evaluation sums the theta series of the closed forms: see FreeRotation. A heavy
    // top always does, a stepped motion never.
    bool sums_theta_series() const;

    // The constants of a torque-free motion, by whatever method it is computed. Precondition: the
    // problem has no torque.
    FreeRotationConstants free_constants() const;

    // The closed form of a heavy symmetric top, by whatever method the motion is computed; none for
    // other bodies and torques.
    std::optional<HeavyTop> closed_form_of_top() const;

    // The solution as a FreeRotation, for the functions that only it has; null for other solutions.
    const FreeRotation* free_rotation() const { return std::get_if<FreeRotation>(&solution_); }
    const HeavyTop* heavy_top() const { return std::get_if<HeavyTop>(&solution_); }
    const IntegratedRotation* integrated() const {
        return std::get_if<IntegratedRotation>(&solution_);
    }

    const MotionProblem& problem() const { return problem_; }

 private:
    MotionProblem problem_;
    std::variant<FreeRotation, HeavyTop, IntegratedRotation> solution_;
};

}  // namespace poinsot
