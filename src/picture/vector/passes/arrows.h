// Arrows, in two layers: behind the ellipsoids and in front of them.
#pragma once

#include "vector/canvas.h"

namespace poinsot::vector {

enum class ArrowLayer { hidden, visible };
void draw_arrows(const Canvas& canvas, ArrowLayer layer);

}  // namespace poinsot::vector
