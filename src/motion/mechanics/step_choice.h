// Chooses the step or tolerance of a stepped method from how accurate its attitude must be.
#pragma once

#include <string>

#include "mechanics/motion.h"
#include "mechanics/stop_check.h"

namespace poinsot {

inline constexpr double most_chosen_steps = 4e6;

struct StepChoice {
    MethodChoice method;        // with step_s or tolerance filled in
    double attitude_rad = 0.0;  // worst error measured over the problem's span at that choice; 0
                                // for an exact method
    bool reached = true;        // whether that error is within the requested tolerance
};

// The largest step (or tolerance) of a geometric ladder whose worst attitude error over the
// problem's time span stays within `attitude_tolerance_rad`. Measured against the exact motion
// where one exists, otherwise against the same method at the next rung. A choice that names its
// step or tolerance is kept and measured in the same way; an exact method is returned as it is. If
// no rung of at most `most_steps` steps, or of a tolerance that rounding leaves room for, reaches
// it, the finest is returned with reached = false. Steps are counted, not timed: every machine
// chooses alike. Throws InputError as Motion does.
StepChoice choose_step(const MotionProblem& problem, double attitude_tolerance_rad,
                       double most_steps = most_chosen_steps, const StopCheck& stop = {});

// The coarsest rung, for a choice that names neither step nor tolerance. Precondition: the body
// turns, and the method steps.
MethodChoice coarsest_choice(const MotionProblem& problem);

}  // namespace poinsot
