// One view on its way to the page: what all that draws it shares, and what draws it, in the order
// of render/: background, planes, bodies, ellipsoids, cones, arrows' hidden parts, curves, arrows,
// type.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vector/conic.h"
#include "vector/light.h"
#include "vector/occluders.h"
#include "vector/page.h"
#include "vector/paper_flow.h"

namespace poinsot::vector {

// How surfaces are filled.
enum class Shading {
    none,    // lines alone: the classical figure
    tone,    // colours that follow the light
    picture  // pixels of whoever draws them, clipped by the outlines
};

// No path lies further from what it draws than this: 1 µm of a conic, 1.5 µm of other curves, to
// which the form that the stage gives of a curve adds at most 0.3 µm.
constexpr double um_per_pt = 25400.0 / 72.0;
constexpr double conic_tolerance_pt = 1.0 / um_per_pt;
constexpr double curve_tolerance_pt = 1.5 / um_per_pt;
constexpr double form_tolerance_pt = 0.3 / um_per_pt;

// AIP, APS, MAA: no line under half a point.
constexpr double least_line_pt = 0.5;

// An ellipsoid as it is laid over what lies behind.
struct LitSheet {
    std::size_t number = 0;
    PaperEllipse outline;
    ShadedDisc disc;  // only where there are fills
};

struct Canvas {
    Canvas(const Drawing& drawing, const View& view, double pt_per_px, Shading shading, Page& page);

    // What lies behind a place on paper: background, planes, bodies, ellipsoids, as far as they are
    // drawn.
    Colour behind(const Eigen::Vector2d& at) const;
    // Of that, background and planes.
    Colour ground(const Eigen::Vector2d& at) const;
    double pt(double px) const { return px * projection.units_per_px; }
    // A line's width: none on paper is thinner than printers take.
    double line_pt(double px) const { return px > 0.0 ? std::max(pt(px), least_line_pt) : 0.0; }
    void add(Item item) const { page.add(std::move(item)); }
    // A part of a track as Béziers; the page's bound grows to theirs, and by how far the track
    // itself is from what it stands for.
    Path path_of(const Track& track, double from, double to, double tolerance_pt,
                 double track_off_pt = 0.0) const;
    Path path_of(const PaperEllipse& ellipse) const;
    // What lies within an outline, or outside of it.
    ClipBegin clip_to(const PaperEllipse& outline, bool within) const;

    const Drawing& drawing;
    const View& view;
    Projection projection;
    Occluders occluders;
    Lights lights;
    Shading shading;
    Page& page;
    bool has_fills() const { return shading == Shading::tone; }
    // A part of a track over which an ink may stay what it is in the middle.
    struct EvenPart {
        double from = 0.0, to = 0.0;
        Ink ink;
    };
    // What a line looks like at a parameter: its colour in light, and what it lies on.
    struct LineLook {
        Colour colour;
        double opacity = 1.0;
        Colour behind;
    };
    // [from, to] in parts whose ink is nowhere further than six levels of 255 from what it is to
    // make there: inks of the opacity asked for or, where it is pale, shades, whichever takes
    // fewer. Where it covers most of what lies behind, parts overlap by a little, so that no seam
    // is seen between them.
    std::vector<EvenPart> even_parts(const Track& track, double from, double to,
                                     const std::function<LineLook(double)>& look_at) const;

    // How far the picture has come, for behind().
    std::size_t n_planes = 0;
    bool bodies = false;
    std::vector<std::size_t> ellipsoids;  // numbers of those drawn
    std::vector<LitSheet> sheets;         // all there will be, in the order in which they are laid
};

// canvas.cpp
void draw_background(const Background& background, const Eigen::Vector2d& corner_pt,
                     const Eigen::Vector2d& size_pt, Page& page);
// surfaces.cpp
// Pixels of a drawing, as large as it says.
using DrawPixels = std::function<Raster(const Drawing& drawing)>;
// All that has a surface in pixels of 600 to an inch or more: what lies about the ellipsoids, which
// are a little smaller in it. Then these, a little larger, clipped by their outlines.
void draw_ground_pixels(const Canvas& canvas, const DrawPixels& draw);
void draw_ellipsoid_pixels(const Canvas& canvas, const DrawPixels& draw);
// plane.cpp
bool is_before_solids(const Canvas& canvas, const Plane& plane);
void draw_plane(const Canvas& canvas, const Plane& plane);
// shadow.cpp
void draw_shadow(const Canvas& canvas, const Plane& plane, std::size_t caster);
// The colour of a place of a plane in the shadows of all ellipsoids.
Colour shadowed(const Canvas& canvas, const Plane& plane, const Eigen::Vector3d& point,
                const Colour& colour);
// ellipsoid.cpp
// Makes canvas.sheets of the ellipsoids in this order, the farthest first.
void light_sheets(Canvas& canvas, const std::vector<std::size_t>& order);
void draw_ellipsoid(const Canvas& canvas, const LitSheet& sheet);
// Light that comes through ellipsoids from what lies behind them, their surfaces from the back to
// the front, whichever they belong to: two that cross hide parts of each other. Those at the depth
// of it, and beyond, let it pass.
Eigen::Vector3d through_ellipsoids(const Canvas& canvas, const std::vector<std::size_t>& numbers,
                                   const Eigen::Vector2d& at, const Eigen::Vector3d& under,
                                   double depth = std::numeric_limits<double>::infinity());
// The colour that an opaque point of this one needs to be seen as it is once the sheets lie over
// it: sheets mix encoded colours and cover points before them, too.
Colour under_sheets(const Canvas& canvas, const Eigen::Vector3d& point, const Colour& colour);
// bodies.cpp
void draw_meshes(const Canvas& canvas);
// The body seen at a place of the paper, as it is lit.
struct BodySeen {
    Colour colour;
    double depth = 0.0;
};
std::optional<BodySeen> body_at(const Canvas& canvas, const Eigen::Vector2d& at);
// face_picture.cpp
// The picture on a mesh's faces, in pixels, over what fills them, as far as they are not hidden.
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

}  // namespace poinsot::vector
