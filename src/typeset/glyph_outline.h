// A glyph's shape: closed contours of straight and cubic steps, in any unit, y up.
#pragma once

#include <vector>

namespace poinsot {

struct OutlinePoint {
    double x = 0.0, y = 0.0;
};

struct OutlineStep {
    enum class Kind { move, line, cubic };
    Kind kind = Kind::move;
    OutlinePoint control_1, control_2;  // of a cubic
    OutlinePoint to;
};

// Contours begin with a move and close by themselves.
struct GlyphOutline {
    std::vector<OutlineStep> steps;
    // Box of the points and control points, which holds the shape.
    double min_x = 0.0, min_y = 0.0, max_x = 0.0, max_y = 0.0;
};

// The outline with its box, from its steps.
GlyphOutline make_outline(std::vector<OutlineStep> steps);

}  // namespace poinsot
