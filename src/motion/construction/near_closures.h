// Loops near a motion: fractions p/q with small q that lie near the herpolhode's advance in one
// polhode period, and the small changes of the start that make it close so.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "construction/closed_herpolhode.h"
#include "mechanics/inertia.h"

namespace poinsot {

// The convergents p/q of a number of turns, from the smallest q: each is nearer than every other
// fraction with at most its q. With 1 ≤ p and q ≤ most_periods.
std::vector<Closure> convergents(double turns, int most_periods);

struct NearClosure {
    Closure closure;
    ClosedStart start;
    double relative_change = 0.0;  // of ω, in |ω|
};

// The convergents of the motion's advance that close_herpolhode reaches; empty for a motion without
// a polhode period. `omega_body`: rad/s.
std::vector<NearClosure> near_closures(const InertiaTensor& inertia,
                                       const Eigen::Vector3d& omega_body, int most_periods);

}  // namespace poinsot
