#include "drawing/stage/drawing_primitives.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing/style/colour_vision.h"
#include "numerics/smooth_step.h"
#include "numerics/srgb.h"
#include "shapes/projection.h"

namespace poinsot {

Eigen::Vector3d omega_tip(const Eigen::Vector3d& rho) {
    constexpr double omega_length = 1.30;
    return rho * (omega_length * std::max(1.0, 1.0 / rho.norm()));
}

Eigen::Vector3d past_contact(const Eigen::Vector3d& rho) {
    constexpr double beyond = 0.2;
    return rho + beyond * rho.stableNormalized();
}

Eigen::Vector3d spin_axis_end(const Eigen::Vector3d& rho) {
    // Less than L beyond the plane, so that the head of L is seen where both are along one line.
    constexpr double beyond = 0.26;
    return rho + beyond * rho.stableNormalized();
}

Eigen::Vector3d momentum_tip(const ConstructionPicture& picture) {
    return (picture.plane_distance + momentum_beyond_plane) * picture.normal;
}

Arrow arrow_between(const Panel& panel, const Eigen::Vector3d& tail, const Eigen::Vector3d& tip,
                    const LineStyle& ink, double weight) {
    Arrow arrow;
    arrow.tail = tail;
    arrow.tip = tip;
    arrow.colour = ink;
    weight *= ink.weight;
    arrow.shaft_px = 4.0 * weight * panel.px;
    arrow.head_px = 16.0 * weight * panel.px;
    arrow.head_length_px = 26.0 * weight * panel.px;
    const double length_px = (tip - tail).norm() / panel.units_per_px;
    const double scale = std::min(1.0, 0.4 * length_px / arrow.head_length_px);
    arrow.shaft_px *= scale;
    arrow.head_px *= scale;
    arrow.head_length_px *= scale;
    arrow.dash_px = dash_of(panel, ink);
    return arrow;
}

void mark_arrows_at_viewer(const Panel& panel, View& view) {
    // Excludes heads of arcs, and arrows hardly longer than their heads.
    const double least_length_px = 80.0 * panel.px;
    for (Arrow& arrow : view.arrows) {
        const Projected tip = project(view, arrow.tip);
        const Eigen::Vector3d way = arrow.tip - arrow.tail;
        const double length_px = way.norm() / units_per_pixel(view, tip.depth);
        if (!(length_px > least_length_px) || !(arrow.opacity > 0.0)) continue;
        const Eigen::Vector3d to_eye =
            view.camera.orthographic ? Eigen::Vector3d(camera_axes(view.camera).col(2))
                                     : Eigen::Vector3d((view.camera.eye - arrow.tip).normalized());
        if (!(way.dot(to_eye) > 0.5 * way.norm())) continue;
        const double seen_px = (tip.px - project(view, arrow.tail).px).norm();
        const double presence = smooth_step(1.6 - seen_px / (0.75 * arrow.head_length_px));
        if (!(presence > 0.0)) continue;
        Dot ring;
        ring.at = arrow.tip;
        ring.radius_px = 0.62 * arrow.head_px;
        ring.rim_px = 0.2 * arrow.head_px;
        ring.colour = panel.stage->theme.halo;
        ring.rim_colour = arrow.colour;
        ring.opacity = presence * arrow.opacity;
        ring.hidden_opacity = arrow.hidden_opacity;
        ring.name = {arrow.name.element, arrow.name.number, "ring"};
        Dot point = ring;
        point.at += 1e-3 * to_eye;
        point.radius_px = 0.2 * arrow.head_px;
        point.rim_px = 0.0;
        point.colour = arrow.colour;
        view.dots.push_back(ring);
        view.dots.push_back(point);
        arrow.opacity *= 1.0 - presence;
    }
}

Ellipsoid ellipsoid_of(const Panel& panel) {
    Ellipsoid ellipsoid;
    ellipsoid.colour = panel.stage->theme.ellipsoid;
    ellipsoid.opacity = panel.stage->theme.ellipsoid_opacity;
    ellipsoid.line_colour = panel.stage->theme.ellipsoid_lines;
    ellipsoid.section_px = 1.7 * panel.px;
    ellipsoid.ruling_px = 0.9 * panel.px;
    add_contour(panel, panel.stage->theme.ellipsoid_lines, ellipsoid);
    return ellipsoid;
}

void add_contour(const Panel& panel, const Colour& line, Ellipsoid& ellipsoid) {
    // A line of one pixel that lies on two has half of its strength in each: 1.5 or more is left.
    constexpr double wanted = 3.5, flare = 0.05, least_px = 1.0;
    const Colour& ground = panel.stage->theme.halo;
    const double behind = relative_luminance(ground), own = relative_luminance(line);
    const double needed =
        own < behind ? (behind + flare) / wanted - flare : (behind + flare) * wanted - flare;
    const double share = std::clamp((needed - behind) / (own - behind), 0.0, 1.0);
    const auto mixed = [share](double from, double to) {
        const double light = linear_from_srgb(from);
        return srgb_from_linear(light + share * (linear_from_srgb(to) - light));
    };
    ellipsoid.contour_colour = {mixed(ground.r, line.r), mixed(ground.g, line.g),
                                mixed(ground.b, line.b)};
    ellipsoid.contour_px = std::max(panel.px, least_px);
}

Dot dot_at(const Panel& panel, const Eigen::Vector3d& at, const Colour& colour, double radius_px) {
    Dot dot;
    dot.at = at;
    dot.radius_px = radius_px * panel.px;
    dot.rim_px = 1.6 * panel.px;
    dot.colour = colour;
    dot.rim_colour = panel.stage->theme.halo;
    dot.hidden_opacity = 0.8;
    return dot;
}

double dash_of(const Panel& panel, const LineStyle& ink, double usual_px) {
    if (!ink.line) return usual_px * panel.px;
    switch (*ink.line) {
        case DashPattern::dashed:
            return 13.0 * panel.px;
        case DashPattern::dotted:
            return 4.0 * panel.px;
        default:
            return 0.0;
    }
}

Curve curve_of(const Panel& panel, const CurveGeometry* geometry, const LineStyle& ink,
               double width_px) {
    Curve curve;
    curve.geometry = geometry;
    curve.width_px = width_px * ink.weight * panel.px;
    curve.colour = ink;
    curve.dash_px = dash_of(panel, ink);
    return curve;
}

Curve arc_curve(const Panel& panel, const Arc& arc, const LineStyle& ink, double width_px) {
    const CurveGeometry* circle = panel.unit_circle;
    Curve curve = curve_of(panel, circle, ink, width_px);
    const Eigen::Vector3d across =
        arc.angle_rad < 0.0 ? Eigen::Vector3d(-arc.towards) : arc.towards;
    Eigen::Matrix3d axes;
    axes << arc.from, across, arc.from.cross(across);
    curve.placement.linear() = arc.radius * axes;
    curve.placement.translation() = arc.centre;
    const double turns = std::abs(arc.angle_rad) / (2.0 * std::numbers::pi);
    if (turns < 1.0) curve.last = turns * static_cast<double>(circle->points.size());
    if (!(arc.radius > 0.0)) curve.opacity = 0.0;
    return curve;
}

Curve line_between(const Panel& panel, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const LineStyle& ink, double width_px) {
    Curve line = curve_of(panel, panel.unit_segment, ink, width_px);
    const double length = (b - a).norm();
    if (!(length > 0.0)) {
        line.opacity = 0.0;
        return line;
    }
    const Eigen::Vector3d along = (b - a) / length;
    const Eigen::Vector3d across = along.unitOrthogonal();
    Eigen::Matrix3d axes;
    axes << along, across, along.cross(across);
    line.placement.linear() = length * axes;
    line.placement.translation() = a;
    return line;
}

double arc_head_rad(double radius) { return std::min(0.45, 0.12 / radius); }

void add_arc_arrow(const Panel& panel, const Turn& turn, const Eigen::Vector3d& from,
                   const LineStyle& ink, ViewBuilder& builder) {
    const Eigen::Vector3d towards = turn.axis.cross(from);
    builder.view.curves.push_back(arc_curve(panel,
                                            {.centre = turn.centre,
                                             .from = from,
                                             .towards = towards,
                                             .radius = turn.radius,
                                             .angle_rad = turn.angle_rad},
                                            ink, 3.2));
    const auto at = [&](double angle) {
        return Eigen::Vector3d(turn.centre +
                               turn.radius * (std::cos(angle) * from + std::sin(angle) * towards));
    };
    // The head follows the arc's end; the arc hides its shaft.
    const double head = std::copysign(arc_head_rad(turn.radius), turn.angle_rad);
    Arrow arrow = arrow_between(panel, at(turn.angle_rad - 0.2 * head),
                                at(turn.angle_rad + 0.8 * head), ink, 0.85);
    arrow.shaft_px = 3.2 * ink.weight * panel.px;
    builder.view.arrows.push_back(arrow);
}

}  // namespace poinsot
