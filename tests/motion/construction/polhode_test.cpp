// The polhode as a curve: its tangents, and the circle of a symmetric body.
#include "construction/polhode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/motion.h"

namespace poinsot {
namespace {

// Compared with differences of the positions, extrapolated to h = 0 (Richardson): their error is of
// the order of h⁴ and of 1e-16/h.
TEST(Polhode, TangentIsTheDerivative) {
    for (const Eigen::Vector3d& omega :
         {Eigen::Vector3d(0.2, 0.3, 1.0), Eigen::Vector3d(1.0, 0.3, 0.2),
          Eigen::Vector3d(1e-3, 2e-3, 1.0), Eigen::Vector3d(-0.7, 0.2, -0.9)}) {
        const Polhode polhode(InertiaTensor::from_principal_moments({1.0, 2.0, 3.0}), omega);
        ASSERT_EQ(polhode.kind(), Polhode::Kind::closed);
        for (double chi = -3.0; chi < 3.1; chi += 0.37) {
            const double h = 1e-3;
            const auto difference = [&](double step) -> Eigen::Vector3d {
                return (polhode.at(chi + step) - polhode.at(chi - step)) / (2.0 * step);
            };
            const Eigen::Vector3d extrapolated = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
            EXPECT_LT((polhode.tangent(chi) - extrapolated).norm(), 2e-11) << chi;
        }
    }
}

// On the separatrix the square root of the modulus's complement is zero, and so is the tangent's
// denominator at the curve's ends.
TEST(Polhode, TangentIsFiniteAtTheEndsOfTheSeparatrix) {
    const Polhode polhode(InertiaTensor::from_principal_moments({3.0, 6.0, 8.0}), {4.0, 1.0, 3.0});
    ASSERT_EQ(polhode.kind(), Polhode::Kind::separatrix);
    for (const double chi : {polhode.first_chi_rad(), 0.0, polhode.last_chi_rad()})
        EXPECT_TRUE(polhode.tangent(chi).allFinite());
}

// L² = 2T·I₂ holds exactly, whatever the rounding of quotients of moments; the neighbouring doubles
// are not on the separatrix.
TEST(Polhode, IsTheSeparatrixExactlyWhereTheMotionIs) {
    struct Case {
        Eigen::Vector3d moments, omega;
    };
    for (const Case& one :
         {Case{{1.0, 2.0, 2.25}, {1.5, 1.0, 2.0}}, Case{{3.0, 3.25, 4.0}, {2.0, 1.0, 1.0}},
          Case{0x1p900 * Eigen::Vector3d(3.0, 6.0, 8.0), 0x1p-450 * Eigen::Vector3d(4.0, 7.0, 3.0)},
          Case{{1.0, 2.0, 2.25}, {1.5, -1e-9, -2.0}}}) {
        const InertiaTensor inertia = InertiaTensor::from_principal_moments(one.moments);
        const Polhode polhode(inertia, one.omega);
        MotionProblem problem;
        problem.inertia = inertia;
        problem.start.omega_body = one.omega;
        ASSERT_EQ(Motion(problem).regime(), Regime::separatrix);
        EXPECT_EQ(polhode.kind(), Polhode::Kind::separatrix) << one.moments.transpose();
        EXPECT_EQ(polhode.annulus().inner, 0.0);
        Eigen::Vector3d beside = one.omega;
        beside[0] = std::nextafter(beside[0], 1e300);
        EXPECT_EQ(Polhode(inertia, beside).kind(), Polhode::Kind::closed);
    }
}

TEST(Polhode, OfASymmetricBodyIsACircle) {
    const Polhode polhode(InertiaTensor::from_principal_moments({1.0, 1.0, 2.0}), {0.3, 0.4, 1.0});
    const auto circle = polhode.circle();
    ASSERT_TRUE(circle);
    EXPECT_NEAR(circle->cosine_axis.norm(), circle->sine_axis.norm(), 1e-16);
    EXPECT_EQ(circle->cosine_axis.dot(circle->sine_axis), 0.0);
    for (const double chi : {-2.0, 0.0, 0.5, 3.0}) {
        const Eigen::Vector3d at = circle->centre + std::cos(chi) * circle->cosine_axis +
                                   std::sin(chi) * circle->sine_axis;
        EXPECT_LT((at - polhode.at(chi)).norm(), 4e-16);
    }
    EXPECT_FALSE(
        Polhode(InertiaTensor::from_principal_moments({1.0, 2.0, 3.0}), {0.2, 0.3, 1.0}).circle());
}

// ω lies almost in the plane of the two equal moments; its square along the third axis underflows.
TEST(Polhode, OfASymmetricBodyIsACircleHoweverSlowItsAxialSpin) {
    const auto inertia = InertiaTensor::from_principal_moments({1.0, 1.0, 2.0});
    for (const double axial : {1e-100, 1e-155, 1e-170, 1e-300}) {
        const Eigen::Vector3d omega(0.2, 0.1, axial);
        const Polhode polhode(inertia, omega);
        const std::vector<Eigen::Vector3d> points = polhode.sampled(1e-4);
        ASSERT_LT(points.size(), 1000u);
        // ρ = ω/√(2T), turned about the axis of symmetry.
        const double radius = std::hypot(omega[0], omega[1]) / std::sqrt(0.05);
        for (const Eigen::Vector3d& point : points) {
            EXPECT_NEAR(std::hypot(point[0], point[1]), radius, 1e-14) << axial;
            EXPECT_NEAR(point[2] / axial, 1.0 / std::sqrt(0.05), 1e-12) << axial;
        }
    }
}

}  // namespace
}  // namespace poinsot
