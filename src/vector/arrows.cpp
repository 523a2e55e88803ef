// Draws arrows and dots, from back to front.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "shapes/depth_order.h"
#include "vector/canvas.h"

namespace poinsot::vector {

namespace {

using std::numbers::pi;

// The shape of an arrow: sizes in units of the view, positions on paper.
struct ArrowShape {
    bool seen = false;
    Eigen::Vector3d axis, tail, neck, tip;
    double shaft_radius = 0.0, head_radius = 0.0;
    Eigen::Vector2d tail_pt, neck_pt, tip_pt;
    double tail_scale = 1.0, neck_scale = 1.0;  // points per unit
    double open = 0.0;                          // minor over major axis of the ellipses as which
                                                // circles about the axis appear
    Eigen::Vector2d along, across;              // on paper, unit vectors
    // The vector from the axis to the line of the shaft's surface nearest to the eye, and the share
    // of the axis up to which it runs parallel to the axis. The visibility of the arrow is computed
    // on this line.
    Eigen::Vector3d to_front = Eigen::Vector3d::Zero();
    double neck_at = 1.0;  // share of the axis

    // The point of this line at a share s of the axis; in the head it approaches the axis.
    Eigen::Vector3d front(double s) const {
        const double rest = s <= neck_at ? 1.0 : (1.0 - s) / (1.0 - neck_at);
        return tail + s * (tip - tail) + rest * to_front;
    }
};

ArrowShape shape_of(const Canvas& canvas, const Arrow& arrow) {
    const Projection& projection = canvas.projection;
    ArrowShape shape;
    const Eigen::Vector3d run = arrow.tip - arrow.tail;
    const double length = run.norm();
    if (!(length > 0.0) || arrow.opacity <= 0.0) return shape;
    shape.axis = run / length;
    // Sizes apply at the depth of the camera's target.
    const double unit_px =
        projection.scale(std::max(projection.depth(canvas.view.camera.target), 1e-9)) /
        projection.units_per_px;
    shape.shaft_radius = 0.5 * arrow.shaft_px / unit_px;
    shape.head_radius = 0.5 * arrow.head_px / unit_px;
    const double head_length = std::min(arrow.head_length_px / unit_px, length);
    shape.tail = arrow.tail;
    shape.tip = arrow.tip;
    shape.neck = arrow.tip - head_length * shape.axis;
    const double reach = std::max(shape.head_radius, shape.shaft_radius);
    if (projection.perspective &&
        std::min(projection.depth(shape.tail), projection.depth(shape.tip)) <=
            projection.near_depth + reach)
        return shape;
    shape.tail_pt = projection.place(shape.tail);
    shape.neck_pt = projection.place(shape.neck);
    shape.tip_pt = projection.place(shape.tip);
    shape.tail_scale = projection.scale(projection.depth(shape.tail));
    shape.neck_scale = projection.scale(projection.depth(shape.neck));
    const Eigen::Vector3d ray =
        projection.perspective ? (shape.neck - projection.eye).normalized() : projection.forward;
    shape.open = std::max(std::abs(ray.dot(shape.axis)), 0.03);
    const Eigen::Vector2d on_paper = shape.tip_pt - shape.tail_pt;
    shape.along = on_paper.norm() > 1e-6 ? on_paper.normalized().eval() : Eigen::Vector2d::UnitX();
    shape.across = {-shape.along.y(), shape.along.x()};
    const Eigen::Vector3d to_eye =
        projection.towards_eye(0.5 * (shape.tail + shape.tip)).normalized();
    const Eigen::Vector3d front = to_eye - to_eye.dot(shape.axis) * shape.axis;
    // Seen along its axis, the arrow has no such line.
    if (front.norm() > 1e-3) shape.to_front = shape.shaft_radius * front.normalized();
    shape.neck_at = 1.0 - head_length / length;
    shape.seen = true;
    return shape;
}

// The end of an arrow's part: a circle about the axis, seen as an ellipse.
PaperEllipse ring_of(const ArrowShape& shape, const Eigen::Vector2d& middle, double radius_pt) {
    return {middle, radius_pt * shape.along * shape.open, radius_pt * shape.across};
}

// A part of a ring between two angles as Béziers; angle 0 is ahead.
std::vector<Bezier> arc(const PaperEllipse& ring, double from, double to) {
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (0.5 * pi))));
    const double handle = 4.0 / 3.0 * std::tan(0.25 * (to - from) / n);
    const auto slope = [&](double t) -> Eigen::Vector2d {
        return ring.b * std::cos(t) - ring.a * std::sin(t);
    };
    std::vector<Bezier> beziers;
    for (int k = 0; k < n; ++k) {
        const double s = from + (to - from) * k / n, t = from + (to - from) * (k + 1) / n;
        beziers.push_back({ring.at(s), ring.at(s) + handle * slope(s),
                           ring.at(t) - handle * slope(t), ring.at(t)});
    }
    return beziers;
}

