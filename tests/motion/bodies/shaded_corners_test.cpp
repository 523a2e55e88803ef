// Normals for the renderer are smooth over small dihedral angles and sharp at edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/solid_meshes.h"
#include "bodies/triangle_mesh.h"

namespace poinsot {
namespace {

TEST(ShadedCorners, OfABoxAreFlat) {
    const TriangleMesh box = box_mesh({1.0, 2.0, 3.0});
    const ShadedCorners corners = shaded_corners(box);
    ASSERT_EQ(corners.normals.size(), 36u);
    for (std::size_t t = 0; t < 12; ++t) {
        const auto& [a, b, c] = box.triangles[t];
        const Eigen::Vector3d n = (box.vertices[b] - box.vertices[a])
                                      .cross(box.vertices[c] - box.vertices[a])
                                      .normalized();
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(corners.normals[3 * t + i], n.cast<float>());
            EXPECT_EQ(corners.positions[3 * t + i],
                      box.vertices[box.triangles[t][i]].cast<float>());
        }
    }
}

TEST(ShadedCorners, OfASphereAreRadial) {
    const ShadedCorners corners = shaded_corners(sphere_mesh(2.0));
    for (std::size_t i = 0; i < corners.normals.size(); ++i) {
        // measured 6e-4
        EXPECT_LT((corners.normals[i] - corners.positions[i].normalized()).norm(), 2e-3f);
    }
}

// The side is smooth, the rim sharp, the caps flat. At the apex of a cone, where the average would
// point along the axis, each side facet keeps its own normal.
TEST(ShadedCorners, KeepTheEdgesOfACylinderAndTheApexOfACone) {
    const ShadedCorners cylinder = shaded_corners(cylinder_mesh(1.0, 1.0, 64));
    for (std::size_t i = 0; i < cylinder.normals.size(); ++i) {
        const Eigen::Vector3f n = cylinder.normals[i];
        if (std::abs(n.z()) < 0.5f) {
            const Eigen::Vector3f p = cylinder.positions[i];
            const Eigen::Vector3f radial = Eigen::Vector3f(p.x(), p.y(), 0.0f).normalized();
            EXPECT_LT((n - radial).norm(), 1e-6f);  // measured 8e-8
        } else {
            EXPECT_EQ(std::abs(n.z()), 1.0f);
        }
    }
    const ShadedCorners cone = shaded_corners(cone_mesh(1.0, 2.0, 64));
    for (std::size_t i = 0; i < cone.normals.size(); ++i) {
        if (cone.positions[i].z() > 1.0f) {
            EXPECT_NEAR(cone.normals[i].z(), 1.0f / std::sqrt(5.0f), 1e-3f);
        }
    }
}

// Sides of an octagonal prism meet at 45°. With a smaller crease angle, a corner has its side's
// normal, 22.5° from the corner's direction; with a larger one, the average of two sides, weighted
// by their angles.
TEST(ShadedCorners, FollowTheCreaseAngle) {
    const auto lean_deg = [](double crease_angle_rad) {
        const ShadedCorners corners = shaded_corners(cylinder_mesh(1.0, 1.0, 8), crease_angle_rad);
        std::pair<float, float> range{180.0f, 0.0f};
        for (std::size_t i = 0; i < corners.normals.size(); ++i) {
            if (std::abs(corners.normals[i].z()) > 0.5f) continue;
            Eigen::Vector3f out = corners.positions[i];
            out.z() = 0.0f;
            const float lean = std::acos(out.normalized().dot(corners.normals[i])) * 57.29578f;
            range = {std::min(range.first, lean), std::max(range.second, lean)};
        }
        return range;
    };
    EXPECT_NEAR(lean_deg(0.78).first, 22.5f, 1e-3f);
    EXPECT_NEAR(lean_deg(0.78).second, 22.5f, 1e-3f);
    EXPECT_LT(lean_deg(0.79).second, 1e-1f);
}

TEST(ShadedCorners, OfDegenerateTrianglesAreUnitVectors) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (const Eigen::Vector3f& n : shaded_corners(mesh).normals)
        EXPECT_NEAR(n.norm(), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace poinsot
