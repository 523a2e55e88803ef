// Functions shared by all passes over curves: the drawn range, its dashes, and the program that
// draws a rectangle around every segment.
#pragma once

#include <string>
#include <vector>

#include "render/passes/curve_store.h"
#include "render/passes/program.h"
#include "render/view_scene.h"

namespace poinsot {

// The drawn range of a curve: points from first to last, and the segments that contain them.
struct ShownRange {
    double first = 0.0, last = 0.0;
    int first_segment = 0, end_segment = 0;
    bool empty() const { return first_segment >= end_segment; }
};
ShownRange range_of(const Curve& curve);

// Whether any part of the curve is drawn.
bool shows(const Curve& curve);

// Dashes as in shaders/stroke.glsl: period in lengths of the curve (0: solid; below 0: dashed only
// where hidden), and the drawn share of the period.
struct StrokeDashes {
    double period = 0.0, share = 1.0;
    bool operator==(const StrokeDashes&) const = default;
};
// length: of the whole curve.
StrokeDashes dashes_of(const ViewScene& scene, const Curve& curve, double length);

// The ellipsoid on which the curve lies, if it hides other objects; else null.
const Quadric* surface_of(const ViewScene& scene, const Curve& curve);

// A segment as input of the shader.
struct StrokeEnds {
    Eigen::Vector2d from_px, to_px;
    double depth_from = 1.0, depth_to = 1.0;
    double facing_from = 1.0, facing_to = 1.0;
    double length_from = 0.0, length_to = 0.0;
};

// A program that draws segments with shaders/curve.vert.
class StrokeProgram : public ConstantProgram {
 public:
    StrokeProgram(std::string_view fragment, int n_constants,
                  const std::vector<std::string>& defines);

    // Draws the segments of a range, in rectangles for a stroke of this width.
    void draw(const ViewScene& scene, const Curve& curve, const ShownRange& range, double width_px,
              const Constants& constants, CurveStore& store) const;
    // Draws rectangles for this segment and the cached part of the others.
    void draw(const ViewScene& scene, const StrokeEnds& ends, const std::vector<PixelRect>& rects,
              const Constants& constants, CurveStore& store) const;

 private:
    GLint n_points_, closed_, stroke_, on_ellipsoid_, in_rectangles_;
};

}  // namespace poinsot
