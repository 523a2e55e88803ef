// Montgomery's phase: the angle by which a free body has turned about L when its ω has returned in
// body axes, as a dynamic part less the solid angle that L encloses in the body.
#pragma once

#include <optional>

#include "mechanics/motion_problem.h"

namespace poinsot {

// The turn over one polhode period P: turned = dynamic − solid angle, as angles, not only modulo a
// whole turn. Source: R. Montgomery, Am. J. Phys. 59 (1991) 394.
struct MontgomeryPhase {
    double period_s = 0.0;
    // How far the body turns about L, from the closed form of the motion, in which no solid angle
    // occurs.
    double turned_rad = 0.0;
    double dynamic_rad = 0.0;  // 2TP/L
    // The part of the unit sphere that L/|L| encloses in body axes, on the side of the axis that it
    // encircles; negative if it moves clockwise, seen from outside.
    double solid_angle_rad = 0.0;
};

// None for a motion without such a period, or with a torque.
std::optional<MontgomeryPhase> montgomery_phase(const MotionProblem& problem);

}  // namespace poinsot
