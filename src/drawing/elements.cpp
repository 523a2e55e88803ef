#include "drawing/elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "drawing/direction_marks.h"
#include "drawing/figure_elements.h"
#include "drawing/ghost.h"
#include "drawing/marks.h"
#include "drawing/projection.h"
#include "drawing/trail.h"
#include "error/error.h"
#include "error/nearest.h"

namespace poinsot {

namespace {

// Index of the one ellipsoid and the one plane in the space view; see the order of the table.
constexpr int the_ellipsoid = 0;
constexpr int the_plane = 0;

bool always(const StageData&) { return true; }
bool never(const StageData&) { return false; }
bool has_cones(const StageData& stage) { return stage.rolling->cones.has_value(); }
bool has_curves(const StageData& stage) {
    return stage.rolling->polhode.kind() != Polhode::Kind::point;
}
bool has_beside(const StageData& stage) { return stage.beside.has_value(); }

const ConstructionPicture& picture_of(const Panel& panel) { return *panel.stage->rolling; }

// Far enough for the herpolhode, and so near that the rim towards us is seen: the panel has no hard
// edge, and the plane is faint where the caption stands.
double plane_radius(const Panel& panel) {
    const double wanted = std::max(2.4, 2.2 * picture_of(panel).herpolhode_radius);
    const double bottom_px = panel.box.y_px + panel.box.height_px;

    View view;
    view.x_px = panel.box.x_px, view.y_px = panel.box.y_px;
    view.width_px = panel.box.width_px, view.height_px = panel.box.height_px;
    view.camera = panel.camera;
    Eigen::Vector3d towards_us = panel.camera.eye - panel.camera.target;
    towards_us.z() = 0.0;
    if (!(towards_us.norm() > 0.0)) return wanted;
    const Eigen::Vector3d centre(0.0, 0.0, -picture_of(panel).plane_distance);
    const auto is_seen = [&](double radius) {
        const Eigen::Vector3d rim = centre + radius * towards_us.normalized();
        return project(view, rim).depth > 0.0 && project(view, rim).px.y() < bottom_px;
    };
    double seen = 0.0;
    double cut = wanted;
    for (int round = 0; round < 40 && !is_seen(wanted); ++round) {
        const double middle = 0.5 * (seen + cut);
        (is_seen(middle) ? seen : cut) = middle;
    }
    const double least = std::max(1.0, 1.3 * picture_of(panel).herpolhode_radius);
    return is_seen(wanted) ? wanted : std::max(seen, least);
}

// A plane ruled in circles about the foot of L. Seen from a camera that turns about L they stand
// still, where straight lines would turn, and lines that turned along would belie the rolling.
Drawer ringed(Panel& panel, Plane plane) {
    plane.grid_px = 0.0;
    std::vector<Curve> rings;
    for (int k = 1; k * plane.grid_spacing < plane.radius; ++k) {
        const double radius = k * plane.grid_spacing;
        const double share = (radius / plane.radius - plane.fade_from) / (1.0 - plane.fade_from);
        const double u = std::clamp(share, 0.0, 1.0);
        Curve ring =
            arc_about(panel, plane.centre, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                      radius, 2.0 * std::numbers::pi, plane.grid_colour, 1.1);
        ring.on_plane = the_plane;
        ring.opacity = plane.opacity * (1.0 - u * u * (3.0 - 2.0 * u));
        rings.push_back(ring);
    }
    return [plane, rings](const Instant&, Sheet& sheet) {
        sheet.view.planes.push_back(plane);
        sheet.view.curves.insert(sheet.view.curves.end(), rings.begin(), rings.end());
    };
}

Drawer make_plane(Panel& panel) {
    Plane plane;
    plane.centre = {0.0, 0.0, -picture_of(panel).plane_distance};
    plane.radius = plane_radius(panel);
    plane.grid_spacing = 0.2;
    plane.grid_px = 1.1 * panel.px;
    plane.colour = panel.stage->theme->plane;
    plane.grid_colour = panel.stage->theme->grid;
    plane.opacity = panel.stage->theme->plane_opacity;
    if (panel.stage->turns()) return ringed(panel, plane);
    return [plane](const Instant&, Sheet& sheet) { sheet.view.planes.push_back(plane); };
}

Drawer make_ellipsoid(Panel& panel) {
    const Ellipsoid ellipsoid = ellipsoid_of(panel);
    return [&panel, ellipsoid](const Instant& instant, Sheet& sheet) {
        sheet.view.ellipsoids.push_back(ellipsoid);
        sheet.view.ellipsoids.back().half_axes =
            picture_of(panel).principal_axes(instant) * picture_of(panel).half_axes.asDiagonal();
    };
}

// Between direction marks, in the largest half-axis; the same on both curves, which roll on each
// other.
constexpr double mark_spacing = 0.45;

// The contact point's path on the ellipsoid, and how much of it is shown.
Drawer make_polhode(Panel& panel) {
    const double per_rho = picture_of(panel).picture_per_rho;
    const double tolerance = 0.5 * panel.stage->scene.accuracy_px * panel.units_per_px / per_rho;
    const Polhode& polhode = picture_of(panel).polhode;
    const bool whole = panel.stage->scene.trail.polhode == "whole";
    CurveGeometry geometry;
    std::optional<Trail> trail;
    if (whole) {
        geometry.closed = polhode.closed();
        geometry.points = polhode.sampled(tolerance);
    } else {
        TimedCurve timed = polhode_trail(*panel.stage, tolerance);
        geometry.points = std::move(timed.points);
        trail = std::move(timed.trail);
        panel.stage->note_curve_error(timed.off * per_rho / panel.units_per_px);
    }
    for (Eigen::Vector3d& point : geometry.points) point *= per_rho;
    Curve curve;
    curve.geometry = panel.stage->keep(std::move(geometry));
    curve.width_px = 4.0 * panel.px;
    curve.colour = panel.stage->theme->polhode;
    curve.on_surface = the_ellipsoid;
    curve.hidden_opacity = 0.55;
    std::optional<DirectionMarks> marks;
    if (wants_marks(panel)) {
        marks.emplace(panel, *curve.geometry, mark_spacing,
                      whole && runs_backwards(panel, curve.geometry->points));
    }
    return [&panel, curve, trail, marks](const Instant& instant, Sheet& sheet) {
        Curve shown = curve;
        shown.placement.linear() = picture_of(panel).picture_from_body(instant).toRotationMatrix();
        ShownStretch stretch{0.0, curve.last, 0.0, false};
        if (trail) stretch = trail->at(instant.time_s);
        stretch.apply_to(shown);
        sheet.view.curves.push_back(shown);
        if (marks) marks->add_to(sheet, shown, stretch.grows);
    };
}

Drawer make_herpolhode(Panel& panel) {
    const ConstructionPicture& picture = picture_of(panel);
    const double tolerance = 0.5 * panel.stage->scene.accuracy_px * panel.units_per_px;
    TimedCurve timed = herpolhode_trail(*panel.stage, tolerance / picture.picture_per_rho);

    const Eigen::Vector3d foot =
        -picture.construction.plane_distance() * picture.construction.vertical_space();
    CurveGeometry geometry;
    geometry.points.reserve(timed.points.size());
    for (const Eigen::Vector3d& point : timed.points) {
        geometry.points.emplace_back(picture.picture_from_space * (foot + point) *
                                     picture.picture_per_rho);
    }
    panel.stage->note_curve_error(timed.off * picture.picture_per_rho / panel.units_per_px);
    Curve curve;
    curve.geometry = panel.stage->keep(std::move(geometry));
    curve.width_px = 4.0 * panel.px;
    curve.colour = panel.stage->theme->herpolhode;
    set_dashes(panel, panel.stage->theme->herpolhode_dashes, curve);
    curve.on_plane = the_plane;
    curve.hidden_opacity = 0.55;
    std::optional<DirectionMarks> marks;
    if (wants_marks(panel)) marks.emplace(panel, *curve.geometry, mark_spacing, false);
    return [curve, trail = std::move(timed.trail), marks](const Instant& instant, Sheet& sheet) {
        Curve shown = curve;
        const ShownStretch stretch = trail.at(instant.time_s);
        stretch.apply_to(shown);
        sheet.view.curves.push_back(shown);
        if (marks) marks->add_to(sheet, shown, stretch.grows);
    };
}

CurveGeometry circle_on_plane(const Panel& panel, double radius) {
    CurveGeometry circle;
    circle.closed = true;
    // The sagitta r(1 − cos(π/n)) stays below half of accuracy_px.
    const double tolerance = 0.5 * panel.stage->scene.accuracy_px * panel.units_per_px;
    const double least =
        std::numbers::pi / std::sqrt(2.0 * tolerance / std::max(radius, tolerance));
    const int n_points = static_cast<int>(std::clamp(std::ceil(least), 256.0, 65536.0));
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        circle.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                   -picture_of(panel).plane_distance);
    }
    return circle;
}

