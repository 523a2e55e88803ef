// The flat faces of bodies: what a contrast or a picture can lie on.
#pragma once

#include <Eigen/Core>

#include "mesh/triangle_mesh.h"

namespace poinsot {

// Largest component of the vertices along a unit vector, in m; -infinity without any.
double farthest_along(const TriangleMesh& mesh, const Eigen::Vector3d& outward);

// A surface in two: the triangles in a plane, and the others. Both have all vertices.
struct PartedMesh {
    TriangleMesh face, rest;
};

// The triangles that lie in the plane outward·x = at_m and look outward, taken out of a surface.
// `outward` has unit length; a plane is met within a millionth of the vertices' largest distance.
PartedMesh parted_at(const TriangleMesh& mesh, const Eigen::Vector3d& outward, double at_m);

// Whether a surface has a flat face where it reaches farthest along an axis (column of `axes`,
// 0 to 2; sign +1 or -1): one that fills at least a tenth of the rectangle that the surface's box
// along these axes shows there.
bool has_flat_face(const TriangleMesh& mesh, const Eigen::Matrix3d& axes, int axis, double sign);

}  // namespace poinsot
