// Shared by the panels in principal axes: the ellipsoid of a motion at rest, and its viewing
// direction.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "drawing/stage/framing.h"
#include "drawing/stage/panel.h"

namespace poinsot {

// Rotation from body axes to principal axes: e1, e2, e3 along x, y, z.
Eigen::Matrix3d principal_from_body(const Panel& panel);

// ρ in principal axes, in units of the largest half-axis: its tip is the contact point.
Eigen::Vector3d rho_in_principal_axes(const Panel& panel, const FrameInput& instant);

// L/|L| in principal axes at a point of the polhode, in body axes: along Jρ.
Eigen::Vector3d momentum_direction(const Panel& panel, const Eigen::Vector3d& contact_body);

// Direction from which principal axes are viewed: the axis that the motion encircles leans towards
// the viewer on ω's side, e3 is up.
Eigen::Vector3d principal_view_direction(const Panel& panel);

// Aims the panel's camera and its light at all of these points, from the default direction or, if
// the panel has its own camera, from that camera's direction in principal axes.
void aim_in_principal_axes(Panel& panel, std::vector<Eigen::Vector3d> points,
                           const Margins& margins);

// Turns the panel's light about e3 with its camera, so that it has the same direction relative to
// the camera as in the space panel.
void light_from_camera(Panel& panel);

}  // namespace poinsot
