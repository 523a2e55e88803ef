// Objects drawn with a width in pixels: curves, arrows and dots.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "shapes/colour.h"
#include "shapes/shape_name.h"
#include "shapes/smooth_form.h"

namespace poinsot {

// The points of a curve, made once and shared by all video frames. Owned by the stage, which
// outlives its drawings. `id` is unique in the process, so that a renderer can cache the uploaded
// geometry.
struct CurveGeometry {
    std::uint64_t id = 0;
    std::vector<Eigen::Vector3d> points;
    bool closed = false;  // the last point is joined to the first, which is not repeated
    // Makes the smooth form, for renderers that draw curves instead of points; empty if only the
    // points exist.
    SmoothMaker smooth{};
};

enum class Occlusion {
    none,      // always drawn in full, on top of everything
    by_solids  // parts behind or inside an ellipsoid, mesh or plane are drawn in the hidden style
};

enum class HiddenStyle { dimmed, dashed, absent };

// A line of constant width in pixels along a part of a geometry, with round joins and caps.
struct Curve {
    const CurveGeometry* geometry = nullptr;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();  // view axes from the geometry's axes
    double first =
        0.0;  // the range drawn, in points (fractions cut a segment); first > last draws nothing
    double last = 1e300;  // clamped to the number of points
    double width_px = 3.0;
    Colour colour;
    double opacity = 1.0;
    double hidden_opacity = 0.3;
    HiddenStyle hidden = HiddenStyle::dimmed;
    double hidden_share =
        0.65;                  // of the width, where hidden and dashed: dashes are longer than wide
    double dash_px = 0.0;      // length of a dash; 0: solid
    double gap_px = 0.0;       // between dashes; 0: equal to dash_px
    double fade_points = 0.0;  // opacity rises linearly from 0, this many points before `last`, to
                               // that at `last`; 0: constant opacity
    double fade_end = 0.0;     // of a part of a fading curve: the `last` of the whole; else 0
    Occlusion occlusion = Occlusion::by_solids;
    int on_surface = -1;  // index of the ellipsoid of this view on which the curve lies; it is
                          // visible where the surface faces the eye
    int on_plane = -1;    // index of the plane on which the curve lies
    // Whether the curve is the axis or the outline of an arrow, which covers it where the arrow is
    // visible; renderers may leave it out there.
    bool stands_for_hidden = false;
    bool lasting = false;  // whether only `last` changes from picture to picture
    ShapeName name{};
};

// A straight arrow with a shaded round shaft and a conical head. `arrow_between` in the drawing
// layer chooses the sizes.
struct Arrow {
    Eigen::Vector3d tail = Eigen::Vector3d::Zero();
    Eigen::Vector3d tip = Eigen::Vector3d::UnitZ();
    Colour colour;
    double shaft_px = 0.0;  // full width
    double head_px = 0.0;   // full width of the head's base
    double head_length_px = 0.0;
    double dash_px = 0.0;  // length of a dash of the shaft; 0: solid. Renderers receive a dashed
                           // arrow as one arrow per dash
    double opacity = 1.0;
    double hidden_opacity = 0.45;  // below 0: omitted where hidden
    Occlusion occlusion = Occlusion::by_solids;
    ShapeName name{};
};

// A dot with a rim: contact point, point masses.
struct Dot {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double radius_px = 6.0;
    Colour colour;
    Colour rim_colour{1.0, 1.0, 1.0};
    double rim_px = 1.5;
    double opacity = 1.0;
    double hidden_opacity = 0.4;  // below 0: omitted where hidden
    Occlusion occlusion = Occlusion::by_solids;
    ShapeName name{};
};

// The curves, arrows and dots of a view; used like SolidLists.
struct LineLists {
    std::vector<Curve> curves;
    std::vector<Arrow> arrows;
    std::vector<Dot> dots;
};
template <typename Function>
void for_each(LineLists& lists, const Function& function) {
    function(lists.curves);
    function(lists.arrows);
    function(lists.dots);
}

}  // namespace poinsot
