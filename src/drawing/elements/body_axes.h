// What the panels in principal axes share: the ellipsoid of a motion at rest, and from where it is
// seen.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "drawing/framing.h"
#include "drawing/panel.h"

namespace poinsot {

// e1, e2, e3 along x, y, z, from body axes.
Eigen::Matrix3d principal_from_body(const Panel& panel);

// ρ in principal axes, in units of the largest half-axis: its tip is the contact point.
Eigen::Vector3d rho_in_principal_axes(const Panel& panel, const Instant& instant);

// From where principal axes are seen: the axis that the motion encircles leans towards us on ω's
// side, e3 is up.
Eigen::Vector3d principal_view_direction(const Panel& panel);

// Aims the panel's camera from there, or from where a camera of its own stands in principal axes,
// at all of these points, and its light with it.
void aim_in_principal_axes(Panel& panel, std::vector<Eigen::Vector3d> points,
                           const Margins& margins);

// Turns the panel's light about e3 with its camera, as it stands to the space panel's usual one.
void light_from_camera(Panel& panel);

}  // namespace poinsot
