#include "drawing/style/line_style.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/style/pierced_planes.h"
#include "shapes/identity.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

bool has_solids(const View& view) {
    return !(view.ellipsoids.empty() && view.planes.empty() && view.meshes.empty());
}

Eigen::Affine3d placed(const Eigen::Vector3d& origin, const Eigen::Vector3d& x,
                       const Eigen::Vector3d& y) {
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    placement.linear() << x, y, x.cross(y);
    placement.translation() = origin;
    return placement;
}

// Removes the principal sections from the view's ellipsoids and returns them as curves on their
// surfaces.
std::vector<Curve> taken_sections(const LineStyleRules& rules, View& view) {
    std::vector<Curve> sections;
    for (std::size_t k = 0; k < view.ellipsoids.size(); ++k) {
        Ellipsoid& ellipsoid = view.ellipsoids[k];
        if (!(ellipsoid.section_px > 0.0)) continue;
        for (int i = 0; i < 3; ++i) {
            Curve& section = sections.emplace_back();
            section.geometry = rules.unit_circle;
            section.placement = placed(ellipsoid.centre, ellipsoid.half_axes.col(i),
                                       ellipsoid.half_axes.col((i + 1) % 3));
            section.width_px = ellipsoid.section_px;
            section.colour = ellipsoid.line_colour;
            section.opacity = ellipsoid.presence;
            section.on_surface = static_cast<int>(k);
            section.name = ellipsoid.name;
            section.name.part = "sections";
        }
        ellipsoid.section_px = 0.0;
    }
    return sections;
}

// A line that stands for the hidden part of an arrow.
Curve hidden_line_of(const Arrow& arrow, std::string_view part) {
    Curve line;
    line.colour = arrow.colour;
    line.opacity = arrow.opacity;
    line.stands_for_hidden = true;
    line.name = {arrow.name.element, arrow.name.number, part};
    return line;
}

// The axis of an arrow up to its head.
Curve axis_of(const LineStyleRules& rules, const View& view, const Arrow& arrow) {
    constexpr double share_of_shaft = 0.6;
    const Eigen::Vector3d run = arrow.tip - arrow.tail;
    const double length_px = run.norm() * unit_px_of(view);
    Curve line = hidden_line_of(arrow, "hidden");
    line.geometry = rules.unit_segment;
    line.placement =
        placed(arrow.tail, std::max(1.0 - arrow.head_length_px / length_px, 1e-6) * run,
               run.unitOrthogonal());
    line.width_px = share_of_shaft * arrow.shaft_px;
    return line;
}

// The outline of an arrow's head as the camera sees it, half a line inside the head.
Curve outline_of_head(const Arrow& arrow, View& view) {
    constexpr double share_of_shaft = 0.4;
    constexpr int n_points = 36;  // of the base
    Curve line = hidden_line_of(arrow, "hidden-head");
    line.width_px = share_of_shaft * arrow.shaft_px;
    line.hidden_opacity = 1.0;
    const double unit_px = unit_px_of(view), inset = 0.5 * line.width_px / unit_px;
    const Eigen::Vector3d axis = (arrow.tip - arrow.tail).normalized();
    const double length = std::min(arrow.head_length_px / unit_px, (arrow.tip - arrow.tail).norm());
    const double slope = 0.5 * arrow.head_px / unit_px / length;
    // The smaller cone with the same slope.
    const double height =
        std::max(length - inset - inset * std::sqrt(1.0 + 1.0 / (slope * slope)), 0.5 * length);
    const double radius = slope * height;
    const Eigen::Vector3d base = arrow.tip - (length - inset) * axis, tip = base + height * axis;
    const Eigen::Vector3d to_eye = view.camera.orthographic
                                       ? Eigen::Vector3d(camera_axes(view.camera).col(2))
                                       : Eigen::Vector3d((view.camera.eye - tip).normalized());
    const Eigen::Vector3d across = to_eye - to_eye.dot(axis) * axis;
    const Eigen::Vector3d first =
        across.norm() > 1e-6 ? across.normalized() : axis.unitOrthogonal().eval();
    const Eigen::Vector3d second = axis.cross(first);

    CurveGeometry& geometry = view.live_curves.emplace_back();
    geometry.id = next_identity();
    const auto add_arc = [&](double from, double to) {
        for (int k = 0; k <= n_points; ++k) {
            const double angle = from + (to - from) * k / n_points;
            geometry.points.emplace_back(
                base + radius * (std::cos(angle) * first + std::sin(angle) * second));
        }
    };
    // The cone's edges, where its surface turns away from the eye, are at ±angle about the axis.
    constexpr double turn = 2.0 * std::numbers::pi;
    const double cosine = -slope * to_eye.dot(axis) / std::max(across.norm(), 1e-12);
    if (std::abs(cosine) >= 1.0) {
        add_arc(0.0, turn);
    } else if (const double angle = std::acos(cosine); to_eye.dot(axis) > 0.0) {
        geometry.points.push_back(tip);
        add_arc(-angle, angle);
        geometry.closed = true;
    } else {
        // The whole base is seen.
        geometry.points.emplace_back(base +
                                     radius * (std::cos(angle) * first - std::sin(angle) * second));
        geometry.points.push_back(tip);
        add_arc(angle, angle + turn);
    }
    line.geometry = &geometry;
    return line;
}

