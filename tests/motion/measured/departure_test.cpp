#include "measured/departure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace poinsot {

namespace {

MotionProblem generic() {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments({4.0, 3.0, 1.5});
    problem.start.omega_body = {1.2, 0.8, 2.4};
    return problem;
}

MeasuredRow row_of(const Motion& motion, double time_s) {
    const RotationState state = motion.at(time_s);
    return {time_s, state.omega_body, state.space_from_body};
}

TEST(Departure, OfTheExactMotionIsRounding) {
    const Motion motion(generic());
    Departure departure(motion);
    for (int i = 0; i < 1000; ++i) departure.add(row_of(motion, 0.01 * i), true, true);
    EXPECT_EQ(departure.n_rows(), 1000u);
    EXPECT_EQ(departure.attitude_rad().value, 0.0);
    EXPECT_EQ(departure.omega_share().value, 0.0);
    EXPECT_LT(departure.energy_share().value, 3e-15);
    EXPECT_LT(departure.momentum_share().value, 3e-15);
    EXPECT_LT(departure.momentum_tilt_rad().value, 5e-15);
}

// Faults that are made by hand are found with their sizes and instants.
TEST(Departure, FindsSizeAndInstantOfAFault) {
    const Motion motion(generic());
    Departure departure(motion);
    for (int i = 0; i < 2000; ++i) {
        MeasuredRow row = row_of(motion, 0.01 * i);
        if (i == 700) row.omega_body *= 1.01;
        if (i == 900)
            row.space_from_body =
                Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitY()) * row.space_from_body;
        departure.add(row, true, true);
    }
    EXPECT_NEAR(departure.omega_share().value, 0.01, 1e-14);
    EXPECT_DOUBLE_EQ(departure.omega_share().time_s, 7.0);
    EXPECT_NEAR(departure.energy_share().value, 1.01 * 1.01 - 1.0, 1e-14);
    EXPECT_NEAR(departure.momentum_share().value, 0.01, 1e-14);
    EXPECT_NEAR(departure.attitude_rad().value, 0.25, 1e-14);
    EXPECT_DOUBLE_EQ(departure.attitude_rad().time_s, 9.0);
    // L is tilted by the turn's angle times the sine of its angle from the turn's axis, as a chord.
    const Eigen::Vector3d momentum = motion.free_constants().momentum_space.normalized();
    const Eigen::Vector3d turned = Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitY()) * momentum;
    EXPECT_NEAR(departure.momentum_tilt_rad().value, std::acos(momentum.dot(turned)), 1e-12);
}

TEST(Departure, OutlineKeepsEveryFaultOfALongTable) {
    const Motion motion(generic());
    Departure departure(motion);
    constexpr int n = 100'000;
    for (int i = 0; i < n; ++i) {
        MeasuredRow row = row_of(motion, 1e-3 * i);
        if (i % 9973 == 5) row.omega_body *= 2.0;
        departure.add(row, true, false);
    }
    EXPECT_LE(departure.outline().size(), 512u);
    EXPECT_GE(departure.outline().size(), 200u);
    int n_faults = 0;
    double before_s = -1.0;
    for (const DepartureAt& at : departure.outline()) {
        EXPECT_GT(at.time_s, before_s);
        before_s = at.time_s;
        EXPECT_FALSE(at.attitude_rad.has_value());
        n_faults += at.omega_share.value() > 0.9;
    }
    EXPECT_EQ(n_faults, n / 9973 + 1);
    EXPECT_DOUBLE_EQ(before_s, 1e-3 * (n - 1));
}

TEST(Departure, OfAForcedMotionHasNoConstants) {
    MotionProblem problem = generic();
    problem.torque = ConstantTorqueInBody{{0.1, 0.0, 0.0}};
    problem.method.name = "rkmk4";
    problem.last_time_s = 2.0;
    const Motion motion(problem);
    Departure departure(motion);
    departure.add(row_of(motion, 1.0), true, true);
    EXPECT_TRUE(departure.last().omega_share.has_value());
    EXPECT_FALSE(departure.last().energy_share.has_value());
    EXPECT_FALSE(departure.last().momentum_tilt_rad.has_value());
}

}  // namespace

}  // namespace poinsot
