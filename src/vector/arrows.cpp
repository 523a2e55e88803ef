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
    // of the axis up to which it runs parallel to the axis. Colours are computed on this line.
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
    return arc_of(ring, from, to, n);
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

// The parts of an arrow; each is cut and filled on its own.
enum class ArrowPart { shaft, head };

// The share of the axis at which a part begins and ends.
double begin_of(const ArrowShape& shape, ArrowPart part) {
    return part == ArrowPart::shaft ? 0.0 : shape.neck_at;
}
double end_of(const ArrowShape& shape, ArrowPart part) {
    return part == ArrowPart::shaft ? shape.neck_at : 1.0;
}

// Fills a part of the arrow with shading; with `ink` if it is pale.
void fill_part(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape, ArrowPart part,
               double opacity, const PaperInk& ink) {
    const bool is_shaft = part == ArrowPart::shaft;
    const double tail = shape.shaft_radius * shape.tail_scale;
    const double neck = (is_shaft ? shape.shaft_radius : shape.head_radius) * shape.neck_scale;
    const double head_length = (shape.tip - shape.neck).norm();
    const Eigen::Vector2d middle =
        is_shaft ? (0.5 * (shape.tail_pt + shape.neck_pt)).eval() : shape.neck_pt;
    const double radius = is_shaft ? std::max(tail, neck) : neck;
    const double slope = is_shaft ? 0.0 : shape.head_radius / std::max(head_length, 1e-9);
    Fill fill;
    fill.path = is_shaft ? hull(shape, shape.tail_pt, tail, shape.neck_pt, neck)
                         : hull(shape, shape.neck_pt, neck, shape.tip_pt, 0.0);
    if (canvas.shading == Shading::none) {
        fill.paint = PaperInk{arrow.colour, opacity};
    } else if (opacity < pale) {
        fill.paint = ink;
    } else {
        const Colour behind = canvas.behind(0.5 * (shape.tail_pt + shape.tip_pt));
        LinearFade fade = lit_across(canvas, arrow, shape, middle, radius, slope, opacity, behind);
        // A part as narrow as a line has no gradient, either.
        constexpr double narrow_pt = 0.8;
        if (radius < narrow_pt)
            fill.paint = fade.stops[fade.stops.size() / 2].ink;
        else
            fill.paint = std::move(fade);
    }
    canvas.add(std::move(fill));
}

// How far a part's ends reach beyond the ends of its axis, and its sides beyond the radius, at
// most.
double reach_pt(const ArrowShape& shape, ArrowPart part) {
    return part == ArrowPart::shaft
               ? shape.shaft_radius * std::max(shape.tail_scale, shape.neck_scale) + 1.0
               : shape.head_radius * shape.neck_scale + 1.0;
}

