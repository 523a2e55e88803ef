// Errors are measured rightly, steps are chosen to reach what is asked, certificates tell good from
// bad.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "construction/certificate.h"
#include "construction/motion_errors.h"
#include "construction/step_choice.h"

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

TEST(MotionErrors, AngleIsThatOfTheRotationBetween) {
    const Eigen::Quaterniond a(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 2).normalized()));
    for (const double angle : {1e-14, 1e-8, 0.1, 3.0}) {
        const Eigen::Quaterniond b = a * Eigen::Quaterniond(Eigen::AngleAxisd(
                                             angle, Eigen::Vector3d(2, -1, 2).normalized()));
        EXPECT_NEAR(angle_between(a, b), angle, 4e-16 + 4e-16 * angle);
        EXPECT_NEAR(angle_between(a, Eigen::Quaterniond(-b.coeffs())), angle,
                    4e-16 + 4e-16 * angle);
    }
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

TEST(StepChoice, ReachesWhatIsAskedAndNotMuchMore) {
    for (const std::string method : {"rk4", "rkmk4", "splitting", "dopri5"}) {
        for (const double tolerance : {1e-3, 1e-5}) {
            const MotionProblem problem = generic_problem(method);
            const StepChoice choice = choose_step(problem, tolerance);
            ASSERT_TRUE(choice.reached) << method;
            MotionProblem chosen = problem;
            chosen.method = choice.method;
            const double error =
                worst_errors(Motion(chosen), Motion(generic_problem("exact")), frames())
                    .attitude_rad;
            EXPECT_LT(error, 1.1 * tolerance) << method;

            // Twice the step (ten times the tolerance) would not do.
            if (choice.method.step_s) {
                chosen.method.step_s = 2.0 * *choice.method.step_s;
                const double coarser =
                    worst_errors(Motion(chosen), Motion(generic_problem("exact")), frames())
                        .attitude_rad;
                EXPECT_GT(coarser, tolerance) << method;
            }
        }
    }
}

TEST(StepChoice, LeavesAGivenStepAlone) {
    MotionProblem problem = generic_problem("rk4");
    problem.method.step_s = 0.125;
    EXPECT_EQ(choose_step(problem, 1e-9).method.step_s, 0.125);
    EXPECT_FALSE(choose_step(generic_problem("exact"), 1e-9).method.step_s);
}

TEST(StepChoice, SaysWhenItCannotBeReached) {
    const StepChoice choice = choose_step(generic_problem("euler"), 1e-9, 2e4);
    EXPECT_FALSE(choice.reached);
    EXPECT_GT(choice.attitude_rad, 1e-9);
}

}  // namespace
}  // namespace poinsot
