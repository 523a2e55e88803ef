// Draws arrows and dots, from back to front.
#include "vector/passes/arrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "shapes/depth_order.h"
#include "vector/passes/arrow_shape.h"
#include "vector/passes/arrow_strands.h"

namespace poinsot::vector {

namespace {

// A round part of an arrow: a cylinder or a cone.
struct RoundPart {
    Eigen::Vector2d middle;  // on paper
    double radius_pt = 0.0;
    double cone_slope = 0.0;  // radius over length
};

// The shading across a round part, from side to side.
LinearFade lit_across(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape,
                      const RoundPart& part, double opacity, const Colour& behind) {
    const Eigen::Vector3d to_eye =
        canvas.projection.towards_eye(0.5 * (shape.tail + shape.tip)).normalized();
    const Eigen::Vector3d side = shape.axis.cross(to_eye).normalized();
    const Eigen::Vector3d front = side.cross(shape.axis);
    // The direction of that side on paper.
    const Eigen::Vector2d side_pt =
        Eigen::Vector2d(canvas.projection.right.dot(side), canvas.projection.down.dot(side));
    const Eigen::Vector2d to_side = side_pt.dot(shape.across) < 0.0 ? -shape.across : shape.across;
    LinearFade fade;
    fade.from = part.middle - part.radius_pt * to_side;
    fade.to = part.middle + part.radius_pt * to_side;
    constexpr int n = 4;
    for (int k = 0; k <= n; ++k) {
        const double x = 2.0 * k / n - 1.0;
        const double clamped = std::clamp(x, -0.98, 0.98);
        const Eigen::Vector3d normal =
            (clamped * side + std::sqrt(1.0 - clamped * clamped) * front +
             part.cone_slope * shape.axis)
                .normalized();
        const Colour colour = encoded(arrow_surface(arrow.colour, canvas.lights, {normal, to_eye}));
        fade.stops.push_back({static_cast<double>(k) / n, as_in_light(colour, opacity, behind)});
    }
    return fade;
}

// Arrows of lower opacity are drawn without a gradient.
constexpr double pale = 0.9;

// Fills a part of the arrow with shading; with `ink` if it is pale.
void fill_part(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape, ArrowPart part,
               double opacity, const PaperInk& ink) {
    const bool is_shaft = part == ArrowPart::shaft;
    const double tail = shape.shaft_radius * shape.tail_scale;
    const double neck = (is_shaft ? shape.shaft_radius : shape.head_radius) * shape.neck_scale;
    const double head_length = (shape.tip - shape.neck).norm();
    const RoundPart round{
        .middle = is_shaft ? (0.5 * (shape.tail_pt + shape.neck_pt)).eval() : shape.neck_pt,
        .radius_pt = is_shaft ? std::max(tail, neck) : neck,
        .cone_slope = is_shaft ? 0.0 : shape.head_radius / std::max(head_length, 1e-9)};
    Fill fill;
    fill.path = shape.outline_of(part);
    if (canvas.shading == Shading::none) {
        fill.paint = PaperInk{arrow.colour, opacity};
    } else if (opacity < pale) {
        fill.paint = ink;
    } else {
        const Colour behind = canvas.behind(0.5 * (shape.tail_pt + shape.tip_pt));
        LinearFade fade = lit_across(canvas, arrow, shape, round, opacity, behind);
        // A part as narrow as a line has no gradient, either.
        constexpr double narrow_pt = 0.8;
        if (round.radius_pt < narrow_pt)
            fill.paint = fade.stops[fade.stops.size() / 2].ink;
        else
            fill.paint = std::move(fade);
    }
    canvas.add(std::move(fill));
}

// The opacity of a layer: the visible layer over the hidden one gives the full opacity.
double weight_of(const Cover& cover, double hidden_opacity, ArrowLayer layer) {
    if (hidden_opacity < 0.0)  // hidden parts are omitted
        return layer == ArrowLayer::visible ? cover.before_bodies * seen_through_planes(cover)
                                            : 0.0;
    if (layer == ArrowLayer::visible) return cover.clear;
    if (cover.clear >= 1.0) return 0.0;
    return std::max(hidden_opacity, cover.transmitted);
}

// The opacity of a layer and of the layer below it.
struct LayerOpacity {
    double own = 1.0;
    double below = 0.0;
};

// Draws a part of the arrow beside a stretch of its axis.
void draw_stretch(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape, ArrowPart part,
                  const Span& stretch, const LayerOpacity& opacity) {
    const Eigen::Vector3d to_eye = canvas.projection.towards_eye(0.5 * (shape.tail + shape.tip));
    const Eigen::Vector3d front = (to_eye - to_eye.dot(shape.axis) * shape.axis).normalized();
    const Colour lit =
        encoded(arrow_surface(arrow.colour, canvas.lights, {front, to_eye.normalized()}));
    Track track;
    track.flow = [&shape](double s) { return CurveFlow{shape.front(s), shape.tip - shape.tail}; };
    track.knots = {shape.begin_of(part), shape.end_of(part)};
    const auto look_at = [&](double s) {
        const Colour ground = canvas.behind(canvas.projection.place(track.flow(s).position));
        const Colour behind = over(as_in_light(lit, opacity.below, ground), ground);
        return Canvas::LineLook{lit, opacity.own, behind};
    };
    std::vector<Canvas::ConstantColourSpan> spans{{stretch.from, stretch.to, {}}};
    if (canvas.shading != Shading::none && opacity.own < pale)
        spans = canvas.constant_colour_spans(track, stretch.from, stretch.to, look_at);
    for (const Canvas::ConstantColourSpan& span : spans) {
        if (spans.size() > 1)
            canvas.add(ClipBegin{shape.strip(canvas.projection, part, span.from, span.to), false});
        fill_part(canvas, arrow, shape, part, opacity.own, span.ink);
        if (spans.size() > 1) canvas.add(ClipEnd{});
    }
}

void draw_part(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape, ArrowPart part,
               ArrowLayer layer) {
    if (arrow.occlusion == Occlusion::none) {
        if (layer == ArrowLayer::visible)
            draw_stretch(canvas, arrow, shape, part, {shape.begin_of(part), shape.end_of(part), {}},
                         {.own = arrow.opacity});
        return;
    }
    const ArrowStrands strands(canvas, shape, part);
    const std::vector<Cover> covers = strands.covers();
    for (const Cover& cover : covers) {
        const auto opacity_of = [&](ArrowLayer of) {
            return arrow.opacity * weight_of(cover, arrow.hidden_opacity, of);
        };
        const double opacity = opacity_of(layer);
        if (opacity < 1e-3) continue;
        const double lower = layer == ArrowLayer::visible ? opacity_of(ArrowLayer::hidden) : 0.0;
        if (covers.size() > 1) canvas.add(ClipBegin{strands.region_of(cover), false});
        draw_stretch(canvas, arrow, shape, part, strands.stretch_of(cover),
                     {.own = opacity, .below = lower});
        if (covers.size() > 1) canvas.add(ClipEnd{});
    }
}

void draw_arrow(const Canvas& canvas, const Arrow& arrow, ArrowLayer layer) {
    if (layer == ArrowLayer::hidden && arrow.hidden_opacity < 0.0) return;
    const ArrowShape shape = arrow_shape(canvas, arrow);
    if (!shape.seen) return;
    canvas.enter(arrow.name, layer == ArrowLayer::hidden ? "hidden" : "");
    // The nearer part is drawn last: the shaft if the arrow points away from the eye.
    const bool away = shape.axis.dot(-canvas.projection.towards_eye(shape.neck)) > 0.0;
    std::array parts{ArrowPart::shaft, ArrowPart::head};
    if (away) std::swap(parts[0], parts[1]);
    for (const ArrowPart part : parts) {
        // The head is a group in that of the arrow. The dashes of a shaft have no head.
        const bool is_group = part == ArrowPart::head && arrow.head_px > arrow.shaft_px &&
                              !arrow.name.element.empty();
        if (is_group)
            canvas.paper.begin_group(
                canvas.id_of(arrow.name, layer == ArrowLayer::hidden ? "hidden-head" : "head"));
        draw_part(canvas, arrow, shape, part, layer);
        if (is_group) canvas.add(GroupEnd{});
    }
}

Path circle(const Eigen::Vector2d& middle, double radius_pt, double& off_pt) {
    Path path;
    path.add(beziers_of({middle, {radius_pt, 0.0}, {0.0, radius_pt}}, conic_tolerance_pt, off_pt));
    path.close();
    return path;
}

void fill_dot(const Canvas& canvas, const Dot& dot, double opacity) {
    const Eigen::Vector2d middle = canvas.projection.place(dot.at);
    const Colour behind = canvas.behind(middle);
    const double radius = canvas.pt(dot.radius_px), inner = canvas.pt(dot.radius_px - dot.rim_px);
    if (dot.rim_px > 0.0) {
        Fill rim;
        rim.path = circle(middle, radius, canvas.paper.off_pt);
        if (inner > 0.0) rim.path.add(circle(middle, inner, canvas.paper.off_pt));
        rim.even_odd = true;
        rim.paint = as_in_light(dot.rim_colour, opacity, behind);
        canvas.add(std::move(rim));
    }
    if (inner <= 0.0) return;
    Fill fill;
    fill.path = circle(middle, inner, canvas.paper.off_pt);
    fill.paint = as_in_light(dot.colour, opacity, behind);
    canvas.add(std::move(fill));
}

// The ellipsoid whose outline crosses the dot, so that it hides only a part of the dot; null if
// there is none.
const SphereSight* cut_by(const Canvas& canvas, const Dot& dot) {
    const Eigen::Vector2d middle = canvas.projection.place(dot.at);
    const double radius = canvas.pt(dot.radius_px);
    for (const SphereSight& sphere : canvas.occluders.spheres()) {
        if (!(sphere.hiding > 0.0) || sphere.surrounds_eye) continue;
        const Eigen::Vector3d u = sphere.u(dot.at);
        if (sphere.before_limb(u) >= -1e-9) continue;
        const auto limb = limb_of(sphere);
        const auto outline = limb ? picture_of(*limb, canvas.projection) : std::nullopt;
        if (!outline) continue;
        const double size = std::sqrt(std::abs(cross(outline->a, outline->b)));
        if (std::abs(outline->radius_of(middle) - 1.0) * std::max(size, outline->a.norm()) <
            2.0 * radius)
            return &sphere;
    }
    return nullptr;
}

void draw_dot(const Canvas& canvas, const Dot& dot, ArrowLayer layer) {
    if (dot.opacity <= 0.0 || (canvas.projection.perspective &&
                               canvas.projection.depth(dot.at) <= canvas.projection.near_depth))
        return;
    canvas.enter(dot.name, layer == ArrowLayer::hidden ? "hidden" : "");
    if (dot.occlusion == Occlusion::none) {
        if (layer == ArrowLayer::visible) fill_dot(canvas, dot, dot.opacity);
        return;
    }
    const Cover cover = canvas.occluders.at(dot.at, {});
    const SphereSight* sphere = cut_by(canvas, dot);
    if (sphere == nullptr) {
        const double opacity = dot.opacity * weight_of(cover, dot.hidden_opacity, layer);
        if (opacity > 1e-3) fill_dot(canvas, dot, opacity);
        return;
    }
    // The whole dot is drawn pale, then the visible layer draws the part outside the outline.
    if (layer == ArrowLayer::hidden) {
        if (dot.hidden_opacity < 0.0) return;
        fill_dot(canvas, dot, dot.opacity * std::max(dot.hidden_opacity, 1.0 - sphere->hiding));
        return;
    }
    canvas.add(canvas.clip_to(*picture_of(*limb_of(*sphere), canvas.projection), false));
    fill_dot(canvas, dot, dot.opacity);
    canvas.add(ClipEnd{});
}

// Numbers of arrows, then of dots, from back to front.
std::vector<std::size_t> order_of(const Canvas& canvas) {
    const Projection& projection = canvas.projection;
    const auto seen = [&projection](const Eigen::Vector3d& point) {
        return SeenPoint{projection.place(point), projection.depth(point)};
    };
    std::vector<SeenAxis> arrows;
    arrows.reserve(canvas.view.arrows.size());
    for (const Arrow& arrow : canvas.view.arrows)
        arrows.push_back({seen(arrow.tail), seen(arrow.tip)});
    std::vector<SeenPoint> dots;
    dots.reserve(canvas.view.dots.size());
    for (const Dot& dot : canvas.view.dots) dots.push_back(seen(dot.at));
    return back_to_front(arrows, dots, projection.perspective);
}

}  // namespace

void draw_arrows(const Canvas& canvas, ArrowLayer layer) {
    const std::size_t n_arrows = canvas.view.arrows.size();
    for (const std::size_t k : order_of(canvas)) {
        if (k < n_arrows)
            draw_arrow(canvas, canvas.view.arrows[k], layer);
        else
            draw_dot(canvas, canvas.view.dots[k - n_arrows], layer);
    }
}

}  // namespace poinsot::vector
