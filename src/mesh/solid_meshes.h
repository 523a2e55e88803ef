// Closed meshes of the solids that a scene may name, centre of mass at the origin, principal axes
// along x, y, z, and the ways to make further ones.
//
// Curved surfaces are drawn by facets whose corners stand outside of the true surface by as much as
// their middles lie inside: a mesh encloses the solid's exact volume (to rounding), and its moments
// of inertia differ from the solid's by the fourth power of the facets' angle only.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace poinsot {

// Facets around a circle; a multiple of 4, so that the axes stay principal. At 128 a circle of 500
// pixels radius is drawn to 0.15 pixels.
constexpr int default_facets = 128;
// Facets on a quarter of an ellipsoid's sections: 8·n² triangles.
constexpr int default_quarter_facets = 40;

// All sizes in metres, finite and positive; facets at least 4 (a multiple of 4) or 1 a quarter.
// Edges along x, y, z.
TriangleMesh box_mesh(const Eigen::Vector3d& edges_m);

// Half-axes along x, y, z. The triangles of the unit sphere have the symmetry of an octahedron, so
// that the ratios of an ellipsoid's moments are exact.
TriangleMesh ellipsoid_mesh(const Eigen::Vector3d& half_axes_m,
                            int quarter_facets = default_quarter_facets);
TriangleMesh sphere_mesh(double radius_m, int quarter_facets = default_quarter_facets);

// Axis z. The cone's apex is up, its base a quarter of the height below the origin.
TriangleMesh cylinder_mesh(double radius_m, double height_m, int facets = default_facets);
TriangleMesh tube_mesh(double inner_radius_m, double outer_radius_m, double height_m,
                       int facets = default_facets);
TriangleMesh cone_mesh(double base_radius_m, double height_m, int facets = default_facets);
TriangleMesh torus_mesh(double centre_line_radius_m, double tube_radius_m,
                        int facets = default_facets, int tube_facets = 48);

// The solid named as in a scene's body.shape, with its size_m (mechanics/solids.h says which
// sizes). Thin solids (disc, ring, plate, shell) get a thickness of 1/100 of their largest size, to
// be seen; a shell is drawn by its outside. Throws InputError for a name that is not in the table
// or a wrong count of sizes.
TriangleMesh solid_mesh(std::string_view shape, std::span<const double> size_m);

// A point of a profile in the half-plane of the axis: distance from the axis and height along it.
struct ProfilePoint {
    double radius_m = 0.0;
    double z_m = 0.0;
};

// Solid of revolution about z. The profile runs upwards from the axis to the axis, with the solid
// between it and the axis; its first and last radius are 0, the others positive.
TriangleMesh revolved(std::span<const ProfilePoint> profile, int facets = default_facets);

// Ring about z from a closed profile, counter-clockwise in (radius, z), last point not repeated.
TriangleMesh revolved_ring(std::span<const ProfilePoint> profile, int facets = default_facets);

// Right prism with a convex polygon, counter-clockwise in (x, y), as its base, from z_low to
// z_high.
TriangleMesh prism(std::span<const Eigen::Vector2d> base_m, double z_low_m, double z_high_m);

// The mesh moved by an affine map; a map that mirrors turns the triangles round, so that they keep
// their outside.
TriangleMesh placed(TriangleMesh mesh, const Eigen::Affine3d& placement);

// Several surfaces as one mesh, vertices unshared.
TriangleMesh joined(std::span<const TriangleMesh> meshes);

// The mesh turned inside out, as the wall of a cavity is.
TriangleMesh inside_out(TriangleMesh mesh);

}  // namespace poinsot
