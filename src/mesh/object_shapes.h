// Shapes that the built-in objects are made of, beyond the solids of a scene. Inside of src/mesh
// only.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "mesh/solid_meshes.h"
#include "mesh/triangle_mesh.h"

namespace poinsot {

// A solid of revolution about z cut by planes through the axis into n_sectors equal sectors, those
// chosen as one mesh: so that its turning is seen in two colours. The profile is closed,
// counter-clockwise in (radius, z), and may touch the axis; facets is a multiple of n_sectors. All
// sectors together have the mass properties of the whole.
TriangleMesh sectors(std::span<const ProfilePoint> profile, int n_sectors,
                     const std::function<bool(int sector)>& chosen, int facets = default_facets);
inline bool even_sector(int sector) { return sector % 2 == 0; }
inline bool odd_sector(int sector) { return sector % 2 != 0; }

// The four octants of an ellipsoid whose coordinates have a positive product, or the four others,
// each closed by its planes. Together they have the mass properties of ellipsoid_mesh.
TriangleMesh octants(const Eigen::Vector3d& half_axes_m, bool positive, int quarter_facets);

// A bar swept along an ellipse in the y-z plane with these half-axes. Its cross-section is an
// ellipse with half-widths across the plane (x) and in it.
struct EllipticBar {
    double half_axis_y_m, half_axis_z_m;
    double half_width_across_m, half_width_in_plane_m;
};
TriangleMesh elliptic_ring(const EllipticBar& bar, int facets = default_facets);

// A straight bar between two points of the y-z plane, its cross-section as above.
TriangleMesh straight_bar(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m,
                          double half_width_across_m, double half_width_in_plane_m);

// A round rod along −y that stands on a round bar about z: its upper end follows the bar's surface,
// so that the two touch and do not overlap.
TriangleMesh rod_on_bar(double bar_radius_m, double rod_radius_m, double rod_length_m);

// An octagonal prism about z: a rectangle of these widths along x and y with its corners cut by the
// third size.
TriangleMesh octagonal_prism(double width_x_m, double width_y_m, double cut_m, double z_low_m,
                             double z_high_m);

// Ellipsoid cut at a height above (or below) its centre by a plane across z; the part below the
// plane if keep_below.
TriangleMesh cut_ellipsoid(const Eigen::Vector3d& half_axes_m, double cut_z_m, bool keep_below);

}  // namespace poinsot
