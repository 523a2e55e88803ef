// Surfaces as pixels of an external renderer, between vector lines.
#include "vector/passes/surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shapes/crop.h"

namespace poinsot::vector {

namespace {

constexpr double least_dots_per_inch = 600.0;
constexpr double pt_per_inch = 72.0;

// Pixels of the picture per pixel of the drawing.
int fineness(const Canvas& canvas) {
    const double dots_per_inch = pt_per_inch / canvas.projection.units_per_px;
    return std::max(1, static_cast<int>(std::ceil(least_dots_per_inch / dots_per_inch - 1e-9)));
}

// The factor on an ellipsoid's size that moves its outline this number of pixels outwards.
double grown(const Canvas& canvas, std::size_t number, double out_px, int fine) {
    const auto limb = limb_of(canvas.occluders.spheres()[number]);
    const auto outline = limb ? picture_of(*limb, canvas.projection) : std::nullopt;
    if (!outline) return 1.0;
    const double shorter_px =
        std::min(outline->a.norm(), outline->b.norm()) / canvas.projection.units_per_px * fine;
    return std::max(1.0 + out_px / std::max(shorter_px, 1.0), 0.5);
}

// A drawing of only the view's surfaces, with the view's corner as its corner.
Drawing surfaces_of(const Canvas& canvas, double out_px, bool has_grid) {
    const int fine = fineness(canvas);
    Drawing drawing;
    drawing.background = canvas.drawing.background;
    drawing.width_px = fine * canvas.drawing.width_px;
    drawing.height_px = fine * canvas.drawing.height_px;
    const View& from = canvas.view;
    View& view = drawing.views.emplace_back();
    view.x_px = fine * from.x_px;
    view.y_px = fine * from.y_px;
    view.width_px = fine * from.width_px;
    view.height_px = fine * from.height_px;
    view.camera = from.camera;
    view.light = from.light;
    view.background = from.background;
    view.planes = from.planes;
    view.ellipsoids = from.ellipsoids;
    view.cones = from.cones;
    view.meshes = from.meshes;
    for (Plane& plane : view.planes) plane.grid_px = has_grid ? fine * plane.grid_px : 0.0;
    for (std::size_t k = 0; k < view.ellipsoids.size(); ++k) {
        Ellipsoid& ellipsoid = view.ellipsoids[k];
        ellipsoid.section_px = ellipsoid.ruling_px = ellipsoid.contour_px = 0.0;
        ellipsoid.half_axes *= grown(canvas, k, out_px, fine);
    }
    for (Cone& cone : view.cones) {
        cone.rim_px = 0.0;
        cone.n_rulings = 0;
    }
    return cropped(drawing, {view.x_px, view.y_px, view.width_px, view.height_px});
}

void draw_pixels(const Canvas& canvas, const DrawPixels& draw, double out_px, bool has_grid) {
    Picture picture;
    picture.raster = draw(surfaces_of(canvas, out_px, has_grid));
    picture.corner_pt = canvas.projection.corner;
    picture.size_pt = canvas.projection.size;
    canvas.add(std::move(picture));
}

// More than the reach of an edge's anti-aliasing.
constexpr double edge_px = 1.5;

}  // namespace

void draw_ground_pixels(const Canvas& canvas, const DrawPixels& draw) {
    draw_pixels(canvas, draw, -edge_px, !canvas.view.meshes.empty());
}

void draw_ellipsoid_pixels(const Canvas& canvas, const DrawPixels& draw) {
    ClipBegin clip;
    for (std::size_t k = 0; k < canvas.view.ellipsoids.size(); ++k) {
        const Ellipsoid& ellipsoid = canvas.view.ellipsoids[k];
        const auto limb = limb_of(canvas.occluders.spheres()[k]);
        if (!limb || !(ellipsoid.opacity * ellipsoid.presence > 0.0)) continue;
        if (const auto outline = picture_of(*limb, canvas.projection))
            clip.path.add(canvas.path_of(*outline));
    }
    if (clip.path.steps.empty()) return;
    canvas.add(std::move(clip));
    draw_pixels(canvas, draw, edge_px, true);
    canvas.add(ClipEnd{});
}

}  // namespace poinsot::vector
