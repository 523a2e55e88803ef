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

    // The next items belong to this shape.
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

void draw_background(const Background& background, const Eigen::Vector2d& corner_pt,
                     const Eigen::Vector2d& size_pt, SheetOfPaper& paper);

}  // namespace poinsot::vector
