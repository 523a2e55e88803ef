// The Euler angles of an attitude.
#include "mechanics/euler_angles.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace poinsot {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond attitude_of(const EulerAngles& angles) {
    return AngleAxisd(angles.phi_rad, Vector3d::UnitZ()) *
           AngleAxisd(angles.theta_rad, Vector3d::UnitX()) *
           AngleAxisd(angles.psi_rad, Vector3d::UnitZ());
}

TEST(EulerAngles, ReproduceTheAttitude) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> component;
    for (int k = 0; k < 10'000; ++k) {
        const Quaterniond q =
            Quaterniond(component(random), component(random), component(random), component(random))
                .normalized();
        const EulerAngles angles = euler_angles_of(q);
        EXPECT_LT(q.angularDistance(attitude_of(angles)), 1e-15 * 16);
        EXPECT_GE(angles.theta_rad, 0.0);
        EXPECT_LE(angles.theta_rad, std::numbers::pi);
    }
}

TEST(EulerAngles, AreZeroWhereUndetermined) {
    // For an upright or inverted axis one of the two sums is undetermined, whatever the signs of
    // zeros.
    for (const double zero : {0.0, -0.0}) {
        const EulerAngles upright = euler_angles_of({1.0, zero, zero, 0.0});
        EXPECT_EQ(upright.theta_rad, 0.0);
        EXPECT_EQ(upright.phi_rad, 0.0);
        EXPECT_EQ(upright.psi_rad, 0.0);
        const EulerAngles below = euler_angles_of({zero, 1.0, 0.0, zero});
        EXPECT_DOUBLE_EQ(below.theta_rad, std::numbers::pi);
        EXPECT_EQ(below.phi_rad, 0.0);
        EXPECT_EQ(below.psi_rad, 0.0);
    }
}

}  // namespace
}  // namespace poinsot