// The convex hull of two rings of one shape, the second ahead of the first.
Path hull(const ArrowShape& shape, const Eigen::Vector2d& a, double radius_a,
          const Eigen::Vector2d& b, double radius_b) {
    const PaperEllipse first = ring_of(shape, a, radius_a), second = ring_of(shape, b, radius_b);
    const double run = shape.along.dot(b - a) / shape.open;
    Path path;
    if (std::abs(radius_a - radius_b) >= run) {
        path.add(arc(radius_a > radius_b ? first : second, -pi, pi));
        path.close();
        return path;
    }
    // After stretching along the axis, common tangents touch both circles at the same angle.
    const double touch = std::acos((radius_a - radius_b) / run);
    path.add(arc(first, touch, 2.0 * pi - touch));
    if (radius_b > 1e-9) {
        path.line(second.at(-touch));
        path.add(arc(second, -touch, touch), false);
    } else {
        path.line(b);
    }
    path.close();
    return path;
}

// The shading across a round part, from side to side.
LinearFade lit_across(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape,
                      const Eigen::Vector2d& middle, double radius_pt, double cone_slope,
                      double opacity, const Colour& behind) {
    const Eigen::Vector3d to_eye =
        canvas.projection.towards_eye(0.5 * (shape.tail + shape.tip)).normalized();
    const Eigen::Vector3d side = shape.axis.cross(to_eye).normalized();
    const Eigen::Vector3d front = side.cross(shape.axis);
    // The direction of that side on paper.
    const Eigen::Vector2d side_pt =
        Eigen::Vector2d(canvas.projection.right.dot(side), canvas.projection.down.dot(side));
    const Eigen::Vector2d to_side = side_pt.dot(shape.across) < 0.0 ? -shape.across : shape.across;
    LinearFade fade;
    fade.from = middle - radius_pt * to_side;
    fade.to = middle + radius_pt * to_side;
    constexpr int n = 4;
    for (int k = 0; k <= n; ++k) {
        const double x = 2.0 * k / n - 1.0;
        const double clamped = std::clamp(x, -0.98, 0.98);
        const Eigen::Vector3d normal =
            (clamped * side + std::sqrt(1.0 - clamped * clamped) * front + cone_slope * shape.axis)
                .normalized();
        const Colour colour = encoded(arrow_surface(arrow.colour, canvas.lights, {normal, to_eye}));
        fade.stops.push_back({static_cast<double>(k) / n, as_in_light(colour, opacity, behind)});
    }
    return fade;
}

// Arrows of lower opacity are drawn without a gradient.
constexpr double pale = 0.9;

// Which parts of the arrow are drawn.
struct ArrowParts {
    bool shaft = true, head = true;
};

// Fills the arrow with shading; with `ink` if it is pale.
void fill_arrow(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape, double opacity,
                const PaperInk& ink, const ArrowParts& parts) {
    const double shaft_tail = shape.shaft_radius * shape.tail_scale;
    const double shaft_neck = shape.shaft_radius * shape.neck_scale;
    const double head = shape.head_radius * shape.neck_scale;
    const Colour behind = canvas.behind(0.5 * (shape.tail_pt + shape.tip_pt));
    const double head_length = (shape.tip - shape.neck).norm();
    const auto paint = [&](const Eigen::Vector2d& middle, double radius, double slope) -> Paint {
        if (canvas.shading == Shading::none) return PaperInk{arrow.colour, opacity};
        if (opacity < pale) return ink;
        // A part as narrow as a line has no gradient, either.
        constexpr double narrow_pt = 0.8;
        if (radius < narrow_pt) {
            const LinearFade fade =
                lit_across(canvas, arrow, shape, middle, radius, slope, opacity, behind);
            return fade.stops[fade.stops.size() / 2].ink;
        }
        return lit_across(canvas, arrow, shape, middle, radius, slope, opacity, behind);
    };
    Fill shaft;
    shaft.path = hull(shape, shape.tail_pt, shaft_tail, shape.neck_pt, shaft_neck);
    shaft.paint =
        paint(0.5 * (shape.tail_pt + shape.neck_pt), std::max(shaft_tail, shaft_neck), 0.0);
    Fill point;
    point.path = hull(shape, shape.neck_pt, head, shape.tip_pt, 0.0);
    point.paint = paint(shape.neck_pt, head, shape.head_radius / std::max(head_length, 1e-9));
    // The nearer part is drawn last: the shaft if the arrow points away from the eye.
    const bool away = shape.axis.dot(-canvas.projection.towards_eye(shape.neck)) > 0.0;
    bool shows_first = parts.shaft, shows_second = parts.head;
    if (away) {
        std::swap(shaft, point);
        std::swap(shows_first, shows_second);
    }
    if (shows_first) canvas.add(std::move(shaft));
    if (shows_second) canvas.add(std::move(point));
}

