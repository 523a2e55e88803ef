#include "vector/canvas.h"

#include <algorithm>
#include <map>

#include "shapes/soft_shadow.h"
#include "vector/passes/arrows.h"
#include "vector/passes/bodies.h"
#include "vector/passes/cones.h"
#include "vector/passes/curves.h"
#include "vector/passes/ellipsoid.h"
#include "vector/passes/plane.h"
#include "vector/passes/shadow.h"
#include "vector/passes/surfaces.h"
#include "vector/passes/type.h"
#include "vector/picture.h"

namespace poinsot::vector {

namespace {

Colour mixed(const Colour& a, const Colour& b, double part_of_b) {
    const double keep = 1.0 - part_of_b;
    return {keep * a.r + part_of_b * b.r, keep * a.g + part_of_b * b.g,
            keep * a.b + part_of_b * b.b};
}

// The colour of a vertical gradient at a height.
Colour at_height(const Background& background, double y_pt, double top_pt, double height_pt) {
    return mixed(background.top, background.bottom,
                 std::clamp((y_pt - top_pt) / std::max(height_pt, 1e-9), 0.0, 1.0));
}

}  // namespace

Canvas::Canvas(const Drawing& whole, const View& shown, double pt_per_px, Shading how,
               SheetOfPaper& onto)
    : drawing(whole),
      view(shown),
      projection(shown, pt_per_px),
      occluders(shown, projection),
      lights(shown),
      shading(how),
      paper(onto) {}

std::string Canvas::id_of(const ShapeName& name, std::string_view part) const {
    if (name.element.empty()) return {};
    std::string id(name.element);
    if (name.number > 0) id += "-" + std::to_string(name.number);
    for (const std::string_view more : {name.part, part, std::string_view(panel)})
        if (!more.empty()) id += "-" + std::string(more);
    return id;
}

Colour Canvas::ground(const Eigen::Vector2d& at) const {
    // Paper is white where nothing is drawn.
    const Colour white{1.0, 1.0, 1.0};
    Colour colour = mixed(white, at_height(drawing.background, at.y(), 0.0, paper.height_pt),
                          drawing.background.alpha);
    colour = mixed(colour,
                   at_height(view.background, at.y(), projection.corner.y(), projection.size.y()),
                   view.background.alpha);
    if (shading == Shading::none) return colour;
    for (std::size_t k = 0; k < n_planes && k < view.planes.size(); ++k) {
        const Plane& plane = view.planes[k];
        const Eigen::Vector3d point = projection.on_plane(at, plane.centre, plane.normal);
        if (!point.allFinite() || projection.depth(point) <= projection.near_depth) continue;
        const double opacity = opacity_at(plane, (point - plane.centre).norm());
        colour = encoded(opacity * linear(plane.colour) + (1.0 - opacity) * linear(colour));
        if (!is_before_solids(*this, plane)) colour = shadowed(*this, plane, point, colour);
    }
    return colour;
}

Colour Canvas::behind(const Eigen::Vector2d& at) const {
    Colour colour = ground(at);
    if (shading == Shading::none) return colour;
    double depth = std::numeric_limits<double>::infinity();
    if (bodies)
        if (const auto body = body_at(*this, at)) {
            colour = body->colour;
            depth = body->depth;
        }
    if (ellipsoids.empty()) return colour;
    return encoded(through_ellipsoids(*this, ellipsoids, at, linear(colour), depth));
}

Path Canvas::path_of(const Track& track, double from, double to, double tolerance_pt,
                     double track_off_pt) const {
    std::vector<double> knots{from};
    for (const double knot : track.knots)
        if (from < knot && knot < to) knots.push_back(knot);
    knots.push_back(to);
    const Fit fit =
        fitted([&](double s) { return on_paper(projection, track.flow(s)); }, knots, tolerance_pt);
    paper.off_pt = std::max(paper.off_pt, fit.off_pt + track_off_pt);
    Path path;
    path.add(fit.beziers);
    return path;
}

Path Canvas::path_of(const PaperEllipse& ellipse) const {
    Path path;
    path.add(beziers_of(ellipse, conic_tolerance_pt, paper.off_pt));
    path.close();
    return path;
}

ClipBegin Canvas::clip_to(const PaperEllipse& outline, bool within) const {
    constexpr double beyond = 10.0;
    ClipBegin clip;
    clip.even_odd = !within;
    if (!within)
        clip.path.add_rectangle({-beyond, -beyond},
                                {paper.width_pt + 2.0 * beyond, paper.height_pt + 2.0 * beyond});
    clip.path.add(path_of(outline));
    return clip;
}

void draw_background(const Background& background, const Eigen::Vector2d& corner_pt,
                     const Eigen::Vector2d& size_pt, SheetOfPaper& paper) {
    if (background.alpha <= 0.0) return;
    Fill fill;
    fill.path.add_rectangle(corner_pt, size_pt);
    if (background.top == background.bottom)
        fill.paint = PaperInk{background.top, background.alpha};
    else
        fill.paint = LinearFade{corner_pt,
                                corner_pt + Eigen::Vector2d(0.0, size_pt.y()),
                                {{0.0, {background.top, background.alpha}},
                                 {1.0, {background.bottom, background.alpha}}}};
    paper.add(std::move(fill));
}

namespace {

// Without shading, the background has a uniform colour.
Background ground_of(Background background, Shading shading) {
    if (shading == Shading::none) background.top = background.bottom;
    return background;
}

void draw_view(const Drawing& drawing, const View& view, const std::string& panel,
               const PaperChoices& choices, SheetOfPaper& paper) {
    Canvas canvas(drawing, view, choices.pt_per_px, choices.shading, paper);
    canvas.panel = panel;
    const Projection& projection = canvas.projection;
    const bool is_whole = projection.corner.isZero() &&
                          projection.size == Eigen::Vector2d(paper.width_pt, paper.height_pt);
    const bool has_shapes =
        !(view.planes.empty() && view.ellipsoids.empty() && view.cones.empty() &&
          view.meshes.empty() && view.curves.empty() && view.arrows.empty() && view.dots.empty());
    draw_background(ground_of(view.background, choices.shading), projection.corner, projection.size,
                    paper);
    const bool clips = has_shapes && !is_whole;
    if (clips) {
        ClipBegin clip;
        clip.path.add_rectangle(projection.corner, projection.size);
        paper.add(std::move(clip));
    }
    const bool has_surfaces = !(view.planes.empty() && view.ellipsoids.empty() &&
                                view.cones.empty() && view.meshes.empty());
    const bool has_pixels = choices.shading == Shading::picture && has_surfaces;
    if (has_pixels) canvas.enter({"surfaces"});
    if (has_pixels) draw_ground_pixels(canvas, choices.draw_pixels);
    for (const Plane& plane : view.planes)
        if (!is_before_solids(canvas, plane)) {
            canvas.enter(plane.name);
            draw_plane(canvas, plane);
            for (std::size_t k = 0; k < view.ellipsoids.size(); ++k) draw_shadow(canvas, plane, k);
        }
    canvas.n_planes = view.planes.size();
    // Order from back to front.
    std::vector<std::size_t> order;
    order.reserve(view.ellipsoids.size());
    for (std::size_t k = 0; k < view.ellipsoids.size(); ++k) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return projection.depth(view.ellipsoids[a].centre) >
               projection.depth(view.ellipsoids[b].centre);
    });
    light_sheets(canvas, order);
    if (!view.meshes.empty()) canvas.enter(view.meshes.front().name);
    draw_meshes(canvas);
    canvas.bodies = true;
    if (has_pixels) canvas.enter({"ellipsoid-surfaces"});
    if (has_pixels) draw_ellipsoid_pixels(canvas, choices.draw_pixels);
    auto sheet = canvas.sheets.begin();
    for (const std::size_t k : order) {
        canvas.enter(view.ellipsoids[k].name);
        if (sheet != canvas.sheets.end() && sheet->number == k) draw_ellipsoid(canvas, *sheet++);
        canvas.ellipsoids.push_back(k);
    }
    for (const Plane& plane : view.planes)
        if (is_before_solids(canvas, plane)) {
            canvas.enter(plane.name);
            draw_plane(canvas, plane);
        }
    for (const Cone& cone : view.cones) {
        canvas.enter(cone.name);
        draw_cone(canvas, cone);
    }
    draw_arrows(canvas, ArrowLayer::hidden);
    for (const Curve& curve : view.curves) {
        // The leader of an omitted label.
        if (std::any_of(view.labels.begin(), view.labels.end(), [&](const Label& label) {
                return curve.name == ShapeName{label.name.element, label.name.number, "leader"} &&
                       is_omitted(canvas, label);
            }))
            continue;
        canvas.enter(curve.name);
        draw_curve(canvas, curve);
    }
    draw_arrows(canvas, ArrowLayer::visible);
    canvas.paper.enter_group({});
    if (clips) paper.add(ClipEnd{});
    for (const Label& label : view.labels) {
        canvas.enter(label.name, "label");
        draw_label(canvas, label);
    }
    canvas.paper.enter_group({});
}

}  // namespace

SheetOfPaper paper_of(const Drawing& drawing, const PaperChoices& choices) {
    SheetOfPaper paper;
    paper.width_pt = choices.pt_per_px * drawing.width_px;
    paper.height_pt = choices.pt_per_px * drawing.height_px;
    draw_background(ground_of(drawing.background, choices.shading), Eigen::Vector2d::Zero(),
                    {paper.width_pt, paper.height_pt}, paper);
    const auto n_panels = std::count_if(drawing.views.begin(), drawing.views.end(),
                                        [](const View& view) { return !view.name.empty(); });
    std::map<std::string_view, int> n_of_kind;
    for (const View& view : drawing.views) {
        std::string panel;
        if (n_panels > 1 && !view.name.empty()) {
            panel = view.name;
            if (const int n = ++n_of_kind[view.name]; n > 1) panel += "-" + std::to_string(n);
            paper.begin_group(panel);
        }
        draw_view(drawing, view, panel, choices, paper);
        if (!panel.empty()) paper.add(GroupEnd{});
    }
    return paper;
}

}  // namespace poinsot::vector
