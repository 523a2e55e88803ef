// The rows of the table of elements, with the functions that make them. The functions are in the
// other files of this folder.
#pragma once

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/possible_motions.h"

namespace poinsot {

Drawer make_plane(const Panel& panel, StageStore& store);
Drawer make_polhode(const Panel& panel, StageStore& store);
Drawer make_herpolhode(const Panel& panel, StageStore& store);
Drawer make_annulus(const Panel& panel, StageStore& store);
Drawer make_given_axes(const Panel& panel, StageStore& store);
Drawer make_turn(const Panel& panel, StageStore& store);
Drawer make_period_turn(const Panel& panel, StageStore& store);
Drawer make_solid_angle(const Panel& panel, StageStore& store);
Drawer make_inertial_forces(const Panel& panel, StageStore& store);
Drawer make_half_axes(const Panel& panel, StageStore& store);
Drawer make_precession(const Panel& panel, StageStore& store);
Drawer make_body(const Panel& panel, StageStore& store);
Drawer make_body_beside(const Panel& panel, StageStore& store);
Drawer make_momentum(const Panel& panel, StageStore& store);
Drawer make_omega(const Panel& panel, StageStore& store);
Drawer make_spin_axis(const Panel& panel, StageStore& store);
Drawer make_contact(const Panel& panel, StageStore& store);
Drawer make_radius(const Panel& panel, StageStore& store);
Drawer make_direction(const Panel& panel, StageStore& store);
Drawer make_direction_trace(const Panel& panel, StageStore& store);
Drawer make_spin_direction(const Panel& panel, StageStore& store);
Drawer make_tangent(const Panel& panel, StageStore& store);
Drawer make_gradient(const Panel& panel, StageStore& store);
Drawer make_projection(const Panel& panel, StageStore& store);
Drawer make_distance(const Panel& panel, StageStore& store);
Drawer make_levels(const Panel& panel, StageStore& store);
Drawer make_velocity(const Panel& panel, StageStore& store);
Drawer make_ghost(const Panel& panel, StageStore& store);
Drawer make_drift(const Panel& panel, StageStore& store);
Drawer make_measured(const Panel& panel, StageStore& store);
Drawer make_ellipsoid(const Panel& panel, StageStore& store);
Drawer make_axes(const Panel& panel, StageStore& store);
Drawer make_cones(const Panel& panel, StageStore& store);

// Whether an element is shown if the scene does not list elements.
inline bool always_shown(const StageContext&) { return true; }
inline bool never_shown(const StageContext&) { return false; }
inline bool has_cones(const StageContext& stage) { return stage.rolling->cones.has_value(); }
inline bool has_curves(const StageContext& stage) {
    return stage.rolling->dissipates || stage.rolling->polhode.kind() != Polhode::Kind::point;
}
inline bool comparison_given(const StageContext& stage) { return stage.comparison.has_value(); }

inline constexpr Element element_rows[] = {
    {"plane", "the invariable plane with its grid", always_shown, omega_alone, make_plane},
    {"tangent", "a patch of the ellipsoid's tangent plane at ρ, which is the invariable plane",
     never_shown, attitude_too, make_tangent},
    {"ellipsoid", "the inertia ellipsoid with body-fixed lines", always_shown, attitude_too,
     make_ellipsoid},
    {"body", "the body itself, inside its ellipsoid", never_shown, attitude_too, make_body},
    {"body-beside",
     "the body itself with its principal axes, to the left of its ellipsoid and turned as this is",
     never_shown, attitude_too, make_body_beside},
    {"annulus", "the circles that bound the herpolhode", never_shown, omega_alone, make_annulus},
    {"polhode", "path of the contact point on the ellipsoid", has_curves, attitude_too,
     make_polhode},
    {"herpolhode", "path of the contact point on the plane", has_curves, omega_alone,
     make_herpolhode},
    {"cones", "body cone rolling on space cone (symmetric bodies)", has_cones, attitude_too,
     make_cones},
    {"spin-axis", "the instantaneous axis of rotation, through centre and contact", always_shown,
     attitude_too, make_spin_axis},
    {"momentum", "the angular momentum L, normal to the plane", always_shown, omega_alone,
     make_momentum},
    {"omega",
     "the angular velocity ω, drawn up to the contact point, or beyond it if radius is shown",
     always_shown, attitude_too, make_omega},
    {"axes", "the principal axes e1, e2, e3", always_shown, attitude_too, make_axes},
    {"given-axes", "the body axes x, y, z in which the scene gives its numbers", never_shown,
     attitude_too, make_given_axes},
    {"turn", "the rotation from the given axes to the principal axes", never_shown, attitude_too,
     make_turn},
    {"period-turn",
     "the principal axis that is farthest from L at the start of the film, and its turn about L to "
     "where it is one polhode period later",
     never_shown, attitude_too, make_period_turn},
    {"half-axes", "the half-axes 1/√I1, 1/√I2, 1/√I3 of the ellipsoid", never_shown, attitude_too,
     make_half_axes},
    {"direction",
     "an axis n that sweeps through all directions until this element fades out, with its moment "
     "I(n)",
     never_shown, attitude_too, make_direction},
    {"direction-trace",
     "ρ = n/√I(n) along the axis n of direction, and the path of its tip, which fills the "
     "ellipsoid",
     never_shown, attitude_too, make_direction_trace},
    {"spin-direction", "the axis n along ω, with its moment I(n) = 2T/ω²", never_shown,
     attitude_too, make_spin_direction},
    {"radius", "the radius vector ρ = ω/√(2T), whose tip lies on the ellipsoid F(ρ) = 1",
     always_shown, attitude_too, make_radius},
    {"gradient", "the gradient ∇F at the tip of ρ, parallel to L", never_shown, attitude_too,
     make_gradient},
    {"projection", "the projection of ρ on L, of length √(2T)/L", never_shown, attitude_too,
     make_projection},
    {"distance", "the plane's distance √(2T)/L from the centre", never_shown, omega_alone,
     make_distance},
    {"levels", "√(2T)/L and 1/√I1, 1/√I2, 1/√I3 as marks along L", never_shown, omega_alone,
     make_levels},
    {"velocity", "the velocity ω × r of points on the ellipsoid, zero at the contact point",
     never_shown, attitude_too, make_velocity},
    {"precession",
     "the two rates of a symmetric body: L/I1 about L, and ψ̇ = −Ω of the spin about its axis",
     never_shown, attitude_too, make_precession},
    {"contact", "the contact point", always_shown, attitude_too, make_contact},
    {.name = "ghost",
     .summary = "the ellipsoid and ω of the comparison method in [beside]",
     .by_default = comparison_given,
     .needs = omega_alone,
     .make = make_ghost,
     .reads_comparison = true},
    {.name = "drift",
     .summary = "path of the contact point by the comparison method in [beside]",
     .by_default = comparison_given,
     .needs = omega_alone,
     .make = make_drift,
     .reads_comparison = true},
    {.name = "inertial-forces",
     .summary = "in panel object, the inertial forces on point masses in the axes that turn with "
                "the body: from each mass the centrifugal force −m ω × (ω × r), from its tip "
                "−m dω/dt × r",
     .by_default = never_shown,
     .needs = attitude_too,
     .make = make_inertial_forces,
     .shown_in = uses_forces},
    {.name = "solid-angle",
     .summary = "in panel momentum, the part of the sphere that L encloses in one polhode period, "
                "as a flat area",
     .by_default = never_shown,
     .needs = omega_alone,
     .make = make_solid_angle,
     .shown_in = uses_solid_angle},
    {"measured",
     "ρ = ω/√(2T) of the measured motion in [measured] up to the instant, with the scene's T: on "
     "the ellipsoid and on the plane",
     has_measured, attitude_too, make_measured},
};

}  // namespace poinsot
