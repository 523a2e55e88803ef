// The outline of a glyph: closed contours of lines and cubic curves, in any unit, y up.
#pragma once

#include <vector>

namespace poinsot {

struct OutlinePoint {
    double x = 0.0, y = 0.0;
};

struct OutlineStep {
    enum class Kind { move, line, cubic };
    Kind kind = Kind::move;
    OutlinePoint control_1, control_2;  // of a cubic curve
    OutlinePoint to;
};

// Each contour begins with a move and is closed implicitly.
struct GlyphOutline {
    std::vector<OutlineStep> steps;
    // Bounding box of the points and control points; it contains the shape.
    double min_x = 0.0, min_y = 0.0, max_x = 0.0, max_y = 0.0;
};

// Makes an outline from its steps and computes the bounding box.
GlyphOutline make_outline(std::vector<OutlineStep> steps);

}  // namespace poinsot
