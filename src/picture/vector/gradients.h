// A lit surface on paper as few linear gradients, which PDF and SVG have and every program draws
// smoothly. SVG has no gradients over meshes, and some programs draw those of PDF in terraces.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vector/sheet_of_paper.h"

namespace poinsot::vector {

// A triangle of a lit surface; the colour is linear between the corners.
struct ShadedTriangle {
    Eigen::Vector2d corners[3];
    Colour colours[3];
    int layer = 0;  // triangles of a higher layer are drawn later
};

// A deviation of a colour that is not seen where two gradients meet.
constexpr double least_shade = 1.5 / 255.0;

// Fills that cover the triangles in the order of their layers. In a layer they must not overlap:
// neighbours are filled together as long as one linear gradient has the colours of all their
// corners within `most_off` of each component; within up to six times as much on details smaller
// than four points. If there are more fills than `wanted_fills`, the deviation grows, to 10/255 at
// most.
std::vector<Fill> gradient_fills(std::span<const ShadedTriangle> triangles, double most_off,
                                 std::size_t wanted_fills);

}  // namespace poinsot::vector
