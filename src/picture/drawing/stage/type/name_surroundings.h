// Shapes and labels that a name keeps away from, and the cost of a place among them.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "drawing/stage/type/named_thing.h"
#include "shapes/views.h"

namespace poinsot {

struct Surroundings {
    std::vector<LabelBox> labels;
    struct Shaft {
        Eigen::Vector2d tail, tip;
        double head_px, opacity;
    };
    std::vector<Shaft> shafts;
    // Of all curves, with those of the thing itself marked by their names.
    struct Line {
        Eigen::Vector2d a, b;
        std::string_view element, part;
        double weight = 1.0;  // of a curve's hidden part: less
    };
    std::vector<Line> lines;
    const View* view = nullptr;
    double margin_px = 6.0;
};

// `overlays`: boxes of text besides the view's labels; `margin_px`: from the edges of the view,
// which must live as long.
Surroundings surroundings_of(const View& view, const std::vector<LabelBox>& overlays,
                             double margin_px);

// The cost of a place for a name: 0 for a free one, about 2 for one on a line, and 8 on another
// label. `em_px`: of the name's letters.
double cost_of(const LabelBox& box, const Surroundings& around, const NamedThing& thing,
               double em_px);

// The share by which a label, an arrowhead or the edge of the view covers a box, 0…1: a step, but
// for a little of the letters' size, so that a name fades quickly.
double covered_share(const LabelBox& box, const Surroundings& around, double em_px);

}  // namespace poinsot
