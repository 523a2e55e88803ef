// Measured errors are correct, and chosen steps reach the requested accuracy.
#include "mechanics/motion_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "mechanics/generic_problem.h"
#include "mechanics/step_choice.h"

namespace poinsot {
namespace {

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

TEST(StepChoice, ReachesTheToleranceWithoutWaste) {
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

            // Twice the step (ten times the tolerance) would not suffice.
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

TEST(StepChoice, KeepsAGivenStep) {
    MotionProblem problem = generic_problem("rk4");
    problem.method.step_s = 0.125;
    EXPECT_EQ(choose_step(problem, 1e-9).method.step_s, 0.125);
    EXPECT_FALSE(choose_step(generic_problem("exact"), 1e-9).method.step_s);
}

TEST(StepChoice, ReportsAnUnreachableTolerance) {
    const StepChoice choice = choose_step(generic_problem("euler"), 1e-9, 2e4);
    EXPECT_FALSE(choice.reached);
    EXPECT_GT(choice.attitude_rad, 1e-9);
}

MotionProblem damped_problem(const std::string& method) {
    MotionProblem problem = generic_problem(method);
    problem.torque = InternalFriction{0.01};
    return problem;
}

// The number of steps for a tolerance is known only after the integration; a clock instead of a
// count would choose differently on a slower machine, and the parts of one film could have
// different motions.
TEST(StepChoice, CountsTheStepsOfATolerance) {
    for (const MotionProblem& problem : {generic_problem("dopri5"), damped_problem("dopri5")}) {
        const StepChoice choice = choose_step(problem, 1e-14, 100.0);
        EXPECT_FALSE(choice.reached);
        MotionProblem chosen = problem;
        chosen.method = choice.method;
        const std::int64_t n_steps = Motion(chosen).integrated()->counters().n_steps;
        EXPECT_GT(n_steps, 100);
        EXPECT_LT(n_steps, 250);  // fifth order: a tenth of the tolerance needs 1.6 times the steps
    }
}

// If even the coarsest step exceeds the number of steps, its error is measured all the same.
TEST(StepChoice, MeasuresTheCoarsestStepIfThereIsNoOther) {
    const MotionProblem problem = damped_problem("rkmk4");
    const StepChoice choice = choose_step(problem, 1e-14, 1.0);
    EXPECT_FALSE(choice.reached);
    EXPECT_TRUE(choice.method.step_s);
    EXPECT_GT(choice.attitude_rad, 1e-14);
}

}  // namespace
}  // namespace poinsot
