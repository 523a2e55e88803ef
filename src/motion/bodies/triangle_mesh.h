// Surfaces of bodies as triangles: the output of the mesh readers, and the input of mass properties
// and drawing.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace poinsot {

// Vertices in metres, in any axes; triangles as vertex indices, counter-clockwise seen from
// outside. Every index is in range.
struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Input for a renderer: one position and one unit normal per corner, three corners per triangle.
struct ShadedCorners {
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;
};

// 35°: the facets of a tessellated curve meet at a smaller angle, the edges of a box or an octagon
// at a larger one.
constexpr double default_crease_angle_rad = 0.6108652381980153;

// The corners of all triangles, in the order of the triangles. Around a vertex, the normals of
// neighbouring triangles that meet at less than the crease angle are averaged, weighted by the
// angle at the vertex; other normals stay separate. A corner whose average deviates from its
// triangle's normal by more than the crease angle (the apex of a cone) keeps the triangle's normal.
// Units: m, rad. Source: Thürmer & Wüthrich, J. Graphics Tools 3 (1998) 43.
ShadedCorners shaded_corners(const TriangleMesh& mesh,
                             double crease_angle_rad = default_crease_angle_rad);

// Merges vertices of equal position (compared exactly), and removes unused vertices and triangles
// that lose an edge by the merge. Vertices keep the order in which they first appear.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace poinsot
