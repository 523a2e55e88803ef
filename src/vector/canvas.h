// The shared state while one view is drawn on a sheet of paper, and the functions that draw it. The
// order is that of render/: background, planes, bodies, ellipsoids, cones, hidden parts of arrows,
// curves, arrows, type.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vector/conic.h"
#include "vector/light.h"
#include "vector/occluders.h"
#include "vector/paper_flow.h"
#include "vector/sheet_of_paper.h"

namespace poinsot::vector {

// How surfaces are filled.
enum class Shading {
    none,    // lines only: the classical figure
    tone,    // shaded colours
    picture  // pixels from an external renderer, clipped by the outlines
};

// Largest deviation of a path from the exact curve: 1 µm for a conic, 1.5 µm for other curves, plus
// at most 0.3 µm for the cubic form of a curve.
constexpr double um_per_pt = 25400.0 / 72.0;
constexpr double conic_tolerance_pt = 1.0 / um_per_pt;
constexpr double curve_tolerance_pt = 1.5 / um_per_pt;
constexpr double form_tolerance_pt = 0.3 / um_per_pt;

// AIP, APS, MAA: no line thinner than half a point.
constexpr double least_line_pt = 0.5;

// Contours of surfaces that are not filled.
constexpr double contour_pt = 0.8;

// An ellipsoid as a translucent sheet over everything behind it.
struct LitSheet {
    std::size_t number = 0;
    PaperEllipse outline;
    ShadedDisc disc;  // only where there are fills
};

struct Canvas {
    Canvas(const Drawing& drawing, const View& view, double pt_per_px, Shading shading,
           SheetOfPaper& paper);

    // What is added next belongs to this shape.
    void enter(const ShapeName& name, std::string_view part = {}) const {
        paper.enter_group(id_of(name, part));
    }
    // The id of a shape, or of a part of it, such as "axes-2-head"; ends in the panel's name if the
    // picture has several panels. Empty for a shape without a name.
    std::string id_of(const ShapeName& name, std::string_view part = {}) const;

    // The colour behind a point on the paper: background, planes, bodies and ellipsoids drawn so
    // far.
    Colour behind(const Eigen::Vector2d& at) const;
    // The same with background and planes only.
    Colour ground(const Eigen::Vector2d& at) const;
    double pt(double px) const { return px * projection.units_per_px; }
    // The width of a line, increased to the minimum for print.
    double line_pt(double px) const { return px > 0.0 ? std::max(pt(px), least_line_pt) : 0.0; }
    void add(Item item) const { paper.add(std::move(item)); }
    // A part of a track as Béziers. Increases the sheet's deviation bound to that of the Béziers
    // plus track_off_pt, the track's own deviation.
    Path path_of(const Track& track, double from, double to, double tolerance_pt,
                 double track_off_pt = 0.0) const;
    Path path_of(const PaperEllipse& ellipse) const;
    // Begins a clip to the inside or the outside of an outline.
    ClipBegin clip_to(const PaperEllipse& outline, bool within) const;

    const Drawing& drawing;
    const View& view;
    Projection projection;
    Occluders occluders;
    Lights lights;
    Shading shading;
    SheetOfPaper& paper;
    std::string panel;  // the panel's id; empty if the picture has only one
    bool has_fills() const { return shading == Shading::tone; }
    // A span of a track drawn in one colour, sampled at its midpoint.
    struct ConstantColourSpan {
        double from = 0.0, to = 0.0;
        PaperInk ink;
    };
    // The appearance of a line at a parameter: its colour and opacity in light, and the colour
    // behind it.
    struct LineLook {
        Colour colour;
        double opacity = 1.0;
        Colour behind;
    };
    // Divides [from, to] into spans of one ink each, which deviates nowhere by more than six of 255
    // levels from the exact ink. The inks have the requested opacity or, for translucent lines, may
    // be shades, whichever needs fewer spans. Nearly opaque spans overlap a little, so that no seam
    // is visible between them.
    std::vector<ConstantColourSpan> constant_colour_spans(
        const Track& track, double from, double to,
        const std::function<LineLook(double)>& look_at) const;

    // The progress of drawing, for behind().
    std::size_t n_planes = 0;
    bool bodies = false;
    std::vector<std::size_t> ellipsoids;  // numbers of the ellipsoids drawn
    std::vector<LitSheet> sheets;         // all ellipsoids, in drawing order
};

// canvas.cpp
void draw_background(const Background& background, const Eigen::Vector2d& corner_pt,
                     const Eigen::Vector2d& size_pt, SheetOfPaper& paper);
// surfaces.cpp
// Renders a drawing to pixels of the size that it gives.
using DrawPixels = std::function<Raster(const Drawing& drawing)>;
// Draw surfaces in pixels of at least 600 per inch: first everything around the ellipsoids, which
// are slightly smaller there; then the ellipsoids, slightly larger, clipped by their outlines.
void draw_ground_pixels(const Canvas& canvas, const DrawPixels& draw);
void draw_ellipsoid_pixels(const Canvas& canvas, const DrawPixels& draw);
// plane.cpp
bool is_before_solids(const Canvas& canvas, const Plane& plane);
void draw_plane(const Canvas& canvas, const Plane& plane);
// shadow.cpp
void draw_shadow(const Canvas& canvas, const Plane& plane, std::size_t caster);
// The colour of a point of a plane in the shadows of all ellipsoids.
Colour shadowed(const Canvas& canvas, const Plane& plane, const Eigen::Vector3d& point,
                const Colour& colour);
// ellipsoid.cpp
// Fills canvas.sheets with the ellipsoids in this order, which starts with the farthest.
void light_sheets(Canvas& canvas, const std::vector<std::size_t>& order);
void draw_ellipsoid(const Canvas& canvas, const LitSheet& sheet);
// Linear light from `under` after passing the ellipsoids' surfaces, from back to front whichever
// ellipsoid they belong to, so that intersecting ellipsoids hide parts of each other. Surfaces at
// `depth` and beyond are ignored.
Eigen::Vector3d through_ellipsoids(const Canvas& canvas, const std::vector<std::size_t>& numbers,
                                   const Eigen::Vector2d& at, const Eigen::Vector3d& under,
                                   double depth = std::numeric_limits<double>::infinity());
// The colour in which an opaque point must be drawn to have the right colour after the sheets have
// been drawn over it: sheets blend encoded colours, and cover points in front of them, too.
Colour under_sheets(const Canvas& canvas, const Eigen::Vector3d& point, const Colour& colour);
// bodies.cpp
void draw_meshes(const Canvas& canvas);
// The body visible at a point of the paper, with its shaded colour.
struct BodySeen {
    Colour colour;
    double depth = 0.0;
};
std::optional<BodySeen> body_at(const Canvas& canvas, const Eigen::Vector2d& at);
// face_picture.cpp
// Draws the picture on a mesh's faces, in pixels, over the fill of the visible parts.
using IsHidden = std::function<bool(const Eigen::Vector3d& point)>;
void draw_face_picture(const Canvas& canvas, const MeshSight& body, const IsHidden& is_hidden);
void draw_cone(const Canvas& canvas, const Cone& cone);
// curves.cpp
void draw_curve(const Canvas& canvas, const Curve& curve);
// arrows.cpp
enum class ArrowLayer { hidden, visible };
void draw_arrows(const Canvas& canvas, ArrowLayer layer);
// type.cpp
void draw_label(const Canvas& canvas, const Label& label);
// Whether the label is omitted together with the hidden point that it names.
bool is_omitted(const Canvas& canvas, const Label& label);

}  // namespace poinsot::vector
