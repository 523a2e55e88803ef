// Shadows of ellipsoids on planes.
#pragma once

#include "vector/canvas.h"

namespace poinsot::vector {

void draw_shadow(const Canvas& canvas, const Plane& plane, std::size_t caster);
// The colour of a point of a plane in the shadows of all ellipsoids.
Colour shadowed(const Canvas& canvas, const Plane& plane, const Eigen::Vector3d& point,
                const Colour& colour);

}  // namespace poinsot::vector
