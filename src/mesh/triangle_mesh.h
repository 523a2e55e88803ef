// Surfaces of bodies as triangles: what the readers make, the mass properties integrate and the
// drawing shows.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace poinsot {

// Vertices in metres, any axes; triangles as indices of vertices, counter-clockwise seen from
// outside. Every index is in range.
struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// What a renderer takes: one position and one unit normal a corner, three corners a triangle.
struct ShadedCorners {
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;
};

// 35°: the facets of a tessellated curve meet at less, the edges of a box or an octagon at more.
constexpr double default_crease_angle_rad = 0.6108652381980153;

// Corners of every triangle, in its order. Around a vertex the normals of triangles that meet at
// less than the crease angle, edge by edge, are averaged, weighted by the angle at the vertex; the
// others stay apart. A corner whose average leans from its own triangle by more than the crease
// angle (the apex of a cone) keeps the triangle's normal.
// Units: m, rad. Source: Thürmer & Wüthrich, J. Graphics Tools 3 (1998) 43.
ShadedCorners shaded_corners(const TriangleMesh& mesh,
                             double crease_angle_rad = default_crease_angle_rad);

// The same surface with one vertex for each position (compared exactly), without vertices that no
// triangle uses and without triangles that have lost an edge by it. Vertices keep the order in
// which they first appear.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace poinsot