// Factor of the width of a line that was dashed to be distinguishable and becomes solid.
constexpr double told_by_width = 0.7;

void hide(std::string_view parts, Curve& curve) {
    constexpr double least_opacity = 0.7;
    if (curve.occlusion != Occlusion::by_solids || curve.hidden == HiddenStyle::absent) return;
    if (parts == "omitted") {
        curve.hidden = HiddenStyle::absent;
        return;
    }
    if (curve.dash_px > 0.0) curve.width_px *= told_by_width;
    curve.dash_px = curve.gap_px = 0.0;
    curve.hidden = HiddenStyle::dashed;
    curve.hidden_opacity = std::max(curve.hidden_opacity, least_opacity);
}

// Adds the lines that stand for the hidden parts of dashed arrows.
void style_hidden_arrows(const LineStyleRules& rules, View& view, std::vector<Curve>& axes,
                         std::vector<Curve>& heads) {
    if (rules.hidden_arrows == "pale") return;
    const bool dashed = rules.hidden_arrows == "dashed";
    for (Arrow& arrow : view.arrows) {
        if (arrow.occlusion != Occlusion::by_solids || arrow.tip == arrow.tail) continue;
        if (dashed) {
            if (arrow.dash_px > 0.0) arrow.shaft_px *= told_by_width;
            arrow.dash_px = 0.0;
            axes.push_back(axis_of(rules, view, arrow));
            if (arrow.opacity > 0.0 && arrow.head_px > arrow.shaft_px)
                heads.push_back(outline_of_head(arrow, view));
        }
        arrow.hidden_opacity = -1.0;
    }
}

void style_hidden(const LineStyleRules& rules, View& view) {
    std::vector<Curve> axes, heads;
    style_hidden_arrows(rules, view, axes, heads);
    for (Curve& axis : axes) hide(rules.hidden_arrows, axis);
    const std::string_view parts = rules.hidden;
    std::vector<Curve> curves;
    if (parts != "pale") curves = taken_sections(rules, view);
    if (parts == "omitted") {
        for (Dot& dot : view.dots)
            if (dot.occlusion == Occlusion::by_solids) dot.hidden_opacity = -1.0;
        for (Label& label : view.labels) label.with_point = true;
    }
    curves.insert(curves.end(), view.curves.begin(), view.curves.end());
    if (parts != "pale")
        for (Curve& curve : curves) hide(parts, curve);
    curves.insert(curves.begin(), axes.begin(), axes.end());
    curves.insert(curves.end(), heads.begin(), heads.end());
    view.curves = std::move(curves);
}

// A piece of a line on the screen.
struct Piece {
    Eigen::Vector2d a = Eigen::Vector2d::Zero(), b = Eigen::Vector2d::Zero();  // px
    double depth_a = 0.0, depth_b = 0.0;
    double from = 0.0, to = 0.0;  // of a curve: point indices
    double width_px = 0.0;
    int curve = -1;  // -1: an arrow, which never gets gaps
};

