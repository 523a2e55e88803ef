// How long stepping a motion will take on this machine.
#pragma once

#include "mechanics/motion_problem.h"

namespace poinsot {

// Upper limit of the time for stepping; estimates above it are rejected.
#ifdef __wasm__
inline constexpr double longest_stepping_s = 20.0;  // a page does nothing else meanwhile
#else
inline constexpr double longest_stepping_s = 600.0;
#endif

// CPU time of this thread: an estimate does not depend on other load.
double thread_processor_s();

// Estimates the seconds that integrating over a problem's span takes on this machine, by timing a
// few milliseconds of it, with at most a fixed number of steps. Returns 0 for a method without
// steps, and if the method refuses the problem within those steps.
double stepping_estimate_s(const MotionProblem& problem, double (*clock_s)() = thread_processor_s);

}  // namespace poinsot