// A strip across the arrow that contains everything beside a part of its axis.
Path strip(const Canvas& canvas, const ArrowShape& shape, double from, double to) {
    const double reach = 2.0 * std::max(shape.head_radius * shape.neck_scale,
                                        shape.shaft_radius * shape.tail_scale) +
                         2.0;
    const auto place = [&](double s) { return canvas.projection.place(shape.front(s)); };
    const Eigen::Vector2d begin = place(from) - (from <= 0.0 ? reach : 0.0) * shape.along;
    const Eigen::Vector2d end = place(to) + (to >= 1.0 ? reach : 0.0) * shape.along;
    Path path;
    path.move(begin - reach * shape.across);
    path.line(end - reach * shape.across);
    path.line(end + reach * shape.across);
    path.line(begin + reach * shape.across);
    path.close();
    return path;
}

// The parts of the arrow that are visible beside a part of its axis.
ArrowParts parts_beside(const Canvas& canvas, const ArrowShape& shape, double from, double to) {
    const auto along = [&](double s) {
        return shape.along.dot(canvas.projection.place(shape.front(s)) - shape.neck_pt);
    };
    // The neck's rings extend equally to both sides of the neck.
    const double ring = shape.open * shape.neck_scale;
    return {from <= 0.0 || along(from) <= ring * shape.shaft_radius,
            to >= 1.0 || along(to) >= -ring * shape.head_radius};
}

// The opacity of a layer: the visible layer over the hidden one gives the full opacity.
double weight_of(const Cover& cover, double hidden_opacity, ArrowLayer layer) {
    if (layer == ArrowLayer::visible) return cover.clear;
    if (hidden_opacity < 0.0 || cover.clear >= 1.0) return 0.0;  // hidden parts are omitted
    return std::max(hidden_opacity, cover.transmitted);
}

// The outline of the ellipsoid behind whose limb the axis passes at s; nothing where the axis
// pierces a surface, where another solid begins, and at the ends of the axis.
std::optional<PaperEllipse> outline_at(const Canvas& canvas, const ArrowShape& shape, double s) {
    if (s <= 0.0 || s >= 1.0) return std::nullopt;
    const Eigen::Vector3d point = shape.front(s);
    for (const SphereSight& sphere : canvas.occluders.spheres()) {
        if (!(sphere.hiding > 0.0) || sphere.before_limb(sphere.u(point)) >= -1e-9) continue;
        const auto limb = limb_of(sphere);
        auto outline = limb ? picture_of(*limb, canvas.projection) : std::nullopt;
        if (outline && std::abs(outline->radius_of(canvas.projection.place(point)) - 1.0) < 1e-6)
            return outline;
    }
    return std::nullopt;
}

// Half the length, as a share of the axis, over which an outline that crosses the axis at s cuts
// the arrow's width; limited to three widths.
double slant(const Canvas& canvas, const ArrowShape& shape, const PaperEllipse& outline, double s) {
    const Eigen::Vector3d run = shape.tip - shape.tail;
    const Eigen::Vector3d point = shape.front(s);
    const bool in_head = s > shape.neck_at;
    const double scale = canvas.projection.scale(canvas.projection.depth(point));
    const double radius_pt = scale * (in_head ? shape.head_radius : shape.shaft_radius);
    const Eigen::Affine2d to_circle = outline.page_from_circle().inverse();
    const Eigen::Vector2d normal =
        to_circle.linear().transpose() * (to_circle * canvas.projection.place(point));
    const double along = std::abs(normal.dot(shape.along));
    const double across = std::abs(normal.dot(shape.across));
    constexpr double most = 6.0, margin_pt = 0.1;
    const double reach_pt = radius_pt * std::min(across / std::max(along, 1e-9), most) + margin_pt;
    constexpr double step = 1e-4;
    const double pt_per_s =
        (canvas.projection.place(point + step * run) - canvas.projection.place(point - step * run))
            .norm() /
        (2.0 * step);
    return reach_pt / std::max(pt_per_s, 1e-9);
}