// Finds the gaps of lines that pass under others.
class Crossing {
 public:
    Crossing(const View& view, double least_gap_px) : view_(view), least_gap_px_(least_gap_px) {
        for (const Dot& dot : view.dots)
            if (dot.name.element == "contact" && dot.opacity > 0.0) {
                const Projected seen = project(view, dot.at);
                if (seen.depth > 0.0) contacts_px_.push_back(seen.px);
            }
        for (std::size_t k = 0; k < view.curves.size(); ++k) add_curve(static_cast<int>(k));
        for (const Arrow& arrow : view.arrows) add_arrow(arrow);
        find();
    }

    // Adds the visible parts of a curve between its gaps. A gap at the first point of a closed
    // curve continues at its end.
    void add_parts(int curve, std::vector<Curve>& parts) const {
        const Curve& whole = view_.curves[static_cast<std::size_t>(curve)];
        const auto found = gaps_.find(curve);
        if (found == gaps_.end()) {
            parts.push_back(whole);
            return;
        }
        std::vector<Gap> gaps = found->second;
        const auto range = range_of(whole);
        const double first = range.first, last = range.second;
        if (whole.geometry->closed && last - first == n_points(whole))
            for (std::size_t k = 0, n = gaps.size(); k < n; ++k) {
                const auto [from, to, most] = gaps[k];
                if (from < first) gaps.push_back({from + (last - first), last, most});
                if (to > last) gaps.push_back({first, to - (last - first), most});
            }
        std::sort(gaps.begin(), gaps.end(),
                  [](const Gap& a, const Gap& b) { return a.from < b.from; });
        drop_wide_runs(gaps);
        double at = first;
        const auto add = [&](double from, double to) {
            if (!(to > from)) return;
            Curve part = whole;
            part.first = from;
            part.last = to;
            part.fade_end = std::max(whole.fade_end, last);
            part.lasting = false;
            parts.push_back(part);
        };
        for (const Gap& gap : gaps) {
            add(at, std::min(gap.from, last));
            at = std::max(at, gap.to);
        }
        add(at, last);
    }

 private:
    // A range of a curve that is left out, and how long a hole there may be; in points.
    struct Gap {
        double from = 0.0, to = 0.0, most = 0.0;
    };

    // Where several lines cross one after the other, their gaps would join into a long hole: drops
    // those that would make it longer than one crossing may.
    static void drop_wide_runs(std::vector<Gap>& gaps) {
        std::vector<Gap> kept;
        double from = 0.0, to = -1e300;  // of the hole so far
        for (const Gap& gap : gaps) {
            const bool joins = gap.from <= to;
            if (joins && std::max(to, gap.to) - from > std::max(gap.most, kept.back().most))
                continue;
            from = joins ? from : gap.from;
            to = joins ? std::max(to, gap.to) : gap.to;
            kept.push_back(gap);
        }
        gaps = std::move(kept);
    }

