// Ellipsoids: translucent sheets with lines, and the colours seen through them.
#pragma once

#include <limits>
#include <vector>

#include "vector/canvas.h"

namespace poinsot::vector {

// Fills canvas.sheets with the ellipsoids in this order, which starts with the farthest.
void light_sheets(Canvas& canvas, const std::vector<std::size_t>& order);
void draw_ellipsoid(const Canvas& canvas, const LitSheet& sheet);
// Linear light from `under` after passing the ellipsoids' surfaces, from back to front whichever
// ellipsoid they belong to, so that intersecting ellipsoids hide parts of each other. Surfaces at
// `depth` and beyond are ignored.
Eigen::Vector3d through_ellipsoids(const Canvas& canvas, const std::vector<std::size_t>& numbers,
                                   const Eigen::Vector2d& at, const Eigen::Vector3d& under,
                                   double depth = std::numeric_limits<double>::infinity());
// The colour in which an opaque point must be drawn to have the right colour after the sheets have
// been drawn over it: sheets blend encoded colours, and cover points in front of them, too.
Colour under_sheets(const Canvas& canvas, const Eigen::Vector3d& point, const Colour& colour);

}  // namespace poinsot::vector
