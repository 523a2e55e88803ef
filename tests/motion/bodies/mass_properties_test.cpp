// Mass properties of polyhedra, against closed forms.
#include "bodies/mass_properties.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "bodies/solid_meshes.h"

namespace poinsot {
namespace {

using std::numbers::pi;

Eigen::Matrix3d box_inertia(const Eigen::Vector3d& edges) {
    const Eigen::Vector3d s = edges.cwiseAbs2();
    return edges.prod() / 12.0 *
           Eigen::Vector3d(s.y() + s.z(), s.z() + s.x(), s.x() + s.y())
               .asDiagonal()
               .toDenseMatrix();
}

double relative(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

Eigen::Affine3d moved_by(const Eigen::Vector3d& by) {
    return Eigen::Affine3d(Eigen::Translation3d(by));
}

TEST(MassProperties, AreExactForABox) {
    const Eigen::Vector3d edges(0.3, 2.0, 7.0);
    const MassProperties box = mass_properties(box_mesh(edges));
    EXPECT_NEAR(box.volume_m3, edges.prod(), 1e-15 * edges.prod());            // measured 0
    EXPECT_LT(box.centre_of_mass_m.norm(), 1e-15);                             // measured 0
    EXPECT_LT(relative(box.inertia_unit_density, box_inertia(edges)), 1e-15);  // measured 2e-16
}

// A tetrahedron with a corner at the origin and unit legs: ∫x² = 1/60, ∫xy = 1/120, V = 1/6, centre
// 1/4 (Dirichlet's integral). About its centre the moments are therefore 1/30 − 2/6/16 = 1/80 and
// the products −(1/120 − 1/96) = 1/480.
TEST(MassProperties, MatchClosedFormOfARightTetrahedron) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const MassProperties p = mass_properties(mesh);
    EXPECT_NEAR(p.volume_m3, 1.0 / 6.0, 1e-16);
    EXPECT_LT((p.centre_of_mass_m - Eigen::Vector3d::Constant(0.25)).norm(), 1e-15);
    Eigen::Matrix3d expected = Eigen::Matrix3d::Constant(1.0 / 480.0);
    expected.diagonal().setConstant(1.0 / 80.0);
    EXPECT_LT(relative(p.inertia_unit_density, expected), 1e-15);  // measured 0
}

// Dyadic coordinates stay exact when moved, so that only the integration can lose digits: about the
// origin, the parallel-axis terms would be 1e12 times the moments.
TEST(MassProperties, LoseNoDigitsFarFromTheOrigin) {
    const Eigen::Vector3d edges(0.25, 2.0, 1.5);
    const Eigen::Vector3d far(1e6, -3e6, 2e6);
    const MassProperties box = mass_properties(placed(box_mesh(edges), moved_by(far)));
    EXPECT_NEAR(box.volume_m3, edges.prod(), 1e-15 * edges.prod());
    EXPECT_EQ(box.centre_of_mass_m, far);
    EXPECT_LT(relative(box.inertia_unit_density, box_inertia(edges)), 1e-15);  // measured 0
}

// Here moving rounds the corners themselves, by half an ulp of 1e6: 6e-11.
TEST(MassProperties, OfAMovedTorusHaveOnlyVertexRoundingErrors) {
    const TriangleMesh torus = torus_mesh(1.0, 0.3);
    const MassProperties near = mass_properties(torus);
    const MassProperties far =
        mass_properties(placed(torus, moved_by({1e6 / 3.0, 1e6 / 7.0, -1e6 / 11.0})));
    EXPECT_NEAR(far.volume_m3, near.volume_m3, 1e-10);  // measured 2e-12
    EXPECT_LT(relative(far.inertia_unit_density, near.inertia_unit_density), 1e-10);
}

TEST(MassProperties, RotateWithTheBody) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const TriangleMesh cone = cone_mesh(0.4, 1.3);
    const MassProperties upright = mass_properties(cone);
    for (int i = 0; i < 20; ++i) {
        const Eigen::Quaterniond q =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                .normalized();
        const Eigen::Vector3d by(normal(random), normal(random), normal(random));
        Eigen::Affine3d placement = moved_by(by) * q;
        const MassProperties p = mass_properties(placed(cone, placement));
        const Eigen::Matrix3d R = q.toRotationMatrix();
        EXPECT_NEAR(p.volume_m3, upright.volume_m3, 1e-14 * upright.volume_m3);
        EXPECT_LT((p.centre_of_mass_m - by).norm(), 2e-15 * (1.0 + by.norm()));
        EXPECT_LT(
            relative(p.inertia_unit_density, R * upright.inertia_unit_density * R.transpose()),
            1e-14);  // measured 2e-15
    }
}

TEST(MassProperties, ScaleWithTheUnitOfLength) {
    const TriangleMesh torus = torus_mesh(1.0, 0.3, 16, 8);
    const MassProperties p = mass_properties(torus);
    for (const int exponent : {-200, -60, 60, 200}) {
        const double scale = std::ldexp(1.0, exponent);
        const MassProperties s =
            mass_properties(placed(torus, Eigen::Affine3d(Eigen::Scaling(scale))));
        EXPECT_EQ(s.volume_m3, p.volume_m3 * std::pow(scale, 3));
        EXPECT_EQ(s.inertia_unit_density, p.inertia_unit_density * std::pow(scale, 5));
    }
}

TEST(MassProperties, OfAnInsideOutMeshAreNegative) {
    const TriangleMesh box = box_mesh({1.0, 2.0, 3.0});
    const MassProperties p = mass_properties(inside_out(box));
    EXPECT_EQ(p.volume_m3, -mass_properties(box).volume_m3);
}

// The vertices lie on the sphere and the polyhedron inside: volume and moment converge to the
// sphere's with the square of the facets' size.
TEST(MassProperties, OfInscribedSpheresConvergeWithOrderTwo) {
    double volume_error = 0.0;
    double moment_error = 0.0;
    for (const int n : {8, 16, 32, 64}) {
        TriangleMesh sphere = sphere_mesh(1.0, n);
        for (Eigen::Vector3d& v : sphere.vertices) v.normalize();
        const MassProperties p = mass_properties(sphere);
        const double new_volume_error = 1.0 - p.volume_m3 / (4.0 / 3.0 * pi);
        const double new_moment_error = 1.0 - p.inertia_unit_density(0, 0) / (8.0 / 15.0 * pi);
        if (n > 8) {
            EXPECT_NEAR(std::log2(volume_error / new_volume_error), 2.0, 0.03);
            EXPECT_NEAR(std::log2(moment_error / new_moment_error), 2.0, 0.03);
        }
        volume_error = new_volume_error;
        moment_error = new_moment_error;
    }
    EXPECT_LT(moment_error, 7e-4);  // measured 5.9e-4
}

// Two cubes of unit mass at a distance of 2: by the parallel-axis theorem, 2·(1/6) about the line
// between them and 2·(1/6 + 1) perpendicular to it.
TEST(BodyOfParts, AppliesParallelAxes) {
    const MassProperties left = mass_properties(placed(box_mesh({1, 1, 1}), moved_by({-1, 5, 0})));
    const MassProperties right = mass_properties(placed(box_mesh({1, 1, 1}), moved_by({1, 5, 0})));
    const BodyProperties body = body_of_parts(std::vector<DensePart>{{left, 1.0}, {right, 1.0}});
    EXPECT_DOUBLE_EQ(body.mass_kg, 2.0);
    EXPECT_LT((body.centre_of_mass_m - Eigen::Vector3d(0, 5, 0)).norm(), 1e-15);
    const Eigen::Vector3d expected(1.0 / 3.0, 7.0 / 3.0, 7.0 / 3.0);
    EXPECT_LT((body.inertia_kg_m2.diagonal() - expected).norm(), 1e-15);
    EXPECT_TRUE(body.inertia_kg_m2.isDiagonal(0.0));
    EXPECT_EQ(body.inertia_kg_m2(1, 1), body.inertia_kg_m2(2, 2));
}

// A cube with a cavity that holds a denser cube, computed in two ways.
TEST(BodyOfParts, CountsACavityAsMissing) {
    const TriangleMesh hollow =
        joined(std::vector<TriangleMesh>{box_mesh({2, 2, 2}), inside_out(box_mesh({1, 1, 1}))});
    const BodyProperties body = body_of_parts(std::vector<DensePart>{
        {mass_properties(hollow), 1.0}, {mass_properties(box_mesh({1, 1, 1})), 3.0}});
    EXPECT_DOUBLE_EQ(body.mass_kg, 10.0);
    EXPECT_NEAR(body.inertia_kg_m2(0, 0), 32.0 / 6.0 + 2.0 / 6.0, 1e-14);
}

}  // namespace
}  // namespace poinsot
