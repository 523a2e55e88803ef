// Planes: discs that fade out towards their edge, with their grids.
#pragma once

#include "vector/canvas.h"

namespace poinsot::vector {

bool is_before_solids(const Canvas& canvas, const Plane& plane);
void draw_plane(const Canvas& canvas, const Plane& plane);

}  // namespace poinsot::vector
