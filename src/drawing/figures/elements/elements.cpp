#include "drawing/figures/elements/elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "drawing/stage/marks.h"
#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

// Elements that are defined in other files.
Drawer make_plane(Panel& panel);
Drawer make_polhode(Panel& panel);
Drawer make_herpolhode(Panel& panel);
Drawer make_annulus(Panel& panel);
Drawer make_given_axes(Panel& panel);
Drawer make_turn(Panel& panel);
Drawer make_half_axes(Panel& panel);
Drawer make_precession(Panel& panel);
Drawer make_body(Panel& panel);
Drawer make_momentum(Panel& panel);
Drawer make_omega(Panel& panel);
Drawer make_spin_axis(Panel& panel);
Drawer make_contact(Panel& panel);
Drawer make_radius(Panel& panel);
Drawer make_tangent(Panel& panel);
Drawer make_gradient(Panel& panel);
Drawer make_projection(Panel& panel);
Drawer make_distance(Panel& panel);
Drawer make_levels(Panel& panel);
Drawer make_velocity(Panel& panel);
Drawer make_ghost(Panel& panel);
Drawer make_drift(Panel& panel);

namespace {

bool always(const StageData&) { return true; }
bool never(const StageData&) { return false; }
bool has_cones(const StageData& stage) { return stage.rolling->cones.has_value(); }
bool has_curves(const StageData& stage) {
    return stage.rolling->dissipates || stage.rolling->polhode.kind() != Polhode::Kind::point;
}
bool has_comparison(const StageData& stage) { return stage.comparison.has_value(); }

Drawer make_ellipsoid(Panel& panel) {
    const Ellipsoid ellipsoid = ellipsoid_of(panel);
    return [&panel, ellipsoid](const FrameInput& instant, ViewBuilder& builder) {
        builder.view.ellipsoids.push_back(ellipsoid);
        builder.view.ellipsoids.back().half_axes =
            picture_of(panel).principal_axes(instant) * picture_of(panel).half_axes.asDiagonal();
    };
}

Drawer make_axes(Panel& panel) {
    std::array<TextBlock, 3> types;
    for (std::size_t i = 0; i < 3; ++i) {
        types[i] = set_label(panel, fmt::format("\\mathbf{{e}}_{}", i + 1), 0.85);
    }
    return [&panel, types](const FrameInput& instant, ViewBuilder& builder) {
        const Eigen::Matrix3d axes = picture_of(panel).principal_axes(instant);
        for (int i = 0; i < 3; ++i) {
            const double length = picture_of(panel).half_axes[i] + axis_overhang;
            const Arrow arrow =
                arrow_to(panel, axes.col(i) * length, panel.stage->theme->axes[i], 0.85);
            builder.view.arrows.push_back(arrow);
            wish_at_tip(panel, arrow, types[static_cast<std::size_t>(i)], builder,
                        axis_label_turn_rad);
        }
    };
}

Drawer make_cones(Panel& panel) {
    if (!picture_of(panel).cones) {
        throw InputError("show: cones need a body with exactly two equal moments; leave them out");
    }
    // Both cones have their apex at the centre and share a generator along ω that ends at the
    // plane: their rims touch at the contact point.
    return [&panel, cones = *picture_of(panel).cones](const FrameInput& instant,
                                                      ViewBuilder& builder) {
        const double reach = picture_of(panel).contact(instant).norm();
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
        builder.view.cones.push_back(body);

        Cone space;
        space.axis = picture_of(panel).normal;
        space.half_angle_rad = cones.space_half_angle_rad;
        space.length = reach * std::cos(cones.space_half_angle_rad);
        space.colour = panel.stage->theme->space_cone;
        space.reference = Eigen::Vector3d::UnitX();
        space.rim_px = 2.0 * panel.px;
        builder.view.cones.push_back(space);
    };
}

const Element element_rows[] = {
    {"plane", "the invariable plane with its grid", always, omega_alone, make_plane},
    {"tangent", "a patch of the ellipsoid's tangent plane at ρ, which is the invariable plane",
     never, attitude_too, make_tangent},
    {"ellipsoid", "the inertia ellipsoid with body-fixed lines", always, attitude_too,
     make_ellipsoid},
    {"body", "the body itself, inside its ellipsoid", never, attitude_too, make_body},
    {"annulus", "the ring that the herpolhode fills", never, omega_alone, make_annulus},
    {"polhode", "path of the contact point on the ellipsoid", has_curves, attitude_too,
     make_polhode},
    {"herpolhode", "path of the contact point on the plane", has_curves, omega_alone,
     make_herpolhode},
    {"cones", "body cone rolling on space cone (symmetric bodies)", has_cones, attitude_too,
     make_cones},
    {"spin-axis", "the instantaneous axis of rotation, through centre and contact", always,
     attitude_too, make_spin_axis},
    {"momentum", "the angular momentum L, normal to the plane", always, omega_alone, make_momentum},
    {"omega", "the angular velocity ω up to the contact point, or beyond it where radius is shown",
     always, attitude_too, make_omega},
    {"axes", "the principal axes e1, e2, e3", always, attitude_too, make_axes},
    {"given-axes", "the body axes x, y, z of the numbers in the scene", never, attitude_too,
     make_given_axes},
    {"turn", "the rotation from the given axes to the principal axes", never, attitude_too,
     make_turn},
    {"half-axes", "the half-axes 1/√I1, 1/√I2, 1/√I3 of the ellipsoid", never, attitude_too,
     make_half_axes},
    {"radius", "the radius vector ρ = ω/√(2T), F(ρ) = 1", never, attitude_too, make_radius},
    {"gradient", "∇F at ρ, along L", never, attitude_too, make_gradient},
    {"projection", "the projection of ρ on L, of length √(2T)/L", never, attitude_too,
     make_projection},
    {"distance", "the plane's distance √(2T)/L from the centre", never, omega_alone, make_distance},
    {"levels", "√(2T)/L and 1/√I1, 1/√I2, 1/√I3 as distances along L", never, omega_alone,
     make_levels},
    {"velocity", "the velocity ω × r of points on the ellipsoid, zero at the contact point", never,
     attitude_too, make_velocity},
    {"precession", "the precessions Ω about the symmetry axis and L/I1 about L (symmetric bodies)",
     never, attitude_too, make_precession},
    {"contact", "the contact point", always, attitude_too, make_contact},
    {"ghost", "the ellipsoid and ω of the comparison method in [beside]", has_comparison,
     omega_alone, make_ghost},
    {"drift", "path of the contact point by the comparison method in [beside]", has_comparison,
     omega_alone, make_drift},
};

}  // namespace

std::span<const Element> elements() { return element_rows; }

bool is_shown(const StageData& stage, std::string_view name) {
    const std::vector<std::string>& show = stage.scene.show;
    if (show.empty()) return element_named(name).by_default(stage);
    return std::find(show.begin(), show.end(), name) != show.end();
}

const Element& element_named(std::string_view name) {
    if (const Element* row = find_row(element_rows, name)) return *row;
    throw InputError(unknown("element", name, names_of(element_rows)));
}

}  // namespace poinsot
