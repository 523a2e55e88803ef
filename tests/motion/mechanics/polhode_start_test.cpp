// The start from T and L: it has them, and it lies where the direction says.
#include "mechanics/free/polhode_start.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "error/error.h"
#include "mechanics/free/free_rotation.h"
#include "refusal.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;

const InertiaTensor three = InertiaTensor::from_principal_moments({2.9, 1.0, 2.0});

double energy_of(const InertiaTensor& inertia, const Vector3d& omega) {
    return 0.5 * omega.dot(inertia.matrix_body() * omega);
}
double momentum_of(const InertiaTensor& inertia, const Vector3d& omega) {
    return (inertia.matrix_body() * omega).norm();
}
ConservedQuantities by_momentum(double energy_J, double momentum) {
    return {energy_J, momentum, {}};
}
FreeRotation motion_of(const InertiaTensor& inertia, const PolhodeStart& start) {
    return {inertia, {0.0, Eigen::Quaterniond::Identity(), start.omega_body}, start.on_separatrix};
}

std::string said_about(const ConservedQuantities& conserved) {
    return refusal_message([&] { start_on_polhode(three, conserved); });
}

TEST(PolhodeStart, HasTheEnergyAndTheMomentum) {
    std::mt19937 random(35);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int k = 0; k < 500; ++k) {
        const Vector3d sizes =
            (Vector3d(1.5, 1.5, 1.5) + Vector3d(number(random), number(random), number(random)));
        const Vector3d moments(sizes[1] + sizes[2], sizes[0] + sizes[2], sizes[0] + sizes[1]);
        const double energy_J = std::exp(20.0 * number(random));
        const double inertia = moments.minCoeff() + 0.5 * (1.0 + number(random)) *
                                                        (moments.maxCoeff() - moments.minCoeff());
        const double L = std::sqrt(2.0 * energy_J * inertia);
        const InertiaTensor body = InertiaTensor::from_principal_moments(moments);
        const Vector3d direction(number(random), number(random), number(random));
        const PolhodeStart start = start_on_polhode(body, by_momentum(energy_J, L), direction);
        // Rounding of ω and of the sums here: measured 5e-16
        EXPECT_NEAR(energy_of(body, start.omega_body) / energy_J, 1.0, 2e-15);
        EXPECT_NEAR(momentum_of(body, start.omega_body) / L, 1.0, 2e-15);
        const PolhodeStart same =
            start_on_polhode(body, {energy_J, {}, std::sqrt(2.0 * energy_J) / L}, direction);
        // The distance is rounded, which moves the polhode by as much.
        EXPECT_NEAR(energy_of(body, same.omega_body) / energy_J, 1.0, 2e-15);
        EXPECT_NEAR(momentum_of(body, same.omega_body) / L, 1.0, 4e-15);
    }
}

TEST(PolhodeStart, LiesInTheHalfPlaneOfTheDirection) {
    // L²/2T above the middle moment: the polhode encircles e1, the axis of the largest.
    const Vector3d about_1 =
        start_on_polhode(three, by_momentum(1.0, std::sqrt(2.0 * 2.4)), Vector3d(-1.0, 0.3, -0.4))
            .omega_body;
    EXPECT_LT(about_1[0], 0.0);
    EXPECT_NEAR(about_1[2] / about_1[1], -0.4 / 0.3, 1e-14);
    EXPECT_GT(about_1[1], 0.0);
    // Below: e2, the axis of the least.
    const Vector3d about_2 =
        start_on_polhode(three, by_momentum(1.0, std::sqrt(2.0 * 1.4)), Vector3d(0.3, 1.0, -0.4))
            .omega_body;
    EXPECT_NEAR(about_2[2] / about_2[0], -0.4 / 0.3, 1e-14);
    EXPECT_GT(about_2[1], 0.0);
    // By default in the plane of both, in the positive quarter.
    for (const double inertia : {1.4, 2.0, 2.4}) {
        const Vector3d omega =
            start_on_polhode(three, by_momentum(1.0, std::sqrt(2.0 * inertia))).omega_body;
        EXPECT_EQ(omega[2], 0.0);
        EXPECT_GT(omega[0], 0.0);
        EXPECT_GT(omega[1], 0.0);
    }
}

