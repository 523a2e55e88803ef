// The inertial forces in the body's axes, compared with the accelerations of the masses in space.
#include "mechanics/inertial_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "mechanics/motion.h"

namespace poinsot {
namespace {

struct MassesInMotion {
    std::vector<PointMass> masses;  // from their centre of mass
    Motion motion;
};

MassesInMotion masses_in_motion(std::mt19937_64& random, const Torque& torque, const char* method) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> mass_kg(0.2, 2.0);
    const auto vector = [&] {
        return Eigen::Vector3d(normal(random), normal(random), normal(random));
    };
    std::vector<PointMass> masses(5);
    for (PointMass& mass : masses) mass = {mass_kg(random), vector()};
    const MassDistribution body = inertia_of_masses(masses);
    for (PointMass& mass : masses) mass.at_m -= body.centre_of_mass_m_body;
    MotionProblem problem;
    problem.inertia = body.inertia;
    problem.start.omega_body = vector();
    problem.torque = torque;
    problem.method = {method, {}, {}, {}};
    if (problem.method.name != "exact") problem.method.tolerance = 1e-13;
    problem.last_time_s = 2.0;
    return {masses, Motion(problem)};
}

// m d²(Rr)/dt² in body axes at the instant, from places in space: a difference of order 4.
Eigen::Vector3d mass_times_acceleration(const Motion& motion, const PointMass& mass,
                                        double time_s) {
    constexpr double h = 2e-3;
    const auto place = [&](int k) -> Eigen::Vector3d {
        return motion.at(time_s + k * h).space_from_body * mass.at_m;
    };
    const Eigen::Vector3d acceleration =
        (-place(-2) + 16.0 * place(-1) - 30.0 * place(0) + 16.0 * place(1) - place(2)) /
        (12.0 * h * h);
    return mass.mass_kg * (motion.at(time_s).space_from_body.conjugate() * acceleration);
}

// In the body's axes a mass is at rest: the inertial force balances the force that accelerates it
// in space. The difference has an error of h⁴ω⁶/90, and eps/h² by rounding. Measured: 1.4e-11 of
// the scale, 1e-8 N.
TEST(InertialForce, IsMinusMassTimesTheAccelerationInSpace) {
    std::mt19937_64 random(11);
    for (int k = 0; k < 200; ++k) {
        const MassesInMotion body = masses_in_motion(random, NoTorque{}, "exact");
        for (const double t : {0.3, 1.1}) {
            const RotationState state = body.motion.at(t);
            const Eigen::Vector3d rate = angular_acceleration(body.motion.problem(), state);
            for (const PointMass& mass : body.masses) {
                const Eigen::Vector3d force =
                    inertial_force(mass, state.omega_body, rate).total_N();
                const double scale =
                    mass.mass_kg * (1.0 + mass.at_m.norm()) *
                    std::pow(1.0 + state.omega_body.norm() + std::sqrt(rate.norm()), 6);
                EXPECT_LT((force + mass_times_acceleration(body.motion, mass, t)).norm(),
                          1e-9 * scale);
            }
        }
    }
}

TEST(InertialForce, HoldsUnderATorque) {
    std::mt19937_64 random(12);
    for (const Torque& torque : {Torque(ConstantTorqueInBody{{0.3, -0.2, 0.5}}),
                                 Torque(ConstantTorqueInSpace{{0.3, -0.2, 0.5}})}) {
        const MassesInMotion body = masses_in_motion(random, torque, "dopri5");
        const RotationState state = body.motion.at(1.0);
        const Eigen::Vector3d rate = angular_acceleration(body.motion.problem(), state);
        for (const PointMass& mass : body.masses) {
            const Eigen::Vector3d force = inertial_force(mass, state.omega_body, rate).total_N();
            EXPECT_LT((force + mass_times_acceleration(body.motion, mass, 1.0)).norm(),
                      1e-5);  // measured 1e-7
        }
    }
}

// The body as a whole is in equilibrium in its own axes: without a torque, the inertial forces have
// neither sum nor moment.
TEST(InertialForce, OfAFreeBodyBalance) {
    std::mt19937_64 random(13);
    for (int k = 0; k < 1000; ++k) {
        const MassesInMotion body = masses_in_motion(random, NoTorque{}, "exact");
        const RotationState state = body.motion.at(0.7);
        const Eigen::Vector3d rate = angular_acceleration(body.motion.problem(), state);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
        double scale = 0.0;
        for (const PointMass& mass : body.masses) {
            const InertialForce force = inertial_force(mass, state.omega_body, rate);
            sum += force.total_N();
            moment += mass.at_m.cross(force.total_N());
            scale += (1.0 + mass.at_m.norm()) * (force.centrifugal_N.norm() + force.euler_N.norm());
        }
        EXPECT_LT(sum.norm(), 1e-14 * scale);
        EXPECT_LT(moment.norm(), 1e-13 * scale);
    }
}

// The argument of the scene inertial_forces: in a disc, what the centrifugal force does across the
// disc accelerates the masses, and the sum with the Euler force lies in the disc.
TEST(InertialForce, InADiscLiesInTheDisc) {
    const std::vector<PointMass> masses{{3.0, {1.0, 0.0, 0.0}},
                                        {3.0, {-1.0, 0.0, 0.0}},
                                        {1.0, {0.0, 1.0, 0.0}},
                                        {1.0, {0.0, -1.0, 0.0}}};
    MotionProblem problem;
    problem.inertia = inertia_of_masses(masses).inertia;
    problem.start.omega_body = {0.01, 2.0, 0.02};
    const Motion motion(problem);
    double across_most = 0.0;
    for (int k = 0; k <= 100; ++k) {
        const RotationState state = motion.at(0.1 * k);
        const Eigen::Vector3d rate = angular_acceleration(problem, state);
        for (const PointMass& mass : masses) {
            const InertialForce force = inertial_force(mass, state.omega_body, rate);
            EXPECT_NEAR(force.total_N().z(), 0.0, 1e-14);
            across_most = std::max(across_most, std::abs(force.centrifugal_N.z()));
            // Outward from the axis of rotation.
            EXPECT_LT(std::abs(force.centrifugal_N.dot(state.omega_body)), 1e-13);
            EXPECT_GE(force.centrifugal_N.dot(mass.at_m), 0.0);
        }
    }
    EXPECT_GT(across_most, 1.0);
}

}  // namespace
}  // namespace poinsot
