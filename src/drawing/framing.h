// Cameras that show all of a thing, as large as its panel allows.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "drawing/panel.h"

namespace poinsot {

// A perspective camera that looks from the direction `towards_eye`, so near that the points just
// fit into the box less a margin on every side, and so that they stand in its middle. Exact: no
// nearer camera with this direction holds them all. `up`: not parallel to the direction; a third of
// the smaller side at most is taken as margin. Points that coincide are seen from a distance of 1.
Camera framed(const PanelBox& box, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points, double margin_px);

// The same with a margin of its own on every side.
struct Margins {
    double left_px = 0.0, right_px = 0.0, top_px = 0.0, bottom_px = 0.0;
};
Camera framed(const PanelBox& box, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points,
              const Margins& margins);

// The same for a panel, whose camera may be orthographic: then the frame is that of parallel lines
// of sight, and the distance returned is the one at which `vertical_field_rad` has its height.
Camera framed(const Panel& panel, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points,
              const Margins& margins);

// Aims a panel's camera so from where the scene's camera stands, or its own, z upwards, and lets it
// follow when keyframes move that.
void aim_around(Panel& panel, std::vector<Eigen::Vector3d> points, double margin_px);
void aim_around(Panel& panel, std::vector<Eigen::Vector3d> points, const Margins& margins);

// A margin on every side, a third of the box's smaller side at most.
Margins even_margins(const PanelBox& box, double margin_px);

// Points whose frame holds an ellipsoid about the origin: the corners of a polyhedron about it
// would be too many, so these are points of the surface, dense enough for a frame with a margin.
std::vector<Eigen::Vector3d> points_of_ellipsoid(const Eigen::Matrix3d& half_axes);

// Of many points those that lie farthest out in some direction, which is what a frame needs of
// them: directions are 15° apart, so less than a hundredth of their reach is missed.
std::vector<Eigen::Vector3d> outermost(std::span<const Eigen::Vector3d> points);

// The direction in which a camera of the scene stands: azimuth about z from x, elevation above the
// xy plane, degrees.
Eigen::Vector3d direction_of(double azimuth_deg, double elevation_deg);

// What is upwards for a camera that stands there: z, or where it looks along z what z tends to.
Eigen::Vector3d up_of(double azimuth_deg, double elevation_deg);

}  // namespace poinsot