TEST(PolhodeStart, KeepsAPointThatLiesOnThePolhode) {
    // The direction of a motion's own ω gives this ω.
    const Vector3d omega(0.75, 1.5, 0.3);
    const PolhodeStart start = start_on_polhode(
        three, by_momentum(energy_of(three, omega), momentum_of(three, omega)), omega);
    // T and L are rounded: measured 3e-16
    EXPECT_LT((start.omega_body - omega).norm(), 2e-15);
}

TEST(PolhodeStart, FollowsTheAxesOfATensor) {
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized().toRotationMatrix();
    const Eigen::Matrix3d tensor = turn * Vector3d(1.0, 2.0, 2.9).asDiagonal() * turn.transpose();
    const InertiaTensor body = InertiaTensor::from_matrix(0.5 * (tensor + tensor.transpose()));
    const PolhodeStart start = start_on_polhode(body, by_momentum(2.0, 2.9));
    EXPECT_NEAR(energy_of(body, start.omega_body), 2.0, 1e-14);
    EXPECT_NEAR(momentum_of(body, start.omega_body), 2.9, 1e-14);
}

// I₂ = 2 and 3: L = 2 for T = 1 is exact, √6 is not; no ω in doubles lies on that separatrix.
TEST(PolhodeStart, IsExactlyOnTheSeparatrix) {
    for (const double middle : {2.0, 2.3}) {
        const InertiaTensor body = InertiaTensor::from_principal_moments({1.0, middle, 2.9});
        for (const ConservedQuantities& conserved :
             {by_momentum(1.0, std::sqrt(2.0 * middle)),
              ConservedQuantities{1.0, {}, 1.0 / std::sqrt(middle)}}) {
            const PolhodeStart start = start_on_polhode(body, conserved, Vector3d(0.5, 0.7, 0.4));
            EXPECT_TRUE(start.on_separatrix);
            const FreeRotation motion = motion_of(body, start);
            EXPECT_EQ(motion.regime(), Regime::separatrix);
            EXPECT_FALSE(motion.constants().polhode_period_s);
            // ω starts where it says, keeps T and L, and tends to the middle axis.
            EXPECT_LT((motion.at(0.0).omega_body - start.omega_body).norm(), 1e-15);
            for (const double t : {-30.0, -3.0, 0.4, 2.0, 40.0}) {
                const Vector3d omega = motion.at(t).omega_body;
                EXPECT_NEAR(energy_of(body, omega), 1.0, 2e-15);
                EXPECT_NEAR(momentum_of(body, omega), std::sqrt(2.0 * middle), 4e-15);
            }
            EXPECT_LT(motion.at(60.0).omega_body.cross(Vector3d::UnitY()).norm(), 1e-9);
            EXPECT_LT(motion.at(-60.0).omega_body.cross(Vector3d::UnitY()).norm(), 1e-9);
            // Closed form: ω₂ = √(2T/I₂) tanh(λ(t − t₀)), which vanishes at the crossing.
            const double t0 = *motion.constants().middle_axis_crossing_s;
            EXPECT_NEAR(motion.at(t0).omega_body[1], 0.0, 1e-14);
            const double rate =
                std::sqrt(2.0 / middle) * std::sqrt((middle - 1.0) * (2.9 - middle) / 2.9);
            EXPECT_NEAR(std::abs(motion.at(t0 + 0.7).omega_body[1]),
                        std::sqrt(2.0 / middle) * std::tanh(0.7 * rate), 1e-14);
        }
    }
    // A calculation in doubles may be off by one unit in the last place, as 1/√2 here; more is
    // beside the separatrix.
    EXPECT_NE(1.0 / std::sqrt(2.0), std::sqrt(0.5));
    const double neighbour = std::nextafter(2.0, 3.0);
    EXPECT_TRUE(start_on_polhode(three, by_momentum(1.0, neighbour)).on_separatrix);
    EXPECT_FALSE(
        start_on_polhode(three, by_momentum(1.0, std::nextafter(neighbour, 3.0))).on_separatrix);
}

