// What the numbers given can tell of a free motion.
#pragma once

#include "mechanics/inertia.h"
#include "mechanics/rotation_state.h"

namespace poinsot {

// How far the attitude at time_s moves, in rad, when one principal moment or one component of ω
// changes by one unit in its last place: the largest of the six. What the numbers given cannot
// tell.
double attitude_conditioning_rad(const InertiaTensor& inertia, const RotationState& start,
                                 double time_s);

}  // namespace poinsot