// A strip across the part that contains everything beside a stretch of its axis.
Path strip(const Canvas& canvas, const ArrowShape& shape, ArrowPart part, double from, double to) {
    const double reach = 2.0 * reach_pt(shape, part);
    const auto place = [&](double s) { return canvas.projection.place(shape.front(s)); };
    const Eigen::Vector2d begin =
        place(from) - (from <= begin_of(shape, part) ? reach : 0.0) * shape.along;
    const Eigen::Vector2d end = place(to) + (to >= end_of(shape, part) ? reach : 0.0) * shape.along;
    Path path;
    path.move(begin - reach * shape.across);
    path.line(end - reach * shape.across);
    path.line(end + reach * shape.across);
    path.line(begin + reach * shape.across);
    path.close();
    return path;
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

// Lines on the near side of a part of an arrow, side by side from one edge to the other, each with
// the spans of its visibility. They cut the part along the outline of what hides it, at any slant.
class Strands {
 public:
    Strands(const Canvas& canvas, const ArrowShape& shape, ArrowPart part)
        : projection_(canvas.projection),
          shape_(shape),
          part_(part),
          from_(begin_of(shape, part)),
          to_(end_of(shape, part)) {
        // The lines on the near side begin at one end of a ring's outline on the paper: its other
        // end is two open radii further along the axis.
        const double radius = part == ArrowPart::shaft ? shape.shaft_radius : shape.head_radius;
        constexpr double most_radii = 2.0;
        const double radii = shape.open / std::sqrt(std::max(1.0 - shape.open * shape.open, 1e-6));
        beyond_ = 2.0 * std::min(radii, most_radii) * radius / (shape.tip - shape.tail).norm();
        // Seen along its axis, the arrow has one line.
        if (shape.to_front.isZero(0.0)) {
            strands_.push_back(strand_at(canvas, 0.0));
            return;
        }
        for (const double side : {-1.0, 0.0, 1.0}) {
            Strand next = strand_at(canvas, side);
            if (!strands_.empty()) refine(canvas, Strand(strands_.back()), next, 0);
            strands_.push_back(std::move(next));
        }
    }

    // All different covers.
    std::vector<Cover> covers() const {
        std::vector<Cover> found;
        for (const Strand& strand : strands_)
            for (const Span& span : strand.spans)
                if (std::find(found.begin(), found.end(), span.cover) == found.end())
                    found.push_back(span.cover);
        return found;
    }

    // The stretch of the axis beside which the part has this cover.
    Span stretch_of(const Cover& cover) const {
        Span stretch{to_, from_, cover};
        for (const Strand& strand : strands_)
            for (const Span& span : strand.spans)
                if (span.cover == cover) {
                    stretch.from = std::min(stretch.from, std::max(span.from, from_));
                    stretch.to = std::max(stretch.to, std::min(span.to, to_));
                }
        // Only beyond the ends.
        if (!(stretch.from < stretch.to)) return {from_, to_, cover};
        return stretch;
    }

    // The region of the paper with this cover.
    Path region_of(const Cover& cover) const {
        Path region;
        for (std::size_t first = 0; first < strands_.size();) {
            // Neighbours with the same sequence of covers: their breaks are on one edge.
            std::size_t end = first + 1;
            while (end < strands_.size() && is_like(strands_[first], strands_[end])) ++end;
            const auto& spans = strands_[first].spans;
            for (std::size_t i = 0; i < spans.size(); ++i) {
                if (!(spans[i].cover == cover)) continue;
                // Round the region; its sides bend where the part begins and ends.
                std::vector<Eigen::Vector2d> edge = edge_of(first, end, i, false);
                const auto add = [&edge](const std::vector<Eigen::Vector2d>& points) {
                    edge.insert(edge.end(), points.begin(), points.end());
                };
                add(bends_of(end - 1, i, 1));
                std::vector<Eigen::Vector2d> back = edge_of(first, end, i, true);
                std::reverse(back.begin(), back.end());
                add(back);
                back = bends_of(first, i, -1);
                std::reverse(back.begin(), back.end());
                add(back);
                region.move(edge.front());
                for (std::size_t k = 1; k < edge.size(); ++k) region.line(edge[k]);
                region.close();
            }
            first = end;
        }
        return region;
    }

 private:
    struct Strand {
        double side = 0.0;  // −1 … 1 across the part
        std::vector<Span> spans;
    };

    Strand strand_at(const Canvas& canvas, double side) const {
        Strand strand{side, {}};
        Track track;
        track.flow = [this, side](double s) { return at(side, s); };
        track.knots = {from_ - beyond_, from_, to_, to_ + beyond_};
        if (from_ < to_) strand.spans = canvas.occluders.spans(track, {});
        return strand;
    }

    // Adds strands between two neighbours until the cut is straight between them, or until they are
    // so close that a corner between them is off by no more than that.
    void refine(const Canvas& canvas, const Strand& one, const Strand& other, int depth) {
        constexpr int deepest = 7;
        constexpr double most_off_pt = 0.01;
        if ((place(other.side, from_) - place(one.side, from_)).norm() <= 2.0 * most_off_pt) return;
        const Strand middle = strand_at(canvas, 0.5 * (one.side + other.side));
        bool is_straight = is_like(one, middle) && is_like(middle, other);
        for (std::size_t i = 0; is_straight && i + 1 < middle.spans.size(); ++i) {
            const Eigen::Vector2d here = place(middle.side, middle.spans[i].to);
            const Eigen::Vector2d a = place(one.side, one.spans[i].to);
            const Eigen::Vector2d chord = place(other.side, other.spans[i].to) - a;
            is_straight = std::abs(cross(chord, here - a)) <= most_off_pt * chord.norm();
        }
        if (is_straight || depth == deepest) return;
        refine(canvas, one, middle, depth + 1);
        strands_.push_back(middle);
        refine(canvas, middle, other, depth + 1);
    }

    // A point of the near surface. In the head, the radius decreases towards the tip; beyond the
    // ends it is constant.
    CurveFlow at(double side, double s) const {
        const Eigen::Vector3d run = shape_.tip - shape_.tail;
        Eigen::Vector3d off = Eigen::Vector3d::Zero();
        if (!shape_.to_front.isZero(0.0)) {
            const Eigen::Vector3d front = shape_.to_front.normalized();
            off = side * front.cross(shape_.axis) + std::sqrt(1.0 - side * side) * front;
        }
        if (part_ == ArrowPart::shaft)
            return {shape_.tail + s * run + shape_.shaft_radius * off, run};
        const double length = std::max(to_ - from_, 1e-12);
        const Eigen::Vector3d base = shape_.head_radius * off;
        const double share = std::clamp((to_ - s) / length, 0.0, 1.0);
        const bool narrows = from_ <= s && s <= to_;
        return {shape_.tail + s * run + share * base, narrows ? (run - base / length).eval() : run};
    }

    static bool is_like(const Strand& a, const Strand& b) {
        return std::equal(a.spans.begin(), a.spans.end(), b.spans.begin(), b.spans.end(),
                          [](const Span& x, const Span& y) { return x.cover == y.cover; });
    }

    Eigen::Vector2d place(double side, double s) const {
        return projection_.place(at(side, s).position);
    }

    // A point of the border of strand k towards a neighbour (step 1 or −1): half-way between both,
    // or beyond the side of the part.
    Eigen::Vector2d border(std::size_t k, std::ptrdiff_t step, double s) const {
        const Eigen::Vector2d here = place(strands_[k].side, s);
        const auto next = static_cast<std::ptrdiff_t>(k) + step;
        if (next >= 0 && next < static_cast<std::ptrdiff_t>(strands_.size()))
            return 0.5 * (here + place(strands_[static_cast<std::size_t>(next)].side, s));
        // Sides towards which the strands are numbered.
        const Eigen::Vector2d across = place(1.0, from_) - place(-1.0, from_);
        const double length = across.norm();
        const Eigen::Vector2d out = length > 1e-9 ? (across / length).eval() : shape_.across;
        return here + static_cast<double>(step) * reach_pt(shape_, part_) * out;
    }

    // The points inside span i at which that border bends.
    std::vector<Eigen::Vector2d> bends_of(std::size_t k, std::size_t i, std::ptrdiff_t step) const {
        std::vector<Eigen::Vector2d> bends;
        const Span& span = strands_[k].spans[i];
        for (const double s : {from_, to_})
            if (span.from < s && s < span.to) bends.push_back(border(k, step, s));
        return bends;
    }

    // One end of span i of the strands [first, end), continued to the middle between them and their
    // neighbours, and beyond the sides and the ends of the part.
    std::vector<Eigen::Vector2d> edge_of(std::size_t first, std::size_t end, std::size_t i,
                                         bool at_end) const {
        const double reach = reach_pt(shape_, part_);
        const auto end_at = [&](std::size_t k) {
            const Span& span = strands_[k].spans[i];
            return at_end ? span.to : span.from;
        };
        std::vector<Eigen::Vector2d> edge;
        const auto add = [&](const Eigen::Vector2d& point, double s) {
            double ahead = 0.0;
            if (at_end && s >= to_ + beyond_) ahead = reach;
            if (!at_end && s <= from_ - beyond_) ahead = -reach;
            edge.push_back(point + ahead * shape_.along);
        };
        const auto add_border = [&](std::size_t k, std::ptrdiff_t step) {
            add(border(k, step, end_at(k)), end_at(k));
        };
        add_border(first, -1);
        for (std::size_t k = first; k < end; ++k)
            add(place(strands_[k].side, end_at(k)), end_at(k));
        add_border(end - 1, 1);
        return edge;
    }

    const Projection& projection_;
    const ArrowShape& shape_;
    ArrowPart part_;
    double from_, to_;
    double beyond_ = 0.0;  // the continuation of the lines at both ends
    std::vector<Strand> strands_;
};

// Draws a part of the arrow beside a stretch of its axis with one opacity, over a layer with
// another opacity.
void draw_stretch(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape, ArrowPart part,
                  const Span& stretch, double opacity, double lower_opacity) {
    const Eigen::Vector3d to_eye = canvas.projection.towards_eye(0.5 * (shape.tail + shape.tip));
    const Eigen::Vector3d front = (to_eye - to_eye.dot(shape.axis) * shape.axis).normalized();
    const Colour lit =
        encoded(arrow_surface(arrow.colour, canvas.lights, {front, to_eye.normalized()}));
    Track track;
    track.flow = [&shape](double s) { return CurveFlow{shape.front(s), shape.tip - shape.tail}; };
    track.knots = {begin_of(shape, part), end_of(shape, part)};
    const auto look_at = [&](double s) {
        const Colour ground = canvas.behind(canvas.projection.place(track.flow(s).position));
        const Colour behind = over(as_in_light(lit, lower_opacity, ground), ground);
        return Canvas::LineLook{lit, opacity, behind};
    };
    std::vector<Canvas::ConstantColourSpan> spans{{stretch.from, stretch.to, {}}};
    if (canvas.shading != Shading::none && opacity < pale)
        spans = canvas.constant_colour_spans(track, stretch.from, stretch.to, look_at);
    for (const Canvas::ConstantColourSpan& span : spans) {
        if (spans.size() > 1)
            canvas.add(ClipBegin{strip(canvas, shape, part, span.from, span.to), false});
        fill_part(canvas, arrow, shape, part, opacity, span.ink);
        if (spans.size() > 1) canvas.add(ClipEnd{});
    }
}

void draw_part(const Canvas& canvas, const Arrow& arrow, const ArrowShape& shape, ArrowPart part,
               ArrowLayer layer) {
    if (arrow.occlusion == Occlusion::none) {
        if (layer == ArrowLayer::visible)
            draw_stretch(canvas, arrow, shape, part,
                         {begin_of(shape, part), end_of(shape, part), {}}, arrow.opacity, 0.0);
        return;
    }
    const Strands strands(canvas, shape, part);
    const std::vector<Cover> covers = strands.covers();
    for (const Cover& cover : covers) {
        const auto opacity_of = [&](ArrowLayer of) {
            return arrow.opacity * weight_of(cover, arrow.hidden_opacity, of);
        };
        const double opacity = opacity_of(layer);
        if (opacity < 1e-3) continue;
        const double lower = layer == ArrowLayer::visible ? opacity_of(ArrowLayer::hidden) : 0.0;
        if (covers.size() > 1) canvas.add(ClipBegin{strands.region_of(cover), false});
        draw_stretch(canvas, arrow, shape, part, strands.stretch_of(cover), opacity, lower);
        if (covers.size() > 1) canvas.add(ClipEnd{});
    }
}

void draw_arrow(const Canvas& canvas, const Arrow& arrow, ArrowLayer layer) {
    if (layer == ArrowLayer::hidden && arrow.hidden_opacity < 0.0) return;
    const ArrowShape shape = shape_of(canvas, arrow);
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
