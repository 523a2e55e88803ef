// Certificates tell good motions from bad ones.
#include "construction/certificate.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace poinsot {
namespace {

MotionProblem generic_problem(const std::string& method) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments({1.0, 2.0, 2.9});
    problem.start.omega_body = {1.678, 0.1, 0.639};
    problem.method.name = method;
    problem.last_time_s = 10.0;
    return problem;
}

std::vector<double> frames() {
    std::vector<double> times;
    for (int k = 0; k < 300; ++k) times.push_back(k / 30.0);
    return times;
}

TEST(Certificate, HoldsForTheExactMotion) {
    const Certificate certificate =
        certify(Motion(generic_problem("exact")), frames(), exact_residual_bound);
    for (const CertifiedClaim& claim : certificate.claims) {
        EXPECT_TRUE(claim.holds()) << claim.name << ": " << claim.worst;
    }
    EXPECT_EQ(certificate.n_instants, 300);
}

// Where the contact point stands still or nearly so, the certificate asks for no more than doubles
// can show.
TEST(Certificate, HoldsForSteadySpinsSmallWobblesAndNeedles) {
    const std::vector<double> times{0.0, 0.4, 1.7, 5.0, 9.3, 20.0};
    for (const Eigen::Vector3d& omega :
         {Eigen::Vector3d(0.0, 0.0, 1.0), Eigen::Vector3d(0.0, 1.0, 0.0),
          Eigen::Vector3d(1e-9, 2e-9, 1.0), Eigen::Vector3d(1e-5, 2e-5, 1.0),
          Eigen::Vector3d(1e-3, 2e-3, 1.0), Eigen::Vector3d(1e-300, 1e-300, 1.0)}) {
        MotionProblem problem;
        problem.inertia = InertiaTensor::from_principal_moments({1.0, 2.0, 2.5});
        problem.start.omega_body = omega;
        const Certificate certificate = certify(Motion(problem), times, exact_residual_bound);
        for (const CertifiedClaim& claim : certificate.claims) {
            EXPECT_TRUE(claim.holds())
                << claim.name << " " << claim.worst << " at ω = " << omega.transpose();
        }
    }
    MotionProblem needle;
    needle.inertia = InertiaTensor::from_principal_moments({1e-12, 1.0, 1.0 + 5e-13});
    needle.start.omega_body = {0.3, 0.5, -0.2};
    EXPECT_TRUE(certify(Motion(needle), times, exact_residual_bound).holds());
    MotionProblem light;
    light.inertia = InertiaTensor::from_principal_moments({1e-200, 2e-200, 2.5e-200});
    light.start.omega_body = {0.3, 1.0, 0.2};
    EXPECT_TRUE(certify(Motion(light), times, exact_residual_bound).holds());
    MotionProblem sphere;
    sphere.inertia = InertiaTensor::from_principal_moments({2.0, 2.0, 2.0});
    sphere.start.omega_body = {0.3, 1.0, 0.2};
    EXPECT_TRUE(certify(Motion(sphere), times, exact_residual_bound).holds());
}

TEST(Certificate, FailsForEuler) {
    MotionProblem problem = generic_problem("euler");
    problem.method.step_s = 0.01;
    const Certificate certificate = certify(Motion(problem), frames(), 1e-4);
    EXPECT_FALSE(certificate.holds());
}

}  // namespace
}  // namespace poinsot
