// Curves with their dashes.
#pragma once

#include "vector/canvas.h"

namespace poinsot::vector {

void draw_curve(const Canvas& canvas, const Curve& curve);

}  // namespace poinsot::vector
