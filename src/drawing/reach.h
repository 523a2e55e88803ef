// How far in the picture an error of the motion can carry anything drawn.
#pragma once

#include "scene/scene.h"

namespace poinsot {

// Pixels by which the tip of the longest thing that turns moves for an attitude wrong by one radian
// (small errors), in a space panel that fills the film's picture.
double pixels_per_radian(const Scene& scene);

}  // namespace poinsot