    static double n_points(const Curve& curve) {
        return static_cast<double>(curve.geometry->points.size());
    }
    static std::pair<double, double> range_of(const Curve& curve) {
        const double n = n_points(curve);
        const double end = curve.geometry->closed ? n : n - 1.0;
        return {std::clamp(curve.first, 0.0, end), std::clamp(curve.last, 0.0, end)};
    }

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, Piece piece) {
        const Projected from = project(view_, a), to = project(view_, b);
        if (!(from.depth > 0.0 && to.depth > 0.0)) return;
        piece.a = from.px;
        piece.b = to.px;
        piece.depth_a = from.depth;
        piece.depth_b = to.depth;
        const auto number = static_cast<int>(pieces_.size());
        pieces_.push_back(piece);
        const auto cell = [](double px) { return static_cast<int>(std::floor(px / cell_px)); };
        for (int i = cell(std::min(piece.a.x(), piece.b.x()));
             i <= cell(std::max(piece.a.x(), piece.b.x())); ++i)
            for (int j = cell(std::min(piece.a.y(), piece.b.y()));
                 j <= cell(std::max(piece.a.y(), piece.b.y())); ++j)
                cells_[{i, j}].push_back(number);
    }

    void add_curve(int number) {
        const Curve& curve = view_.curves[static_cast<std::size_t>(number)];
        if (curve.geometry == nullptr || !(curve.opacity > 0.0)) return;
        // Leaders of labels are not objects in space.
        if (curve.occlusion == Occlusion::none) return;
        const auto& points = curve.geometry->points;
        // A path of many rounds crosses everything everywhere, and is drawn once for all frames.
        constexpr std::size_t most_points = 20'000;
        if (curve.lasting && points.size() > most_points) return;
        const auto [first, last] = range_of(curve);
        if (!(last > first)) return;
        constexpr double most_pieces = 1200.0;
        const double stride = std::max(1.0, std::ceil((last - first) / most_pieces));
        const auto at = [&](double s) -> Eigen::Vector3d {
            const double whole = std::floor(s);
            const auto k = static_cast<std::size_t>(whole);
            const Eigen::Vector3d& a = points[k % points.size()];
            const Eigen::Vector3d& b = points[(k + 1) % points.size()];
            return curve.placement * (s > whole ? Eigen::Vector3d(a + (s - whole) * (b - a)) : a);
        };
        for (double s = first; s < last; s += stride) {
            const double to = std::min(s + stride, last);
            add(at(s), at(to), {.from = s, .to = to, .width_px = curve.width_px, .curve = number});
        }
    }

    void add_arrow(const Arrow& arrow) {
        if (!(arrow.opacity > 0.0)) return;
        constexpr int n = 32;
        const double length_px = (arrow.tip - arrow.tail).norm() * unit_px_of(view_);
        for (int k = 0; k < n; ++k) {
            // The head's width, where the piece is part of it.
            const double to_tip_px = length_px * (1.0 - (k + 0.5) / n);
            const double head = to_tip_px / std::max(arrow.head_length_px, 1e-9);
            add(arrow.tail + (arrow.tip - arrow.tail) * k / n,
                arrow.tail + (arrow.tip - arrow.tail) * (k + 1) / n,
                {.width_px = head < 1.0 ? head * arrow.head_px : arrow.shaft_px});
        }
    }

    void find() {
        for (const auto& [cell, numbers] : cells_)
            for (std::size_t i = 0; i < numbers.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    meet(pieces_[at(numbers[i])], pieces_[at(numbers[j])]);
    }
    static std::size_t at(int number) { return static_cast<std::size_t>(number); }

    void meet(const Piece& p, const Piece& q) {
        const Eigen::Vector2d u = p.b - p.a, v = q.b - q.a, w = q.a - p.a;
        const double area = u.x() * v.y() - u.y() * v.x();
        const double sine = std::abs(area) / std::max(u.norm() * v.norm(), 1e-12);
        // Lines that are nearly parallel in the picture do not cross.
        constexpr double least_sine = 0.15;
        if (sine < least_sine) return;
        const double s = (w.x() * v.y() - w.y() * v.x()) / area;
        const double t = (w.x() * u.y() - w.y() * u.x()) / area;
        if (s < 0.0 || s >= 1.0 || t < 0.0 || t >= 1.0) return;
        const double depth_p = p.depth_a + s * (p.depth_b - p.depth_a);
        const double depth_q = q.depth_a + t * (q.depth_b - q.depth_a);
        // Lines that meet in space get no gap, such as an arrow and the curve on which it ends.
        constexpr double touching = 0.012;
        if (std::abs(depth_p - depth_q) < touching * std::min(depth_p, depth_q)) return;
        const bool p_is_lower = depth_p > depth_q;
        const Piece& lower = p_is_lower ? p : q;
        const Piece& upper = p_is_lower ? q : p;
        if (lower.curve < 0) return;
        const double gap_px = std::max(least_gap_px_, 0.8 * lower.width_px);
        // A flat crossing would take a long piece out of the line.
        constexpr double most_widths = 3.0;
        const double straight_px = 0.5 * upper.width_px + gap_px;
        const double most_px = std::max(straight_px, 0.5 * most_widths * lower.width_px);
        const double half_px = std::min(straight_px / sine, most_px);
        // At the contact point, where both curves and ω meet, every line is whole.
        const Eigen::Vector2d at_px = p.a + s * u;
        for (const Eigen::Vector2d& contact : contacts_px_)
            if ((at_px - contact).norm() - half_px < most_widths * lower.width_px) return;
        const double length_px = (lower.b - lower.a).norm();
        const double there = lower.from + (p_is_lower ? s : t) * (lower.to - lower.from);
        const double per_px = (lower.to - lower.from) / std::max(length_px, 1e-9);
        gaps_[lower.curve].push_back(
            {there - half_px * per_px, there + half_px * per_px, 2.0 * most_px * per_px});
    }

    static constexpr double cell_px = 24.0;
    const View& view_;
    double least_gap_px_;
    std::vector<Piece> pieces_;
    std::map<std::pair<int, int>, std::vector<int>> cells_;
    std::map<int, std::vector<Gap>> gaps_;
    std::vector<Eigen::Vector2d> contacts_px_;
};

