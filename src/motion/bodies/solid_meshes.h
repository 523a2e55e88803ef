// Closed meshes of the solids that a scene may name, with the centre of mass at the origin and
// principal axes along x, y, z; and functions that make further meshes.
//
// The corners of the facets of a curved surface lie outside the true surface by as much as their
// middles lie inside. A mesh therefore encloses the solid's exact volume (to rounding), and its
// moments of inertia differ from the solid's only in the fourth order of the facets' angle.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <string_view>
#include <vector>

#include "bodies/triangle_mesh.h"

namespace poinsot {

// Facets around a circle; a multiple of 4, so that the axes stay principal. With 128, a circle of
// 500 pixels radius is accurate to 0.15 pixels.
constexpr int default_facets = 128;
// Facets on a quarter of an ellipsoid's section: the mesh has 8·n² triangles.
constexpr int default_quarter_facets = 40;

// All sizes are in metres, finite and positive. Preconditions: `facets` is a multiple of 4 and at
// least 4; `quarter_facets` is at least 1.
//
// A box with edges along x, y, z.
TriangleMesh box_mesh(const Eigen::Vector3d& edges_m);

// An ellipsoid with half-axes along x, y, z. The triangles have the symmetry of an octahedron, so
// that the ratios of the moments are exact.
TriangleMesh ellipsoid_mesh(const Eigen::Vector3d& half_axes_m,
                            int quarter_facets = default_quarter_facets);
TriangleMesh sphere_mesh(double radius_m, int quarter_facets = default_quarter_facets);

// Solids with axis z. The cone's apex is up; its base is a quarter of the height below the origin.
TriangleMesh cylinder_mesh(double radius_m, double height_m, int facets = default_facets);
TriangleMesh tube_mesh(double inner_radius_m, double outer_radius_m, double height_m,
                       int facets = default_facets);
TriangleMesh cone_mesh(double base_radius_m, double height_m, int facets = default_facets);
TriangleMesh torus_mesh(double centre_line_radius_m, double tube_radius_m,
                        int facets = default_facets, int tube_facets = 48);

// The mesh of the solid that a scene names in body.shape, with its size_m (mechanics/solids.h lists
// the sizes). Thin solids (disc, ring, plate, shell) get a visible thickness of 1/100 of their
// largest size; a shell is represented by its outer surface. Throws InputError for an unknown name
// or a wrong number of sizes.
TriangleMesh solid_mesh(std::string_view shape, std::span<const double> size_m);

// A point of a profile in the half-plane of the axis: distance from the axis, and height along the
// axis.
struct ProfilePoint {
    double radius_m = 0.0;
    double z_m = 0.0;
};

// A solid of revolution about z. The profile starts and ends on the axis and runs upwards, with the
// solid between it and the axis; its first and last radius are 0, the others positive.
TriangleMesh revolved(std::span<const ProfilePoint> profile, int facets = default_facets);

// A ring about z from a closed profile, counter-clockwise in (radius, z); the last point does not
// repeat the first.
TriangleMesh revolved_ring(std::span<const ProfilePoint> profile, int facets = default_facets);

// A right prism from z_low to z_high. The base is a convex polygon, counter-clockwise in (x, y).
TriangleMesh prism(std::span<const Eigen::Vector2d> base_m, double z_low_m, double z_high_m);

// Applies an affine map to the mesh. If the map mirrors, the triangles are reversed, so that their
// outside stays outside.
TriangleMesh placed(TriangleMesh mesh, const Eigen::Affine3d& placement);

// Several surfaces as one mesh; vertices are not merged.
TriangleMesh joined(std::span<const TriangleMesh> meshes);

// The mesh turned inside out, as for the wall of a cavity.
TriangleMesh inside_out(TriangleMesh mesh);

}  // namespace poinsot
