// Shapes of the built-in objects in addition to the solids of a scene. Included only inside
// src/motion/bodies.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "bodies/solid_meshes.h"
#include "bodies/triangle_mesh.h"

namespace poinsot {

// A solid of revolution about z, cut by planes through the axis into n_sectors equal sectors;
// returns the chosen sectors as one mesh. Two colours of sectors make the rotation visible. The
// profile is closed, counter-clockwise in (radius, z), and may touch the axis. All sectors together
// have the mass properties of the whole solid. Precondition: facets is a multiple of n_sectors.
TriangleMesh sectors(std::span<const ProfilePoint> profile, int n_sectors,
                     const std::function<bool(int sector)>& chosen, int facets = default_facets);
inline bool even_sector(int sector) { return sector % 2 == 0; }
inline bool odd_sector(int sector) { return sector % 2 != 0; }

// The four octants of an ellipsoid in which the product of the coordinates is positive (or the four
// others), each closed by the coordinate planes. Together they have the mass properties of
// ellipsoid_mesh.
TriangleMesh octants(const Eigen::Vector3d& half_axes_m, bool positive, int quarter_facets);

// A bar swept along an ellipse in the y-z plane with these half-axes. Its cross-section is an
// ellipse with one half-width perpendicular to the plane (x) and one in the plane.
struct EllipticBar {
    double half_axis_y_m, half_axis_z_m;
    double half_width_across_m, half_width_in_plane_m;
};
TriangleMesh elliptic_ring(const EllipticBar& bar, int facets = default_facets);

// A straight bar between two points of the y-z plane, with the same kind of cross-section.
TriangleMesh straight_bar(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m,
                          double half_width_across_m, double half_width_in_plane_m);

// A round rod along −y that stands on a round bar about z. The upper end of the rod follows the
// surface of the bar, so that the two touch without overlap.
TriangleMesh rod_on_bar(double bar_radius_m, double rod_radius_m, double rod_length_m);

// An octagonal prism about z: a rectangle of these widths along x and y with corners cut off by
// cut_m.
TriangleMesh octagonal_prism(double width_x_m, double width_y_m, double cut_m, double z_low_m,
                             double z_high_m);

// An ellipsoid cut by a plane perpendicular to z at this height above its centre; returns the part
// below the plane if keep_below, else the part above.
TriangleMesh cut_ellipsoid(const Eigen::Vector3d& half_axes_m, double cut_z_m, bool keep_below);

}  // namespace poinsot
