// Cameras that show all of a figure, as large as its panel allows.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

// The nearest camera that sees all that each of these sees in a panel of this shape: for pictures
// beside each other. Empty if they look in different directions or by different projections.
std::optional<Camera> common_view(const PanelBox& box, std::span<const Camera> cameras);

// A perspective camera that looks from the direction `towards_eye`, at the distance where the
// points just fit, centred, into the box less a margin on every side. Exact: no nearer camera with
// this direction has them all in view. `up`: not parallel to the direction. The margin is at most a
// third of the smaller side. Points that coincide are viewed from a distance of 1.
Camera framed(const PanelBox& box, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points, double margin_px);

// The same with a separate margin on every side.
struct Margins {
    double left_px = 0.0, right_px = 0.0, top_px = 0.0, bottom_px = 0.0;
};
Camera framed(const PanelBox& box, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points,
              const Margins& margins);

// The same for a panel, whose camera may be orthographic: then the frame is that of parallel lines
// of sight, and the distance is the one at which `vertical_field_rad` spans the frame's height.
Camera framed(const Panel& panel, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points,
              const Margins& margins);

// Aims a panel's camera in this way, with z upwards, from the direction of the scene's camera or of
// the panel's own one, and makes it follow keyframes that move that camera.
void aim_around(Panel& panel, std::vector<Eigen::Vector3d> points, double margin_px);
void aim_around(Panel& panel, std::vector<Eigen::Vector3d> points, const Margins& margins);

// The same margin on every side, at most a third of the box's smaller side.
Margins even_margins(const PanelBox& box, double margin_px);

// Points whose frame contains an ellipsoid about the origin. They lie on the surface, dense enough
// for a frame with a margin; the corners of an enclosing polyhedron would be too many.
std::vector<Eigen::Vector3d> points_of_ellipsoid(const Eigen::Matrix3d& half_axes);

// The points that are farthest out in some direction; a frame needs no others. The directions are
// 15° apart, which loses less than a hundredth of the points' reach.
std::vector<Eigen::Vector3d> outermost(std::span<const Eigen::Vector3d> points);

// The direction towards a camera of the scene: azimuth about z from x, elevation above the xy
// plane, degrees.
Eigen::Vector3d direction_of(double azimuth_deg, double elevation_deg);

// The up direction of a camera of this pose: z, or, if the camera looks along z, the limit of z's
// projection, turned by the pose's roll.
Eigen::Vector3d up_of(const CameraPose& pose);

}  // namespace poinsot
