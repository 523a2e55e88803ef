// Cones: their two sheets, rims and generators.
#pragma once

#include "vector/canvas.h"

namespace poinsot::vector {

void draw_cone(const Canvas& canvas, const Cone& cone);

}  // namespace poinsot::vector
