// Rules for all lines of a view, whichever element draws them: style of hidden lines, gaps at
// crossings, and least width.
#pragma once

#include <string_view>

#include "shapes/views.h"

namespace poinsot {

struct LineStyleRules {
    std::string_view hidden = "pale";            // as the scene's `hidden`
    std::string_view hidden_arrows = "pale";     // as the scene's `hidden_arrows`
    std::string_view crossings = "through";      // as the scene's `crossings`
    double px = 1.0;                             // pixels of the picture for one pixel at 1080 rows
    double least_px = 0.0;                       // a line's least width; 0: no limit
    const CurveGeometry* unit_circle = nullptr;  // about z, from x towards y
    const CurveGeometry* unit_segment = nullptr;  // from the origin to x
};

// Applies the rules to a view's lines. When hidden lines are dashed, all other dashed lines become
// thin solid lines. The principal sections of an ellipsoid become curves on it. An arrow with a
// dashed shaft becomes one arrow per dash, the last of them with the head.
void apply_line_style(const LineStyleRules& rules, View& view);

}  // namespace poinsot
