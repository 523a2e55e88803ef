// Flat faces of bodies: a picture or a contrasting mark can be placed on them.
#pragma once

#include <Eigen/Core>

#include "bodies/triangle_mesh.h"

namespace poinsot {

// Returns the largest coordinate of the vertices along the unit vector `outward`, in m; -infinity
// for an empty mesh.
double farthest_along(const TriangleMesh& mesh, const Eigen::Vector3d& outward);

// A surface split into the triangles in one plane and the others. Both meshes keep all vertices.
struct PartedMesh {
    TriangleMesh face, rest;
};

// Splits off the triangles that lie in the plane outward·x = at_m and face outward. A vertex is in
// the plane if it is within a millionth of the vertices' largest distance. Precondition: `outward`
// has unit length.
PartedMesh parted_at(const TriangleMesh& mesh, const Eigen::Vector3d& outward, double at_m);

// Whether a surface has a flat face at its farthest point along an axis (column 0 to 2 of `axes`;
// sign +1 or -1): a face that fills at least a tenth of that side of the bounding box along these
// axes.
bool has_flat_face(const TriangleMesh& mesh, const Eigen::Matrix3d& axes, int axis, double sign);

}  // namespace poinsot