Drawer make_annulus(Panel& panel) {
    const Polhode::Annulus annulus = picture_of(panel).polhode.annulus();
    std::vector<Curve> circles;
    for (const double radius : {annulus.inner, annulus.outer}) {
        Curve curve;
        curve.geometry =
            panel.stage->keep(circle_on_plane(panel, radius * picture_of(panel).picture_per_rho));
        curve.width_px = 1.5 * panel.px;
        curve.colour = panel.stage->theme->annulus;
        curve.dash_px = 7.0 * panel.px;
        curve.on_plane = the_plane;
        circles.push_back(curve);
    }
    return [circles](const Instant&, Sheet& sheet) {
        sheet.view.curves.insert(sheet.view.curves.end(), circles.begin(), circles.end());
    };
}

Drawer make_momentum(Panel& panel) {
    const Arrow arrow =
        arrow_to(panel, {0.0, 0.0, momentum_length}, panel.stage->theme->momentum, 1.15);
    const SetType type = set_label(panel, "\\mathbf{L}");
    return [&panel, arrow, type](const Instant&, Sheet& sheet) {
        sheet.view.arrows.push_back(arrow);
        wish_at_tip(panel, arrow, type, sheet);
    };
}

Drawer make_omega(Panel& panel) {
    const SetType type = set_label(panel, "\\boldsymbol{\\omega}");
    return [&panel, type](const Instant& instant, Sheet& sheet) {
        const Arrow arrow = arrow_to(panel, omega_tip(-picture_of(panel).contact(instant)),
                                     panel.stage->theme->omega, 1.15);
        sheet.view.arrows.push_back(arrow);
        wish_at_tip(panel, arrow, type, sheet, omega_label_turn_rad);
    };
}

