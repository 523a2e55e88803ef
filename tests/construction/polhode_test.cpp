// The polhode as a curve: its tangents, and the circle that a symmetric body's is.
#include "construction/polhode.h"

#include <gtest/gtest.h>

#include <cmath>

namespace poinsot {
namespace {

// Against differences of the positions, extrapolated to h = 0 (Richardson): their error is of the
// order of h⁴ and of 1e-16/h.
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

TEST(Polhode, OfASymmetricBodyIsACircleByItsAxes) {
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

}  // namespace
}  // namespace poinsot
