#include "drawing/elements.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "drawing/labels.h"
#include "drawing/live_text.h"
#include "drawing/projection.h"
#include "error/error.h"

namespace poinsot {

namespace {

// Index of the one ellipsoid and the one plane in the space view; see the order of the table.
constexpr int the_ellipsoid = 0;
constexpr int the_plane = 0;

// The numbers that a caption may name.
std::array<LiveValue, 5> live_values(const StageData& stage, const Instant& instant) {
    const Eigen::Vector3d& omega = instant.state.omega_body;
    return {{{"time_s", instant.time_s},
             {"omega_1_rad_s", omega[0]},
             {"omega_2_rad_s", omega[1]},
             {"omega_3_rad_s", omega[2]},
             {"kinetic_energy_J", stage.construction.kinetic_energy_J()}}};
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

Eigen::Matrix3d principal_axes(const StageData& stage, const Instant& instant) {
    return instant.picture_from_body.toRotationMatrix() *
           stage.construction.inertia().body_from_principal();
}

Drawer make_plane(StageData& stage) {
    Plane plane;
    plane.centre = {0.0, 0.0, -stage.plane_distance};
    plane.radius = std::max(2.4, 2.2 * stage.herpolhode_radius);
    plane.grid_spacing = 0.2;
    plane.grid_px = 1.1 * stage.px;
    plane.colour = stage.theme->plane;
    plane.grid_colour = stage.theme->grid;
    plane.opacity = stage.theme->plane_opacity;
    return [plane](const Instant&, Sheet& sheet) { sheet.view.planes.push_back(plane); };
}

Drawer make_ellipsoid(StageData& stage) {
    Ellipsoid ellipsoid;
    ellipsoid.colour = stage.theme->ellipsoid;
    ellipsoid.opacity = stage.theme->ellipsoid_opacity;
    ellipsoid.line_colour = stage.theme->ellipsoid_lines;
    ellipsoid.section_px = 1.7 * stage.px;
    ellipsoid.ruling_px = 0.9 * stage.px;
    return [&stage, ellipsoid](const Instant& instant, Sheet& sheet) {
        sheet.view.ellipsoids.push_back(ellipsoid);
        sheet.view.ellipsoids.back().half_axes =
            principal_axes(stage, instant) * stage.half_axes.asDiagonal();
    };
}

Drawer make_polhode(StageData& stage) {
    CurveGeometry geometry;
    geometry.closed = stage.polhode.closed();
    const double tolerance = 0.5 * stage.scene.accuracy_px * stage.units_per_px;
    for (const Eigen::Vector3d& point : stage.polhode.sampled(tolerance / stage.picture_per_rho)) {
        geometry.points.emplace_back(point * stage.picture_per_rho);
    }
    Curve curve;
    curve.geometry = stage.keep(std::move(geometry));
    curve.width_px = 4.0 * stage.px;
    curve.colour = stage.theme->polhode;
    curve.on_surface = the_ellipsoid;
    curve.hidden_opacity = 0.45;
    return [curve](const Instant& instant, Sheet& sheet) {
        sheet.view.curves.push_back(curve);
        sheet.view.curves.back().placement.linear() = instant.picture_from_body.toRotationMatrix();
    };
}

Drawer make_herpolhode(StageData& stage) {
    // ω turns about L at most at L/I_min; half a turn at that rate is surely one piece of the
    // curve.
    const double fastest = stage.construction.momentum_kg_m2_s() /
                           stage.construction.inertia().moments_kg_m2().minCoeff();
    const double feature_s = fastest > 0.0 ? std::numbers::pi / fastest : 1.0;
    const double tolerance = 0.5 * stage.scene.accuracy_px * stage.units_per_px;
    Herpolhode herpolhode =
        sample_herpolhode(stage.construction, *stage.motion, stage.options.first_time_s,
                          stage.options.last_time_s, feature_s, tolerance / stage.picture_per_rho);

    CurveGeometry geometry;
    geometry.points.reserve(herpolhode.points.size());
    for (const Eigen::Vector3d& point : herpolhode.points) {
        geometry.points.emplace_back(stage.picture_from_space * point * stage.picture_per_rho);
    }
    herpolhode.points.clear();
    Curve curve;
    curve.geometry = stage.keep(std::move(geometry));
    curve.width_px = 4.0 * stage.px;
    curve.colour = stage.theme->herpolhode;
    curve.on_plane = the_plane;
    curve.hidden_opacity = 0.45;
    return [curve, herpolhode = std::move(herpolhode)](const Instant& instant, Sheet& sheet) {
        sheet.view.curves.push_back(curve);
        sheet.view.curves.back().last = herpolhode.index_at(instant.time_s);
    };
}

CurveGeometry circle_on_plane(const StageData& stage, double radius) {
    CurveGeometry circle;
    circle.closed = true;
    constexpr int n_points = 256;
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        circle.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                   -stage.plane_distance);
    }
    return circle;
}

Drawer make_annulus(StageData& stage) {
    const Polhode::Annulus annulus = stage.polhode.annulus();
    std::vector<Curve> circles;
    for (const double radius : {annulus.inner, annulus.outer}) {
        Curve curve;
        curve.geometry = stage.keep(circle_on_plane(stage, radius * stage.picture_per_rho));
        curve.width_px = 1.5 * stage.px;
        curve.colour = stage.theme->annulus;
        curve.dash_px = 7.0 * stage.px;
        curve.on_plane = the_plane;
        circles.push_back(curve);
    }
    return [circles](const Instant&, Sheet& sheet) {
        sheet.view.curves.insert(sheet.view.curves.end(), circles.begin(), circles.end());
    };
}

// The label of an arrow: at its tip, on the side that it points to.
void wish_at_tip(const StageData& stage, const Arrow& arrow, const SetType& type, Sheet& sheet) {
    const Projected tip = project(sheet.view, arrow.tip);
    const Projected tail = project(sheet.view, arrow.tail);
    LabelWish wish;
    wish.type = type;
    wish.anchor_px = tip.px;
    wish.away = (tip.px - tail.px) / (100.0 * stage.px);
    wish.gap_px = 9.0 * stage.px;
    wish.colour = arrow.colour;
    sheet.wishes.push_back(wish);
}

constexpr double label_size = 34.0;  // px per em at 1080 rows

Drawer make_momentum(StageData& stage) {
    const Arrow arrow = arrow_to(stage, {0.0, 0.0, momentum_length}, stage.theme->momentum, 1.15);
    const SetType type = stage.type_case.set("\\mathbf{L}", {.size_px = label_size * stage.px});
    return [&stage, arrow, type](const Instant&, Sheet& sheet) {
        sheet.view.arrows.push_back(arrow);
        wish_at_tip(stage, arrow, type, sheet);
    };
}

Drawer make_omega(StageData& stage) {
    const SetType type =
        stage.type_case.set("\\boldsymbol{\\omega}", {.size_px = label_size * stage.px});
    return [&stage, type](const Instant& instant, Sheet& sheet) {
        const Eigen::Vector3d direction = -instant.contact;
        const double length = omega_length * std::max(1.0, 1.0 / direction.norm());
        const Arrow arrow = arrow_to(stage, direction * length, stage.theme->omega, 1.15);
        sheet.view.arrows.push_back(arrow);
        wish_at_tip(stage, arrow, type, sheet);
    };
}

Drawer make_axes(StageData& stage) {
    std::array<SetType, 3> types;
    for (std::size_t i = 0; i < 3; ++i) {
        types[i] = stage.type_case.set(fmt::format("\\mathbf{{e}}_{}", i + 1),
                                       {.size_px = 0.85 * label_size * stage.px});
    }
    return [&stage, types](const Instant& instant, Sheet& sheet) {
        const Eigen::Matrix3d axes = principal_axes(stage, instant);
        for (int i = 0; i < 3; ++i) {
            const double length = stage.half_axes[i] + 0.28;
            const Arrow arrow = arrow_to(stage, axes.col(i) * length, stage.theme->axes[i], 0.85);
            sheet.view.arrows.push_back(arrow);
            wish_at_tip(stage, arrow, types[static_cast<std::size_t>(i)], sheet);
        }
    };
}

Drawer make_contact(StageData& stage) {
    Dot dot;
    dot.radius_px = 6.5 * stage.px;
    dot.rim_px = 1.6 * stage.px;
    dot.colour = stage.theme->contact;
    dot.rim_colour = stage.theme->halo;
    dot.hidden_opacity = 0.8;
    return [dot](const Instant& instant, Sheet& sheet) {
        sheet.view.dots.push_back(dot);
        sheet.view.dots.back().at = instant.contact;
    };
}

Drawer make_cones(StageData& stage) {
    if (!stage.cones) {
        throw InputError("show: cones need a body with exactly two equal moments; leave them out");
    }
    // Both cones stand on the centre and touch along the instantaneous axis −ω, on the contact
    // point's side.
    return [&stage, cones = *stage.cones](const Instant& instant, Sheet& sheet) {
        const double reach = 0.98 * instant.contact.norm();
        const Eigen::Matrix3d axes = principal_axes(stage, instant);
        const Eigen::Vector3d symmetry = axes.col(cones.symmetry_axis);
        Cone body;
        body.axis = instant.contact.dot(symmetry) < 0.0 ? Eigen::Vector3d(-symmetry) : symmetry;
        body.half_angle_rad = cones.body_half_angle_rad;
        body.length = reach * std::cos(cones.body_half_angle_rad);
        body.colour = stage.theme->body_cone;
        body.reference = axes.col((cones.symmetry_axis + 1) % 3);
        body.rim_px = 2.0 * stage.px;
        sheet.view.cones.push_back(body);

        Cone space;
        space.axis = -Eigen::Vector3d::UnitZ();
        space.half_angle_rad = cones.space_half_angle_rad;
        space.length = reach * std::cos(cones.space_half_angle_rad);
        space.colour = stage.theme->space_cone;
        space.reference = Eigen::Vector3d::UnitX();
        space.rim_px = 2.0 * stage.px;
        sheet.view.cones.push_back(space);
    };
}

// Running text at a corner of the picture; its pen starts at whole pixels.
void add_text(const StageData& stage, const SetType& type, double pen_x, double baseline_y,
              Sheet& sheet) {
    if (type.mask->width == 0) return;
    Label label;
    label.mask = type.mask;
    label.top_left_px = {std::round(pen_x) + type.left_px,
                         std::round(baseline_y) - type.baseline_px};
    label.colour = stage.theme->text;
    label.halo_colour = stage.theme->halo;
    label.halo_px = 2.0 * stage.px;
    sheet.view.labels.push_back(label);
}

double margin(const StageData& stage) { return 40.0 * stage.px; }

TypeStyle text_style(const StageData& stage, double size) {
    return {.size_px = size * stage.px,
            .mode = TypeMode::text,
            .max_width_px = std::max(64.0, stage.options.width_px - 2.0 * margin(stage))};
}

Drawer make_title(StageData& stage) {
    const SetType type = stage.type_case.set(stage.scene.title, text_style(stage, 40.0));
    return [&stage, type](const Instant&, Sheet& sheet) {
        add_text(stage, type, margin(stage), margin(stage) + type.baseline_px, sheet);
    };
}

Drawer make_caption(StageData& stage) {
    const TypeStyle style = text_style(stage, 26.0);
    const auto place = [&stage](const SetType& type, Sheet& sheet) {
        const double top = stage.options.height_px - margin(stage) - type.mask->height;
        add_text(stage, type, margin(stage), top + type.baseline_px, sheet);
    };
    if (!is_live(stage.scene.caption)) {
        const SetType type = stage.type_case.set(expand_live_text(stage.scene.caption, {}), style);
        return [place, type](const Instant&, Sheet& sheet) { place(type, sheet); };
    }
    return [&stage, style, place](const Instant& instant, Sheet& sheet) {
        const auto values = live_values(stage, instant);
        place(stage.type_case.set_live(expand_live_text(stage.scene.caption, values), style,
                                       sheet.view),
              sheet);
    };
}

Drawer make_clock(StageData& stage) {
    return [&stage](const Instant& instant, Sheet& sheet) {
        const auto values = live_values(stage, instant);
        const SetType type = stage.type_case.set_live(
            expand_live_text("$t$ = {time_s:.2f} s", values), text_style(stage, 26.0), sheet.view);
        // Right-aligned on the widest text of its kind, so that changing digits do not move it.
        const double pen = stage.options.width_px - margin(stage) - 160.0 * stage.px;
        add_text(stage, type, pen, margin(stage) + 26.0 * stage.px, sheet);
    };
}

bool has_title(const StageData& stage) { return !stage.scene.title.empty(); }
bool has_caption(const StageData& stage) { return !stage.scene.caption.empty(); }

const std::array<Element, 13> table{{
    {"plane", "the invariable plane with its grid", always, make_plane},
    {"ellipsoid", "the inertia ellipsoid with body-fixed lines", always, make_ellipsoid},
    {"annulus", "the ring that the herpolhode fills", never, make_annulus},
    {"polhode", "path of the contact point on the ellipsoid", rolls, make_polhode},
    {"herpolhode", "path of the contact point on the plane", rolls, make_herpolhode},
    {"cones", "body cone rolling on space cone (symmetric bodies)", has_cones, make_cones},
    {"momentum", "the angular momentum L", always, make_momentum},
    {"omega", "the angular velocity ω", always, make_omega},
    {"axes", "the principal axes e1, e2, e3", always, make_axes},
    {"contact", "the contact point", always, make_contact},
    {"title", "the scene's title", has_title, make_title},
    {"caption", "the scene's caption", has_caption, make_caption},
    {"clock", "the time of the instant shown", always, make_clock},
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