Drawer make_axes(Panel& panel) {
    std::array<SetType, 3> types;
    for (std::size_t i = 0; i < 3; ++i) {
        types[i] = set_label(panel, fmt::format("\\mathbf{{e}}_{}", i + 1), 0.85);
    }
    return [&panel, types](const Instant& instant, Sheet& sheet) {
        const Eigen::Matrix3d axes = picture_of(panel).principal_axes(instant);
        for (int i = 0; i < 3; ++i) {
            const double length = picture_of(panel).half_axes[i] + axis_overhang;
            const Arrow arrow =
                arrow_to(panel, axes.col(i) * length, panel.stage->theme->axes[i], 0.85);
            sheet.view.arrows.push_back(arrow);
            wish_at_tip(panel, arrow, types[static_cast<std::size_t>(i)], sheet,
                        axis_label_turn_rad);
        }
    };
}

Drawer make_contact(Panel& panel) {
    Dot dot = dot_at(panel, Eigen::Vector3d::Zero(), panel.stage->theme->contact);
    // It lies on both curves, and over them also where the ellipsoid is before it.
    dot.occlusion = Occlusion::none;
    return [&panel, dot](const Instant& instant, Sheet& sheet) {
        sheet.view.dots.push_back(dot);
        sheet.view.dots.back().at = picture_of(panel).contact(instant);
    };
}

