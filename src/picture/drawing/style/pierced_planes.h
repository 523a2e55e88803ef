// Arrows that pierce a plane: what lies beyond the plane looks beyond it.
#pragma once

#include "drawing/style/line_style.h"
#include "shapes/views.h"

namespace poinsot {

// Where an arrow's tip lies on the far side of a plane, dashes the shaft of the part beyond the
// plane and lets it show through the plane in full, as far as the plane is seen there. Adds an open
// ring on the plane around the shaft, except where a dot marks the point.
void pierce_planes(const LineStyleRules& rules, View& view);

// Pixels per view unit, at the depth at which the sizes of arrows apply.
double unit_px_of(const View& view);

}  // namespace poinsot
