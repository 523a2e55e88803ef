#include "drawing/elements.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <numbers>

#include "construction/adaptive_curve.h"
#include "error/error.h"

namespace poinsot {

namespace {

// Index of the one ellipsoid and the one plane in the space view; see the order of the table.
constexpr int the_ellipsoid = 0;
constexpr int the_plane = 0;

std::uint64_t next_geometry_id() {
    // Identifiers only name uploads; which number a curve gets never reaches a pixel.
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

bool always(const StageData&) { return true; }
bool never(const StageData&) { return false; }
bool has_cones(const StageData& stage) { return stage.cones.has_value(); }
bool rolls(const StageData& stage) { return stage.polhode.kind() != Polhode::Kind::point; }

// Length of the arrows along L and ω beyond the ellipsoid's reach.
constexpr double momentum_length = 1.42;
constexpr double omega_length = 1.30;

Arrow arrow_to(const StageData& stage, const Eigen::Vector3d& tip, const Colour& colour,
               double weight) {
    Arrow arrow;
    arrow.tip = tip;
    arrow.colour = colour;
    arrow.shaft_px = 4.0 * weight * stage.px;
    arrow.head_px = 16.0 * weight * stage.px;
    arrow.head_length_px = 26.0 * weight * stage.px;
    // A short arrow keeps its proportions: the head is at most two fifths of it.
    const double length_px = tip.norm() / stage.units_per_px;
    const double scale = std::min(1.0, 0.4 * length_px / arrow.head_length_px);
    arrow.shaft_px *= scale;
    arrow.head_px *= scale;
    arrow.head_length_px *= scale;
    return arrow;
}

void draw_plane(const StageData& stage, const Instant&, View& view) {
    Plane plane;
    plane.centre = {0.0, 0.0, -stage.plane_distance};
    plane.radius = std::max(2.4, 2.2 * stage.herpolhode_radius);
    plane.grid_spacing = 0.2;
    plane.grid_px = 1.1 * stage.px;
    plane.colour = stage.theme->plane;
    plane.grid_colour = stage.theme->grid;
    plane.opacity = stage.theme->plane_opacity;
    view.planes.push_back(plane);
}

void draw_ellipsoid(const StageData& stage, const Instant& instant, View& view) {
    Ellipsoid ellipsoid;
    const Eigen::Matrix3d axes = instant.picture_from_body.toRotationMatrix() *
                                 stage.construction.inertia().body_from_principal();
    ellipsoid.half_axes = axes * stage.half_axes.asDiagonal();
    ellipsoid.colour = stage.theme->ellipsoid;
    ellipsoid.opacity = stage.theme->ellipsoid_opacity;
    ellipsoid.line_colour = stage.theme->ellipsoid_lines;
    ellipsoid.section_px = 1.7 * stage.px;
    ellipsoid.ruling_px = 0.9 * stage.px;
    view.ellipsoids.push_back(ellipsoid);
}

void prepare_polhode(StageData& stage) {
    stage.polhode_curve.id = next_geometry_id();
    stage.polhode_curve.closed = stage.polhode.closed();
    const double tolerance = 0.5 * stage.scene.accuracy_px * stage.units_per_px;
    for (const Eigen::Vector3d& point : stage.polhode.sampled(tolerance / stage.picture_per_rho)) {
        stage.polhode_curve.points.emplace_back(point * stage.picture_per_rho);
    }
}

void draw_polhode(const StageData& stage, const Instant& instant, View& view) {
    Curve curve;
    curve.geometry = &stage.polhode_curve;
    curve.placement.linear() = instant.picture_from_body.toRotationMatrix();
    curve.width_px = 4.0 * stage.px;
    curve.colour = stage.theme->polhode;
    curve.on_surface = the_ellipsoid;
    curve.hidden_opacity = 0.45;
    view.curves.push_back(curve);
}

void prepare_herpolhode(StageData& stage) {
    stage.herpolhode_curve.id = next_geometry_id();
    const double tolerance = 0.5 * stage.scene.accuracy_px * stage.units_per_px;
    // ω turns about L by at most L/I_min − L/I_max a second faster than the body's own motion; a
    // turn takes this long.
    const double fastest = stage.construction.momentum_kg_m2_s() /
                           stage.construction.inertia().moments_kg_m2().minCoeff();
    const double feature_s = fastest > 0.0 ? std::numbers::pi / fastest : 1.0;
    stage.herpolhode =
        sample_herpolhode(stage.construction, *stage.motion, stage.options.first_time_s,
                          stage.options.last_time_s, feature_s, tolerance / stage.picture_per_rho);
    stage.herpolhode_curve.points.reserve(stage.herpolhode.points.size());
    for (const Eigen::Vector3d& point : stage.herpolhode.points) {
        stage.herpolhode_curve.points.emplace_back(stage.picture_from_space * point *
                                                   stage.picture_per_rho);
    }
}

void draw_herpolhode(const StageData& stage, const Instant& instant, View& view) {
    Curve curve;
    curve.geometry = &stage.herpolhode_curve;
    curve.last = stage.herpolhode.index_at(instant.time_s);
    curve.width_px = 4.0 * stage.px;
    curve.colour = stage.theme->herpolhode;
    curve.on_plane = the_plane;
    curve.hidden_opacity = 0.45;
    view.curves.push_back(curve);
}

CurveGeometry circle_on_plane(const StageData& stage, double radius) {
    CurveGeometry circle;
    circle.id = next_geometry_id();
    circle.closed = true;
    constexpr int n_points = 256;
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        circle.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                   -stage.plane_distance);
    }
    return circle;
}

void prepare_annulus(StageData& stage) {
    const Polhode::Annulus annulus = stage.polhode.annulus();
    stage.annulus_inner = circle_on_plane(stage, annulus.inner * stage.picture_per_rho);
    stage.annulus_outer = circle_on_plane(stage, annulus.outer * stage.picture_per_rho);
}

void draw_annulus(const StageData& stage, const Instant&, View& view) {
    for (const CurveGeometry* circle : {&stage.annulus_inner, &stage.annulus_outer}) {
        Curve curve;
        curve.geometry = circle;
        curve.width_px = 1.5 * stage.px;
        curve.colour = stage.theme->annulus;
        curve.dash_px = 7.0 * stage.px;
        curve.on_plane = the_plane;
        view.curves.push_back(curve);
    }
}

void draw_momentum(const StageData& stage, const Instant&, View& view) {
    view.arrows.push_back(
        arrow_to(stage, {0.0, 0.0, momentum_length}, stage.theme->momentum, 1.15));
}

void draw_omega(const StageData& stage, const Instant& instant, View& view) {
    const Eigen::Vector3d direction = -instant.contact;
    const double length = omega_length * std::max(1.0, 1.0 / direction.norm());
    view.arrows.push_back(arrow_to(stage, direction * length, stage.theme->omega, 1.15));
}

void draw_axes(const StageData& stage, const Instant& instant, View& view) {
    const Eigen::Matrix3d axes = instant.picture_from_body.toRotationMatrix() *
                                 stage.construction.inertia().body_from_principal();
    for (int i = 0; i < 3; ++i) {
        const double length = stage.half_axes[i] + 0.28;
        view.arrows.push_back(arrow_to(stage, axes.col(i) * length, stage.theme->axes[i], 0.85));
    }
}

void draw_contact(const StageData& stage, const Instant& instant, View& view) {
    Dot dot;
    dot.at = instant.contact;
    dot.radius_px = 6.5 * stage.px;
    dot.rim_px = 1.6 * stage.px;
    dot.colour = stage.theme->contact;
    dot.rim_colour = stage.theme->halo;
    dot.hidden_opacity = 0.8;
    view.dots.push_back(dot);
}

void draw_cones(const StageData& stage, const Instant& instant, View& view) {
    // Both cones stand on the centre and touch along the instantaneous axis −ω, on the contact
    // point's side.
    const RollingCones& cones = *stage.cones;
    const double reach = 0.98 * instant.contact.norm();
    const Eigen::Matrix3d axes = instant.picture_from_body.toRotationMatrix() *
                                 stage.construction.inertia().body_from_principal();
    const Eigen::Vector3d symmetry = axes.col(cones.symmetry_axis);
    Cone body;
    body.axis = instant.contact.dot(symmetry) < 0.0 ? Eigen::Vector3d(-symmetry) : symmetry;
    body.half_angle_rad = cones.body_half_angle_rad;
    body.length = reach * std::cos(cones.body_half_angle_rad);
    body.colour = stage.theme->body_cone;
    body.reference = axes.col((cones.symmetry_axis + 1) % 3);
    body.rim_px = 2.0 * stage.px;
    view.cones.push_back(body);

    Cone space;
    space.axis = -Eigen::Vector3d::UnitZ();
    space.half_angle_rad = cones.space_half_angle_rad;
    space.length = reach * std::cos(cones.space_half_angle_rad);
    space.colour = stage.theme->space_cone;
    space.reference = Eigen::Vector3d::UnitX();
    space.rim_px = 2.0 * stage.px;
    view.cones.push_back(space);
}

const std::array<Element, 10> table{{
    {"plane", "the invariable plane with its grid", always, nullptr, draw_plane},
    {"ellipsoid", "the inertia ellipsoid with body-fixed lines", always, nullptr, draw_ellipsoid},
    {"annulus", "the ring that the herpolhode fills", never, prepare_annulus, draw_annulus},
    {"polhode", "path of the contact point on the ellipsoid", rolls, prepare_polhode, draw_polhode},
    {"herpolhode", "path of the contact point on the plane", rolls, prepare_herpolhode,
     draw_herpolhode},
    {"cones", "body cone rolling on space cone (symmetric bodies)", has_cones, nullptr, draw_cones},
    {"momentum", "the angular momentum L", always, nullptr, draw_momentum},
    {"omega", "the angular velocity ω", always, nullptr, draw_omega},
    {"axes", "the principal axes e1, e2, e3", always, nullptr, draw_axes},
    {"contact", "the contact point", always, nullptr, draw_contact},
}};

}  // namespace

std::span<const Element> elements() { return table; }

const Element& element_named(std::string_view name) {
    std::string known;
    for (const Element& element : elements()) {
        if (element.name == name) return element;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", element.name);
    }
    throw InputError(fmt::format("unknown element \"{}\" in show; choose from: {}", name, known));
}

}  // namespace poinsot