Drawer make_cones(Panel& panel) {
    if (!picture_of(panel).cones) {
        throw InputError("show: cones need a body with exactly two equal moments; leave them out");
    }
    // Both cones stand on the centre and touch along the instantaneous axis −ω, on the contact
    // point's side.
    return [&panel, cones = *picture_of(panel).cones](const Instant& instant, Sheet& sheet) {
        const double reach = 0.98 * picture_of(panel).contact(instant).norm();
        const Eigen::Matrix3d axes = picture_of(panel).principal_axes(instant);
        const Eigen::Vector3d symmetry = axes.col(cones.symmetry_axis);
        Cone body;
        body.axis = picture_of(panel).contact(instant).dot(symmetry) < 0.0
                        ? Eigen::Vector3d(-symmetry)
                        : symmetry;
        body.half_angle_rad = cones.body_half_angle_rad;
        body.length = reach * std::cos(cones.body_half_angle_rad);
        body.colour = panel.stage->theme->body_cone;
        body.reference = axes.col((cones.symmetry_axis + 1) % 3);
        body.rim_px = 2.0 * panel.px;
        sheet.view.cones.push_back(body);

        Cone space;
        space.axis = -Eigen::Vector3d::UnitZ();
        space.half_angle_rad = cones.space_half_angle_rad;
        space.length = reach * std::cos(cones.space_half_angle_rad);
        space.colour = panel.stage->theme->space_cone;
        space.reference = Eigen::Vector3d::UnitX();
        space.rim_px = 2.0 * panel.px;
        sheet.view.cones.push_back(space);
    };
}

constexpr Quantities attitude{.attitude = true, .herpolhode = false, .euler_angles = false};

const std::array<Element, 20> table{{
    {"plane", "the invariable plane with its grid", always, omega_alone, make_plane},
    {"tangent", "the plane that touches the ellipsoid at ρ", never, attitude, make_tangent},
    {"ellipsoid", "the inertia ellipsoid with body-fixed lines", always, attitude, make_ellipsoid},
    {"body", "the body itself, inside its ellipsoid", never, attitude, make_body},
    {"annulus", "the ring that the herpolhode fills", never, omega_alone, make_annulus},
    {"polhode", "path of the contact point on the ellipsoid", has_curves, attitude, make_polhode},
    {"herpolhode", "path of the contact point on the plane", has_curves, omega_alone,
     make_herpolhode},
    {"cones", "body cone rolling on space cone (symmetric bodies)", has_cones, attitude,
     make_cones},
    {"momentum", "the angular momentum L", always, omega_alone, make_momentum},
    {"omega", "the angular velocity ω", always, attitude, make_omega},
    {"axes", "the principal axes e1, e2, e3", always, attitude, make_axes},
    {"given-axes", "the axes x, y, z that the scene's numbers are given in", never, attitude,
     make_given_axes},
    {"half-axes", "the half-axes 1/√I1, 1/√I2, 1/√I3 of the ellipsoid", never, attitude,
     make_half_axes},
    {"radius", "the radius vector ρ = ω/√(2T), F(ρ) = 1", never, attitude, make_radius},
    {"gradient", "∇F at ρ, along L", never, attitude, make_gradient},
    {"distance", "the plane's distance √(2T)/L from the centre", never, omega_alone, make_distance},
    {"precession", "Ω about the symmetry axis and L/I1 about L (symmetric bodies)", never, attitude,
     make_precession},
    {"contact", "the contact point", always, attitude, make_contact},
    {"ghost", "the ellipsoid and ω as the method beside has them", has_beside, omega_alone,
     make_ghost},
    {"drift", "path of the contact point by the method beside", has_beside, omega_alone,
     make_drift},
}};

}  // namespace

std::span<const Element> elements() { return table; }

const Element& element_named(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Element& element : elements()) {
        if (element.name == name) return element;
        names.push_back(element.name);
    }
    throw InputError(fmt::format("unknown element \"{}\" in show{}; choose from: {}",
                                 printable(name), did_you_mean(name, names),
                                 fmt::join(names, ", ")));
}

}  // namespace poinsot
