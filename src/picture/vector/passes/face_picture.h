// Pictures on the faces of bodies.
#pragma once

#include <functional>

#include "vector/canvas.h"

namespace poinsot::vector {

// Draws the picture on a mesh's faces, in pixels, over the fill of the visible parts.
using IsHidden = std::function<bool(const Eigen::Vector3d& point)>;
void draw_face_picture(const Canvas& canvas, const MeshSight& body, const IsHidden& is_hidden);

}  // namespace poinsot::vector