TEST(PolhodeStart, ReachesPermanentRotationsAndSymmetricBodies) {
    // The ends of the range, also as rounded roots.
    EXPECT_EQ(start_on_polhode(three, by_momentum(0.5, 1.0)).omega_body, Vector3d(0.0, 1.0, 0.0));
    const PolhodeStart fastest = start_on_polhode(three, {1.0, {}, 1.0 / std::sqrt(2.9)});
    EXPECT_EQ(motion_of(three, fastest).regime(), Regime::permanent);
    for (const Vector3d& moments : {Vector3d(1.0, 1.0, 1.8), Vector3d(2.0, 2.0, 0.8)}) {
        const InertiaTensor body = InertiaTensor::from_principal_moments(moments);
        const double L = std::sqrt(2.0 * 0.5 * (moments[0] + moments[2]));
        const PolhodeStart start =
            start_on_polhode(body, by_momentum(1.0, L), Vector3d(0.3, 0.4, 1.0));
        EXPECT_NEAR(energy_of(body, start.omega_body), 1.0, 2e-15);
        EXPECT_NEAR(momentum_of(body, start.omega_body), L, 4e-15);
        EXPECT_NEAR(start.omega_body[1] / start.omega_body[0], 4.0 / 3.0, 1e-14);
        EXPECT_FALSE(start.on_separatrix);
        // About any axis of the equator.
        const PolhodeStart across = start_on_polhode(
            body, by_momentum(1.0, std::sqrt(2.0 * moments[0])), Vector3d(0.3, 0.4, 0.0));
        EXPECT_NEAR(across.omega_body[1] / across.omega_body[0], 4.0 / 3.0, 1e-14);
        EXPECT_EQ(across.omega_body[2], 0.0);
        EXPECT_FALSE(across.on_separatrix);
    }
    const InertiaTensor sphere = InertiaTensor::from_principal_moments({2.0, 2.0, 2.0});
    EXPECT_LT((start_on_polhode(sphere, by_momentum(1.0, 2.0), Vector3d(3.0, 0.0, 4.0)).omega_body -
               Vector3d(0.6, 0.0, 0.8))
                  .norm(),
              1e-15);
}

TEST(PolhodeStart, RefusesWhatNoRotationHas) {
    EXPECT_EQ(said_about(by_momentum(2.0, 5.0)),
              "momentum_kg_m2_s = 5 is impossible for this body with energy_J = 2: "
              "2T I_min <= L^2 <= 2T I_max requires L between 2 and 3.40587727 kg m^2/s");
    EXPECT_EQ(said_about({2.0, {}, 0.5}),
              "plane_distance = 0.5 is impossible for this body: 2T I_min <= L^2 <= 2T I_max "
              "requires sqrt(2T)/L between 0.58722022 and 1 1/sqrt(kg m^2)");
    EXPECT_NE(said_about(by_momentum(2.0, 1.9)), "");
    EXPECT_NE(said_about(by_momentum(2.0, 2.0 - 1e-15)), "");
    EXPECT_EQ(said_about(by_momentum(2.0, 2.0)), "");
}

// Nine digits do not tell these limits apart, nor the third value from its limit.
TEST(PolhodeStart, SaysLimitsWithTheDigitsThatTellThemApart) {
    const auto refusal = [](const Vector3d& moments, const ConservedQuantities& conserved) {
        try {
            start_on_polhode(InertiaTensor::from_principal_moments(moments), conserved, {});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const double I = 2.953e-11;
    const auto limits = [](const std::string& said) {
        const std::size_t from = said.find("requires L between ") + 19;
        const std::size_t between = said.find(" and ", from);
        return std::array{said.substr(from, between - from),
                          said.substr(between + 5, said.find(' ', between + 5) - between - 5)};
    };
    const auto near = limits(refusal({I, I, I * (1.0 + 1e-12)}, by_momentum(7.6e-64, 50.0)));
    EXPECT_LT(std::stod(near[0]), std::stod(near[1])) << near[0] << " " << near[1];
    EXPECT_NE(refusal({I, I, I}, by_momentum(7.6e-64, 50.0)).find("requires L of 2.118"),
              std::string::npos);
    EXPECT_EQ(refusal({2.0, 2.5, 3.0}, by_momentum(2.0, std::sqrt(12.0) * (1.0 + 1e-11))),
              "momentum_kg_m2_s = 3.4641016152 is impossible for this body with energy_J = 2: "
              "2T I_min <= L^2 <= 2T I_max requires L between 2.8284271247 and 3.4641016151 kg "
              "m^2/s");
}

}  // namespace
}  // namespace poinsot
