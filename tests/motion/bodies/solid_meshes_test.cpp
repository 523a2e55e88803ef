// The parametric meshes are closed, correctly oriented, and have the moments of their solids.
#include "bodies/solid_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "bodies/mass_properties.h"
#include "bodies/solid_check.h"
#include "error/error.h"
#include "mechanics/solids.h"

namespace poinsot {
namespace {

using std::numbers::pi;

// Sizes that suit any row of the table of solids.
std::vector<double> sizes_for(const Solid& solid) {
    constexpr std::array<double, 3> sizes{0.5, 0.8, 1.1};
    return {sizes.begin(), sizes.begin() + solid.n_sizes};
}

// Relative error of the mesh's moments per mass, compared with the solid's.
double moment_error(const TriangleMesh& mesh, std::string_view name, std::span<const double> size) {
    const Eigen::Vector3d expected = inertia_of_solid(name, size, 1.0).moments_kg_m2();
    const MassProperties p = mass_properties(mesh);
    const Eigen::Vector3d moments = p.inertia_unit_density.diagonal() / p.volume_m3;
    return (moments - expected).cwiseAbs().maxCoeff() / expected.maxCoeff();
}

TEST(SolidMeshes, ExistForEverySolidOfAScene) {
    for (const Solid& solid : solids()) {
        const TriangleMesh mesh = solid_mesh(solid.name, sizes_for(solid));
        EXPECT_TRUE(edge_faults(mesh).none()) << solid.name;
        const MassProperties p = mass_properties(mesh);
        EXPECT_GT(p.volume_m3, 0.0) << solid.name;
        EXPECT_LT(p.centre_of_mass_m.norm(), 1e-14) << solid.name;  // measured 3e-17
        EXPECT_LE(mesh.triangles.size(), 20000u) << solid.name;
    }
}

TEST(SolidMeshes, AgreeWithMomentsOfTheirSolids) {
    // Thick solids; without the shell, whose mesh is only its outer surface.
    for (const char* name :
         {"box", "ellipsoid", "cylinder", "cone", "sphere", "torus", "rod", "tube"}) {
        for (const Solid& solid : solids()) {
            if (solid.name != name) continue;
            // measured 1.1e-6 for the torus with its 48 facets around the tube, below 1e-7 else
            EXPECT_LT(moment_error(solid_mesh(name, sizes_for(solid)), name, sizes_for(solid)),
                      2e-6)
                << name;
        }
    }
    // Thin solids, drawn with a thickness of 1/100: the error is the square of the thickness.
    for (const char* name : {"disc", "plate", "ring"}) {
        for (const Solid& solid : solids()) {
            if (solid.name != name) continue;
            EXPECT_LT(moment_error(solid_mesh(name, sizes_for(solid)), name, sizes_for(solid)),
                      1e-3)
                << name;
        }
    }
}

TEST(SolidMeshes, EncloseTheExactVolume) {
    const auto error = [](const TriangleMesh& mesh, double volume) {
        return std::abs(mass_properties(mesh).volume_m3 / volume - 1.0);
    };
    // Eight facets are as exact as a hundred; measured 7e-16 at most.
    for (const int facets : {8, 100}) {
        EXPECT_LT(error(cylinder_mesh(0.3, 2.0, facets), pi * 0.09 * 2.0), 4e-15);
        EXPECT_LT(error(cone_mesh(0.3, 2.0, facets), pi * 0.09 * 2.0 / 3.0), 4e-15);
        EXPECT_LT(error(tube_mesh(0.2, 0.3, 2.0, facets), pi * 0.05 * 2.0), 4e-15);
        EXPECT_LT(error(torus_mesh(1.0, 0.2, facets, 8), 2.0 * pi * pi * 0.04), 4e-15);
        EXPECT_LT(error(ellipsoid_mesh({1.0, 2.0, 3.0}, facets / 4), 8.0 * pi), 4e-15);
    }
}

TEST(SolidMeshes, MomentsConvergeWithOrderFour) {
    const auto order = [](auto mesh_of, std::string_view name, std::span<const double> size) {
        return std::log2(moment_error(mesh_of(16), name, size) /
                         moment_error(mesh_of(32), name, size));
    };
    const std::array<double, 2> cylinder{0.5, 0.1};
    EXPECT_NEAR(order([&](int n) { return cylinder_mesh(0.5, 0.1, n); }, "cylinder", cylinder), 4.0,
                0.05);
    const std::array<double, 2> torus{0.5, 0.2};
    EXPECT_NEAR(order([&](int n) { return torus_mesh(0.5, 0.2, n, n); }, "torus", torus), 4.0,
                0.05);
    const std::array<double, 1> sphere{0.5};
    EXPECT_NEAR(order([&](int n) { return sphere_mesh(0.5, n / 2); }, "sphere", sphere), 4.0, 0.1);
}

// The mesh has the symmetry of an octahedron: its error is a common factor, so ratios are exact.
TEST(SolidMeshes, EllipsoidsHaveExactMomentRatios) {
    const Eigen::Vector3d half_axes(1.0, 1.0, 1.0 - 1.0 / 298.257);
    const MassProperties p = mass_properties(ellipsoid_mesh(half_axes, 10));
    const Eigen::Vector3d I = p.inertia_unit_density.diagonal();
    const double c2 = half_axes.z() * half_axes.z();
    EXPECT_NEAR((I.z() - I.x()) / I.z(), (1.0 - c2) / 2.0, 1e-15);  // measured 3e-17
}

TEST(SolidMeshes, DeviateLittleFromTheTrueSurface) {
    // At a radius of 500 pixels the outline is off by less than 0.2 pixels in either direction.
    double farthest = 0.0;
    for (const TriangleMesh& mesh : {sphere_mesh(1.0), cylinder_mesh(1.0, 0.001)}) {
        const bool round = mesh.vertices.size() > 1000;
        for (const auto& t : mesh.triangles) {
            for (int i = 0; i < 3; ++i) {
                const Eigen::Vector3d& a = mesh.vertices[t[i]];
                const Eigen::Vector3d& b = mesh.vertices[t[(i + 1) % 3]];
                if (!round && (a.head<2>().norm() < 0.5 || b.head<2>().norm() < 0.5)) continue;
                const Eigen::Vector3d middle = 0.5 * (a + b);
                for (const Eigen::Vector3d& p : {a, b, middle}) {
                    const double r = round ? p.norm() : p.head<2>().norm();
                    farthest = std::max(farthest, std::abs(r - 1.0));
                }
            }
        }
    }
    EXPECT_LT(farthest * 500.0, 0.2);  // measured 0.15
}

TEST(SolidMeshes, UnknownNameSuggestsTheNearestShape) {
    const std::array<double, 1> size{1.0};
    try {
        solid_mesh("spere", size);
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean \"sphere\"?"), std::string::npos)
            << e.what();
    }
    EXPECT_THROW(solid_mesh("box", size), InputError);
}

TEST(PlacedMeshes, KeepTheirOutsideWhenMirrored) {
    const TriangleMesh cone = cone_mesh(1.0, 2.0, 8);
    const TriangleMesh mirrored = placed(cone, Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, -1.0)));
    EXPECT_NEAR(mass_properties(mirrored).volume_m3, mass_properties(cone).volume_m3, 1e-15);
}

}  // namespace
}  // namespace poinsot
