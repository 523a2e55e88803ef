// Bodies made of triangles.
#pragma once

#include <optional>

#include "vector/canvas.h"

namespace poinsot::vector {

void draw_meshes(const Canvas& canvas);
// The body visible at a point of the paper, with its shaded colour.
struct BodySeen {
    Colour colour;
    double depth = 0.0;
};
std::optional<BodySeen> body_at(const Canvas& canvas, const Eigen::Vector2d& at);

}  // namespace poinsot::vector