void break_crossings(const LineStyleRules& rules, View& view) {
    constexpr double gap = 3.0;
    const Crossing crossing(view, gap * rules.px);
    std::vector<Curve> curves;
    curves.reserve(view.curves.size());
    for (std::size_t k = 0; k < view.curves.size(); ++k)
        crossing.add_parts(static_cast<int>(k), curves);
    view.curves = std::move(curves);
}

void raise(double& width_px, double least_px) {
    if (width_px > 0.0) width_px = std::max(width_px, least_px);
}

void thicken(double least_px, View& view) {
    for (Ellipsoid& ellipsoid : view.ellipsoids) {
        raise(ellipsoid.section_px, least_px);
        raise(ellipsoid.ruling_px, least_px);
        raise(ellipsoid.contour_px, least_px);
    }
    for (Plane& plane : view.planes) raise(plane.grid_px, least_px);
    // A cone's rulings are thinner than its rim.
    constexpr double ruling_share = 0.6;
    for (Cone& cone : view.cones) raise(cone.rim_px, least_px / ruling_share);
    for (Curve& curve : view.curves) {
        raise(curve.width_px, least_px);
        const double least_share = std::min(1.0, least_px / std::max(curve.width_px, 1e-9));
        curve.hidden_share = std::max(curve.hidden_share, least_share);
    }
    for (Arrow& arrow : view.arrows) raise(arrow.shaft_px, least_px);
    for (Dot& dot : view.dots) raise(dot.rim_px, least_px);
}

// The dashes of an arrow's shaft, as long as the gaps between them; the arrow itself if fewer than
// two dashes fit.
std::vector<Arrow> dashes_of(const View& view, const Arrow& arrow) {
    const double length = (arrow.tip - arrow.tail).norm();
    const double unit_px = unit_px_of(view);
    const double shaft_px = length * unit_px - arrow.head_length_px;
    const double n = std::floor(0.5 * (shaft_px / arrow.dash_px + 1.0));
    constexpr double fewest = 2.0, most = 2000.0;
    if (!(n >= fewest && n <= most)) return {arrow};
    const Eigen::Vector3d run = arrow.tip - arrow.tail;
    const double dash = shaft_px / (2.0 * n - 1.0) / (length * unit_px);
    std::vector<Arrow> dashes;
    for (double k = 0.0; k < n; ++k) {
        Arrow& part = dashes.emplace_back(arrow);
        part.dash_px = 0.0;
        part.tail = arrow.tail + 2.0 * k * dash * run;
        if (k == n - 1.0) continue;
        // A flat end, like the start: a head as wide as the shaft, of negligible length.
        part.tip = part.tail + dash * run;
        part.head_px = part.shaft_px;
        part.head_length_px = 0.01;
    }
    return dashes;
}

void break_shafts(View& view) {
    std::vector<Arrow> arrows;
    arrows.reserve(view.arrows.size());
    for (const Arrow& arrow : view.arrows) {
        if (!(arrow.dash_px > 0.0)) {
            arrows.push_back(arrow);
            continue;
        }
        const std::vector<Arrow> dashes = dashes_of(view, arrow);
        arrows.insert(arrows.end(), dashes.begin(), dashes.end());
    }
    view.arrows = std::move(arrows);
}

}  // namespace

void apply_line_style(const LineStyleRules& rules, View& view) {
    if (has_solids(view)) {
        if (rules.crossings == "gap") pierce_planes(rules, view);
        if (rules.hidden != "pale" || rules.hidden_arrows != "pale") style_hidden(rules, view);
        if (rules.crossings == "gap") break_crossings(rules, view);
    }
    if (rules.least_px > 0.0) thicken(rules.least_px, view);
    break_shafts(view);
}

}  // namespace poinsot
