#include "bodies/flat_face.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// The triangle's outer normal times twice its area.
Eigen::Vector3d doubled_area(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corner) {
    const Eigen::Vector3d& a = mesh.vertices[corner[0]];
    return (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
}

}  // namespace

double farthest_along(const TriangleMesh& mesh, const Eigen::Vector3d& outward) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        farthest = std::max(farthest, outward.dot(vertex));
    return farthest;
}

PartedMesh parted_at(const TriangleMesh& mesh, const Eigen::Vector3d& outward, double at_m) {
    double reach_m = 0.0;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        reach_m = std::max(reach_m, norm_of(vertex));
    const double within_m = 1e-6 * reach_m;
    PartedMesh parted{{mesh.vertices, {}}, {mesh.vertices, {}}};
    for (const auto& corners : mesh.triangles) {
        const bool lies_there = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t i) {
            return outward.dot(mesh.vertices[i]) > at_m - within_m;
        });
        const bool is_face = lies_there && doubled_area(mesh, corners).dot(outward) > 0.0;
        (is_face ? parted.face : parted.rest).triangles.push_back(corners);
    }
    return parted;
}

bool has_flat_face(const TriangleMesh& mesh, const Eigen::Matrix3d& axes, int axis, double sign) {
    constexpr double least_share = 0.1;
    const Eigen::Vector3d outward = sign * axes.col(axis);
    const TriangleMesh face = parted_at(mesh, outward, farthest_along(mesh, outward)).face;
    double area_m2 = 0.0;
    for (const auto& corners : face.triangles)
        area_m2 += 0.5 * doubled_area(mesh, corners).dot(outward);
    double rectangle_m2 = 1.0;
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
        rectangle_m2 *=
            farthest_along(mesh, axes.col(other)) + farthest_along(mesh, -axes.col(other));
    return area_m2 > 0.0 && area_m2 >= least_share * rectangle_m2;
}

}  // namespace poinsot
