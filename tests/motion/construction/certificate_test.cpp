// Certificates hold for exact motions and fail for inaccurate ones.
#include "construction/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "error/error.h"
#include "mechanics/generic_problem.h"
#include "mechanics/methods.h"
#include "mechanics/step_choice.h"

namespace poinsot {
namespace {

TEST(Certificate, HoldsForTheExactMotion) {
    const Certificate certificate =
        certify(Motion(generic_problem("exact")), frames(), exact_residual_bound);
    for (const CertifiedClaim& claim : certificate.claims) {
        EXPECT_TRUE(claim.holds()) << claim.name << ": " << claim.worst;
    }
    EXPECT_EQ(certificate.n_instants, 300);
}

// Where the contact point is at rest or nearly so, the certificate requires only the accuracy of
// doubles.
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

// Moments of twelve decades, which no body has: such motions may be much faster than ω is at the
// start.
TEST(Certificate, HoldsForMomentsThatNoBodyHas) {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> decades(-6.0, 6.0), component(-1.0, 1.0);
    int n_measured = 0;
    for (int n = 0; n < 400; ++n) {
        MotionProblem problem;
        problem.inertia = InertiaTensor::from_principal_moments(
            {std::pow(10.0, decades(random)), std::pow(10.0, decades(random)),
             std::pow(10.0, decades(random))},
            Physicality::waived);
        for (double& w : problem.start.omega_body)
            w = component(random) * (n % 2 == 0 ? 1.0 : std::pow(10.0, decades(random)));
        std::vector<double> times;
        for (int k = 0; k < 20; ++k) times.push_back(0.5 * k / problem.start.omega_body.norm());
        const Certificate certificate = certify(Motion(problem), times, exact_residual_bound);
        for (const CertifiedClaim& claim : certificate.claims)
            EXPECT_FALSE(claim.fails()) << claim.name << " " << claim.worst << " for "
                                        << problem.inertia.moments_kg_m2().transpose() << ", omega "
                                        << problem.start.omega_body.transpose();
        n_measured += certificate.claims.back().measured() ? 1 : 0;
    }
    EXPECT_GT(n_measured, 100);
}

// After an hour, a month, 1e15 s: the certificate of the exact motion does not fail; where no
// difference in time can be formed, the claim is not tested.
TEST(Certificate, HoldsAtAnyTimeOrIsNotTested) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments({3.0, 2.0, 1.5});
    problem.start.omega_body = {3.0, 12.0, 5.0};
    const Motion motion(problem);
    for (const double start_s : {0.0, 3.6e3, 2.6e6, 1e9, 1e12, 1e15}) {
        std::vector<double> times;
        for (int k = 0; k < 500; ++k) times.push_back(start_s + k / 30.0);
        const Certificate certificate = certify(motion, times, exact_residual_bound);
        for (const CertifiedClaim& claim : certificate.claims) {
            EXPECT_FALSE(claim.fails())
                << claim.name << " " << claim.worst << " from " << start_s << " s";
            const bool speeds = claim.name == "speed_difference";
            if (!speeds || start_s <= 3.6e3) {
                EXPECT_EQ(claim.n_measured, 500) << claim.name;
            } else if (start_s >= 1e9) {
                EXPECT_FALSE(claim.measured()) << start_s;
            }
        }
        EXPECT_TRUE(certificate.holds());
    }
}

// A tested claim can fail: the certificate detects the different speeds of a motion that slips.
TEST(Certificate, DetectsDifferentSpeeds) {
    MotionProblem problem = generic_problem("euler");
    problem.method.step_s = 0.01;
    const Certificate certificate = certify(Motion(problem), frames(), exact_residual_bound);
    const CertifiedClaim& speeds = certificate.claims[6];
    EXPECT_EQ(speeds.name, "speed_difference");
    EXPECT_TRUE(speeds.measured());
    EXPECT_TRUE(speeds.fails()) << speeds.worst;
}

// The certificate is also exact for the smallest moments and the slowest rotation.
TEST(Certificate, HoldsForTheSmallestNumbers) {
    const std::vector<double> instants{0.0, 0.4, 1.7, 5.0, 9.3, 20.0};
    for (const double unit : {1e-300, 1e-307, 1e-310, 1e-315, 1e-320}) {
        MotionProblem problem;
        problem.inertia = InertiaTensor::from_principal_moments({unit, 2.0 * unit, 2.5 * unit},
                                                                Physicality::waived);
        problem.start.omega_body = {0.3, 1.0, 0.2};
        const Certificate certificate = certify(Motion(problem), instants, exact_residual_bound);
        for (const CertifiedClaim& claim : certificate.claims)
            EXPECT_TRUE(claim.holds()) << claim.name << " " << claim.worst << " at " << unit;
    }
    for (const double rate : {1e-100, 1e-160, 1e-170, 1e-300}) {
        MotionProblem problem;
        problem.inertia = InertiaTensor::from_principal_moments({1.0, 2.0, 2.5});
        problem.start.omega_body = rate * Eigen::Vector3d(0.3, 1.0, 0.2);
        std::vector<double> turns;
        turns.reserve(instants.size());
        for (const double turn : instants) turns.push_back(turn / rate);
        const Certificate certificate = certify(Motion(problem), turns, exact_residual_bound);
        for (const CertifiedClaim& claim : certificate.claims)
            EXPECT_TRUE(claim.holds()) << claim.name << " " << claim.worst << " at " << rate;
    }
}

// Bodies of all kinds, almost spheres and needles among them, from any start.
MotionProblem random_problem(int k) {
    std::mt19937 random(static_cast<unsigned>(k));
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const double x = part(random) + 0.02, y = part(random) + 0.02, z = part(random) + 0.02;
    Eigen::Vector3d moments(y + z, z + x, x + y);
    if (k % 4 == 1) moments = Eigen::Vector3d::Constant(3.0) + 0.05 * moments;
    if (k % 4 == 2) moments = {1.0 + 0.005 * x, 1.0 + 0.005 * y, 0.02};
    if (k == 0) moments = {2.988, 3.114, 3.125};
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(moments);
    problem.start.omega_body = {part(random) - 0.5, part(random) - 0.5, part(random) - 0.5};
    if (k % 3 == 2) problem.start.omega_body.head<2>() *= 0.01;
    problem.last_time_s = 60.0 * part(random) / problem.start.omega_body.norm();
    return problem;
}

// A stepped motion within the accuracy asked passes every claim; one of ten times the step, which
// is not, fails one.
TEST(Certificate, GivesTheAnswerOfTheAccuracyAsked) {
    int n_chosen = 0;
    for (int k = 0; k < 8; ++k) {
        const MotionProblem random = random_problem(k);
        const double accuracy_rad = std::pow(10.0, -2.0 - k % 4);
        std::vector<double> times;
        for (int i = 0; i <= 200; ++i) times.push_back(random.last_time_s * i / 200.0);
        for (const Method& method : methods()) {
            if (method.make == nullptr || (method.name == "euler" && accuracy_rad < 1e-3)) continue;
            for (const int order : method.orders) {
                MotionProblem problem = random;
                problem.method.name = method.name;
                problem.method.order = order;
                const StepChoice choice = choose_step(problem, accuracy_rad);
                if (!choice.reached) continue;
                const MethodChoice coarsest = coarsest_choice(problem);
                problem.method = choice.method;
                for (const CertifiedClaim& claim :
                     certify(Motion(problem), times, accuracy_rad).claims)
                    EXPECT_TRUE(claim.holds())
                        << claim.name << " " << claim.worst << " > " << claim.bound << " by "
                        << method.name << " " << order << ", problem " << k;
                // Where twice the step would do as well, ten times may.
                if (choice.method.step_s == coarsest.step_s || !method.takes_step) continue;
                problem.method.step_s = std::min(problem.last_time_s, 10.0 * *choice.method.step_s);
                ++n_chosen;
                try {
                    EXPECT_FALSE(certify(Motion(problem), times, accuracy_rad).holds())
                        << method.name << " " << order << ", problem " << k;
                } catch (const InputError&) {
                    // A step for which an implicit method finds no solution.
                }
            }
        }
    }
    EXPECT_GT(n_chosen, 20);
}

TEST(Certificate, FailsForEuler) {
    MotionProblem problem = generic_problem("euler");
    problem.method.step_s = 0.01;
    const Certificate certificate = certify(Motion(problem), frames(), 1e-4);
    EXPECT_FALSE(certificate.holds());
}

}  // namespace
}  // namespace poinsot