// A span of the axis with the part of the arrow beside it, clipped by outlines.
struct BesideSpan {
    Span span;
    std::vector<ClipBegin> clips;
};

BesideSpan beside(const Canvas& canvas, const ArrowShape& shape, const Span& span) {
    BesideSpan part{span, {}};
    const Eigen::Vector2d middle =
        canvas.projection.place(shape.front(0.5 * (span.from + span.to)));
    for (const double end : {span.from, span.to}) {
        const auto outline = outline_at(canvas, shape, end);
        if (!outline) continue;
        const double reach = slant(canvas, shape, *outline, end);
        if (end == span.from)
            part.span.from = std::max(end - reach, 0.0);
        else
            part.span.to = std::min(end + reach, 1.0);
        part.clips.push_back(canvas.clip_to(*outline, outline->radius_of(middle) < 1.0));
    }
    return part;
}

// Draws the part of the arrow beside a span of its axis with one opacity, over a layer with another
// opacity.
void draw_part(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape,
               const Track& track, const Span& span, double opacity, double lower_opacity) {
    const Eigen::Vector3d to_eye = canvas.projection.towards_eye(0.5 * (shape.tail + shape.tip));
    const Eigen::Vector3d front = (to_eye - to_eye.dot(shape.axis) * shape.axis).normalized();
    const Colour lit =
        encoded(arrow_surface(arrow.colour, canvas.lights, {front, to_eye.normalized()}));
    const auto look_at = [&](double s) {
        const Colour ground = canvas.behind(canvas.projection.place(track.flow(s).position));
        const Colour behind = over(as_in_light(lit, lower_opacity, ground), ground);
        return Canvas::LineLook{lit, opacity, behind};
    };
    std::vector<Canvas::ConstantColourSpan> parts{{span.from, span.to, {}}};
    if (canvas.shading != Shading::none && opacity < pale)
        parts = canvas.constant_colour_spans(track, span.from, span.to, look_at);
    for (const Canvas::ConstantColourSpan& part : parts) {
        const bool whole = part.from <= 0.0 && part.to >= 1.0;
        if (!whole) canvas.add(ClipBegin{strip(canvas, shape, part.from, part.to), false});
        fill_arrow(canvas, arrow, shape, opacity, part.ink,
                   parts_beside(canvas, shape, part.from, part.to));
        if (!whole) canvas.add(ClipEnd{});
    }
}

void draw_arrow(const Canvas& canvas, const Arrow& arrow, ArrowLayer layer) {
    const ArrowShape shape = shape_of(canvas, arrow);
    if (!shape.seen) return;
    Track track;
    track.flow = [&shape](double s) {
        Eigen::Vector3d along = shape.tip - shape.tail;
        if (s > shape.neck_at) along -= shape.to_front / (1.0 - shape.neck_at);
        return CurveFlow{shape.front(s), along};
    };
    track.knots = {0.0, 1.0};
    if (shape.neck_at > 0.0 && shape.neck_at < 1.0) track.knots = {0.0, shape.neck_at, 1.0};
    if (arrow.occlusion == Occlusion::none) {
        if (layer == ArrowLayer::visible)
            draw_part(canvas, arrow, shape, track, {0.0, 1.0, {}}, arrow.opacity, 0.0);
        return;
    }
    const std::vector<Span> spans = canvas.occluders.spans(track, {});
    for (const Span& span : spans) {
        const auto opacity_of = [&](ArrowLayer of) {
            return arrow.opacity * weight_of(span.cover, arrow.hidden_opacity, of);
        };
        const double lower = layer == ArrowLayer::visible ? opacity_of(ArrowLayer::hidden) : 0.0;
        const double opacity = opacity_of(layer);
        if (opacity < 1e-3) continue;
        const BesideSpan part = beside(canvas, shape, span);
        for (const ClipBegin& clip : part.clips) canvas.add(clip);
        draw_part(canvas, arrow, shape, track, part.span, opacity, lower);
        for (std::size_t k = 0; k < part.clips.size(); ++k) canvas.add(ClipEnd{});
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
        rim.path = circle(middle, radius, canvas.page.off_pt);
        if (inner > 0.0) rim.path.add(circle(middle, inner, canvas.page.off_pt));
        rim.even_odd = true;
        rim.paint = as_in_light(dot.rim_colour, opacity, behind);
        canvas.add(std::move(rim));
    }
    if (inner <= 0.0) return;
    Fill fill;
    fill.path = circle(middle, inner, canvas.page.off_pt);
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
