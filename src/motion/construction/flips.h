// The flips of a body that turns about its middle axis: the instants at which ω along this axis
// changes its sign (the tennis racket, the Dzhanibekov effect).
#pragma once

#include <optional>
#include <vector>

#include "mechanics/free/free_rotation.h"
#include "mechanics/motion_problem.h"

namespace poinsot {

struct Flips {
    int axis = 1;                      // principal axis of the middle moment
    double one_s = 0.0;                // the instant of the one nearest to the start
    std::optional<double> interval_s;  // between two; none on the separatrix, where there is one

    // Those between two instants, in order, and at most so many of them.
    std::vector<double> between(double first_s, double last_s, int most) const;
};

// Within this angle of the middle axis ω must come, so that a change of its sign is a flip and not
// part of a wobble about another axis.
constexpr double flip_angle_rad = 0.5;

// The flips of a torque-free motion with these constants; nothing if it has none.
std::optional<Flips> flips_of(const MotionProblem& problem, const FreeRotationConstants& constants);

}  // namespace poinsot
