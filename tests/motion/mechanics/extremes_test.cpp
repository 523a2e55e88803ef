// Extremes of the free motion, one property per test, compared with the oracle or a conservation
// law.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "error/error.h"
#include "mechanics/free/free_rotation.h"
#include "mechanics/free_rotation_oracle.h"
#include "refusal.h"

namespace poinsot {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr Quantities everything{.attitude = true, .herpolhode = true, .euler_angles = false};

FreeRotation motion_of(const Vector3d& moments, const Vector3d& omega) {
    RotationState start;
    start.omega_body = omega;
    return {InertiaTensor::from_principal_moments(moments, Physicality::waived), start};
}

// Angle between two attitudes, for small angles.
double angle(const Quaterniond& a, const Quaterniond& b) {
    return 2.0 * std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

// The largest of the errors of ω (relative), attitude (rad) and herpolhode (relative).
double error_at(const FreeRotation& motion, const oracle::FreeMotion& truth, double t) {
    const MotionSample got = motion.sample(t, everything);
    const oracle::Answer expected = truth.at(t);
    using LongVector = Eigen::Matrix<long double, 3, 1>;
    const LongVector omega(expected.omega[0], expected.omega[1], expected.omega[2]);
    const LongVector h(expected.herpolhode[0], expected.herpolhode[1], expected.herpolhode[2]);
    const Eigen::Matrix<long double, 4, 1> q(expected.attitude[1], expected.attitude[2],
                                             expected.attitude[3], expected.attitude[0]);
    const auto got_q = got.state.space_from_body.coeffs().cast<long double>();
    const long double attitude = 2.0L * std::min((got_q - q).norm(), (got_q + q).norm());
    const long double h_error = (got.herpolhode_space.cast<long double>() - h).norm();
    return static_cast<double>(
        std::max({(got.state.omega_body.cast<long double>() - omega).norm() / omega.norm(),
                  attitude, h.norm() > 0.0L ? h_error / h.norm() : h_error}));
}
double error_at(const Vector3d& moments, const Vector3d& omega, const std::vector<double>& times) {
    const FreeRotation motion = motion_of(moments, omega);
    const oracle::FreeMotion truth(moments, omega);
    double worst = 0.0;
    for (const double t : times) worst = std::max(worst, error_at(motion, truth, t));
    return worst;
}

constexpr double bound = 2e-15;

TEST(Extremes, UnsortedAxesKeepTheirNamesAndAccuracy) {
    const Vector3d moments(1.0, 2.0, 2.5);
    const Vector3d omega(0.3, 1.0, -0.2);
    std::array<int, 3> order{0, 1, 2};
    do {
        Vector3d I;
        Vector3d w;
        for (int i = 0; i < 3; ++i) {
            I[i] = moments[order[static_cast<std::size_t>(i)]];
            w[i] = omega[order[static_cast<std::size_t>(i)]];
        }
        EXPECT_LE(error_at(I, w, {0.0, 0.7, 13.0, -200.0}), bound);
        const int highest = motion_of(I, w).constants().encircled_axis;
        EXPECT_EQ(I[highest],
                  motion_of(moments, omega).regime() == Regime::elliptic_about_highest ? 2.5 : 1.0);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Extremes, NegativeTimeIsTheReversedMotion) {
    const Vector3d moments(1.0, 2.0, 2.5);
    for (const Vector3d& omega : {Vector3d(0.3, 1.0, -0.2), Vector3d(0.1, 0.2, 1.0),
                                  Vector3d(1e-8, 1.0, 1e-8), Vector3d(0.75, 0.5, 1.0)}) {
        const FreeRotation forwards = motion_of(moments, omega);
        const FreeRotation backwards = motion_of(moments, -omega);
        for (const double t : {0.3, 5.0, 77.0}) {
            const RotationState a = forwards.at(-t);
            const RotationState b = backwards.at(t);
            EXPECT_LE((a.omega_body + b.omega_body).norm(), bound * omega.norm());
            EXPECT_LE(angle(a.space_from_body, b.space_from_body), bound);
        }
    }
}

TEST(Extremes, LosesNoAccuracyInABillionPeriods) {
    const Vector3d moments(1.0, 2.0, 3.0);
    const double period = *motion_of(moments, {0.3, 1.0, 0.2}).constants().polhode_period_s;
    EXPECT_LE(error_at(moments, {0.3, 1.0, 0.2}, {1e9 * period, -1e9 * period, 1e15, -1e15}),
              bound);
}

TEST(Extremes, InstantsDoNotDependOnEarlierEvaluations) {
    const FreeRotation motion = motion_of({1.0, 2.0, 3.0}, {0.3, 1.0, 0.2});
    std::vector<Quaterniond> film;
    film.reserve(300);
    for (int k = 0; k < 300; ++k) film.push_back(motion.at(k * 1001.0 / 30000.0).space_from_body);
    for (const int k : {299, 0, 17}) {
        const FreeRotation again = motion_of({1.0, 2.0, 3.0}, {0.3, 1.0, 0.2});
        EXPECT_EQ(again.at(k * 1001.0 / 30000.0).space_from_body.coeffs(),
                  film[static_cast<std::size_t>(k)].coeffs());
    }
}

TEST(Extremes, FlipsAboutTheMiddleAxisHaveCorrectTimes) {
    for (const double size : {1e-8, 1e-150}) {
        const Vector3d moments(1.0, 2.0, 3.0);
        const Vector3d omega(size, 1.0, size == 1e-8 ? -size : size);
        const FreeRotation motion = motion_of(moments, omega);
        const oracle::FreeMotion truth(moments, omega);
        const double half_period = 0.5 * *motion.constants().polhode_period_s;
        // Between two passages of the middle axis ω₂ changes sign once; the instant is found by
        // bisection.
        double before = 0.0;
        double after = half_period;
        ASSERT_GT(motion.at(before).omega_body[1], 0.0);
        ASSERT_LT(motion.at(after).omega_body[1], 0.0);
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (before + after);
            (motion.at(middle).omega_body[1] > 0.0 ? before : after) = middle;
        }
        const double margin = 4.0 * epsilon * after;
        for (int n = 0; n < 5; ++n) {
            const double flip = after + n * half_period;
            const double sign = n % 2 == 0 ? 1.0 : -1.0;
            EXPECT_GT(sign * static_cast<double>(truth.at(flip - (n + 1) * margin).omega[1]), 0.0);
            EXPECT_LT(sign * static_cast<double>(truth.at(flip + (n + 1) * margin).omega[1]), 0.0);
        }
        EXPECT_LE(error_at(moments, omega, {0.5 * after, after, 1.5 * after, 7.3 * after}), bound);
    }
}

TEST(Extremes, SeparatrixIsRecognisedOnAllFourBranches) {
    const Vector3d moments(1.0, 2.0, 2.25);
    for (const double first : {-1.0, 1.0}) {
        for (const double third : {-1.0, 1.0}) {
            const Vector3d omega(0.75 * first, 0.5, 1.0 * third);
            const FreeRotation motion = motion_of(moments, omega);
            EXPECT_EQ(motion.regime(), Regime::separatrix);
            EXPECT_FALSE(motion.constants().polhode_period_s.has_value());
            EXPECT_EQ(motion.constants().complementary_modulus, 0.0);
            EXPECT_EQ(motion.constants().least_herpolhode_radius_rad_s, 0.0);
            EXPECT_LE(error_at(moments, omega, {0.5, 2.0, 10.0, 30.0, -3.0, -30.0}), bound);
            // Finally the body spins about the middle axis permanently.
            const RotationState late = motion.at(1e6);
            EXPECT_EQ(late.omega_body[0], 0.0);
            EXPECT_EQ(late.omega_body[2], 0.0);
            EXPECT_LE(
                std::abs(std::abs(late.omega_body[1]) - motion.constants().momentum_kg_m2_s / 2.0),
                1e-15);
        }
    }
}

TEST(Extremes, OneUlpFromTheSeparatrixLieOppositeFamilies) {
    const Vector3d moments(1.0, 2.0, 2.25);
    const Vector3d above(std::nextafter(0.75, 0.0), 0.5, 1.0);
    const Vector3d below(std::nextafter(0.75, 1.0), 0.5, 1.0);
    EXPECT_EQ(motion_of(moments, above).regime(), Regime::elliptic_about_highest);
    EXPECT_EQ(motion_of(moments, below).regime(), Regime::elliptic_about_lowest);
    EXPECT_LE(error_at(moments, above, {0.0, 2.0, 30.0, 100.0, 1e9}), bound);
    EXPECT_LE(error_at(moments, below, {0.0, 2.0, 30.0, 100.0, 1e9}), bound);
    // Until the first return they agree with the separatrix, except for the difference of the
    // starts.
    const FreeRotation between = motion_of(moments, {0.75, 0.5, 1.0});
    for (const double t : {0.0, 1.0, 3.0}) {
        const RotationState middle = between.at(t);
        for (const Vector3d& omega : {above, below}) {
            const RotationState side = motion_of(moments, omega).at(t);
            EXPECT_LE((side.omega_body - middle.omega_body).norm(), 3e-15);  // measured 3e-16
            EXPECT_LE(angle(side.space_from_body, middle.space_from_body),
                      3e-15);  // measured 7.4e-16
        }
    }
}

TEST(Extremes, EqualMomentsAreTheLimitOfNearlyEqualOnes) {
    const double up2 = std::nextafter(2.0, 3.0);
    const double up1 = std::nextafter(1.0, 2.0);
    const double up1_twice = std::nextafter(up1, 2.0);
    const Vector3d omega(0.5, 0.3, 1.0);
    struct Pair {
        Vector3d equal;
        Vector3d nearly;
    };
    for (const Pair& pair :
         {Pair{{2.0, 2.0, 3.0}, {2.0, up2, 3.0}}, Pair{{2.0, 2.0, 3.0}, {up2, 2.0, 3.0}},
          Pair{{2.0, 2.0, 1.0}, {2.0, up2, 1.0}}, Pair{{2.0, 2.0, 2.0}, {2.0, up2, 2.0}},
          Pair{{1.0, 1.0, 1.0}, {1.0, up1, up1_twice}}}) {
        const FreeRotation equal = motion_of(pair.equal, omega);
        const FreeRotation nearly = motion_of(pair.nearly, omega);
        for (const double t : {0.0, 1.0, 2.5}) {
            const MotionSample a = equal.sample(t, everything);
            const MotionSample b = nearly.sample(t, everything);
            EXPECT_LE((a.state.omega_body - b.state.omega_body).norm(), 3e-15);
            EXPECT_LE(angle(a.state.space_from_body, b.state.space_from_body), 3e-15);
            EXPECT_LE((a.herpolhode_space - b.herpolhode_space).norm(), 3e-15);  // measured 6e-16
        }
        EXPECT_LE(error_at(pair.nearly, omega, {0.0, 1.0, 1e3, -1e9, 1e14}), bound);
        EXPECT_LE(error_at(pair.equal, omega, {0.0, 1.0, 1e3, -1e9, 1e14}), bound);
    }
    EXPECT_EQ(motion_of({2.0, 2.0, 3.0}, omega).regime(), Regime::symmetric);
    EXPECT_EQ(motion_of({2.0, 2.0, 2.0}, omega).regime(), Regime::permanent);
    EXPECT_EQ(motion_of({2.0, up2, 3.0}, omega).regime(), Regime::elliptic_about_highest);
}

TEST(Extremes, SteadySpinIsAPointOnBothCurves) {
    struct Spin {
        Vector3d moments;
        Vector3d omega;
    };
    for (const Spin& spin :
         {Spin{{1.0, 2.0, 3.0}, {0.0, 0.0, 1.5}}, Spin{{1.0, 2.0, 3.0}, {-1.5, 0.0, 0.0}},
          Spin{{1.0, 2.0, 3.0}, {0.0, 0.7, 0.0}}, Spin{{2.0, 2.0, 3.0}, {0.6, 0.8, 0.0}},
          Spin{{2.0, 2.0, 2.0}, {0.6, 0.8, 0.3}}, Spin{{2.0, 2.0, 3.0}, {0.0, 0.0, -1.0}}}) {
        const FreeRotation motion = motion_of(spin.moments, spin.omega);
        EXPECT_EQ(motion.regime(), Regime::permanent);
        EXPECT_EQ(motion.constants().greatest_herpolhode_radius_rad_s, 0.0);
        for (const double t : {0.0, 1.0, 1e9, -1e15}) {
            const MotionSample sample = motion.sample(t, everything);
            EXPECT_EQ(sample.state.omega_body, spin.omega);
            EXPECT_EQ(sample.herpolhode_space, Vector3d::Zero());
            EXPECT_LE(error_at(motion, oracle::FreeMotion(spin.moments, spin.omega), t), bound);
        }
    }
}

TEST(Extremes, WobblesKeepRelativeAccuracyOfTheHerpolhode) {
    for (const double size : {1e-8, 1e-150, 1e-300}) {
        EXPECT_LE(error_at({1.0, 2.0, 3.0}, {size, 2.0 * size, 1.0}, {0.0, 1.0, 100.0, 1e9}),
                  bound);
        EXPECT_LE(error_at({1.0, 2.0, 3.0}, {1.0, 2.0 * size, size}, {0.0, 1.0, 100.0, 1e9}),
                  bound);
        const FreeRotation motion = motion_of({1.0, 2.0, 3.0}, {size, 2.0 * size, 1.0});
        EXPECT_GT(motion.constants().least_herpolhode_radius_rad_s, 0.3 * size);
        EXPECT_LT(motion.constants().greatest_herpolhode_radius_rad_s, 3.0 * size);
    }
}

TEST(Extremes, SubnormalComponentsStayFinite) {
    const double least = std::numeric_limits<double>::denorm_min();
    for (const Vector3d& omega : {Vector3d(least, 1.0, least), Vector3d(1.0, least, 0.0),
                                  Vector3d(0.0, least, 1.0), Vector3d(least, least, least)}) {
        const FreeRotation motion = motion_of({1.0, 2.0, 3.0}, omega);
        for (const double t : {0.0, 10.0, -1e3, 1e6}) {
            const MotionSample sample = motion.sample(t, everything);
            EXPECT_TRUE(sample.state.omega_body.allFinite());
            EXPECT_TRUE(sample.herpolhode_space.allFinite());
            EXPECT_NEAR(sample.state.space_from_body.norm(), 1.0, 1e-15);
        }
    }
}

TEST(Extremes, NeedlesAreAsAccurateAsOtherBodies) {
    for (const Vector3d& moments : {Vector3d(1e-12, 1.0, 1.0), Vector3d(1e-12, 1.0, 1.0 + 5e-13),
                                    Vector3d(1e-6, 1.0, 1.0000003)}) {
        for (const Vector3d& omega :
             {Vector3d(0.3, 0.5, -0.2), Vector3d(1e3, 0.5, -0.2), Vector3d(1e9, 0.5, -0.2)}) {
            EXPECT_LE(error_at(moments, omega, {0.0, 0.01, 1.0, 100.0, -1e5}), bound);
        }
    }
}

TEST(Extremes, ALaminaIsAsAccurateAsOtherBodies) {
    EXPECT_LE(error_at({1.25, 2.75, 4.0}, {0.7, 0.9, -0.35}, {0.0, 1.0, 8.0, 40.0}), bound);
    const double short_of_it = 4.0 - 4.0 * 4.0 * epsilon;
    EXPECT_LE(error_at({1.25, 2.75, short_of_it}, {0.7, 0.9, -0.35}, {0.0, 1.0, 8.0}), bound);
}

TEST(Extremes, UnphysicalMomentsAreComputedWhenAllowed) {
    EXPECT_NE(refusal_message([] { InertiaTensor::from_principal_moments({1.0, 2.0, 3.5}); }), "");
    EXPECT_LE(error_at({1.0, 2.0, 3.5}, {0.3, 0.5, -0.2}, {0.0, 1.0, 30.0}), bound);
    EXPECT_LE(error_at({1e-12, 1.0, 1e12}, {0.3, 0.5, -0.2}, {0.0, 1e-17, 1e-16, 1.0}), bound);
}

TEST(Extremes, AngularVelocityMustBeFinite) {
    EXPECT_NE(refusal_message([] {
                  motion_of({1.0, 2.0, 3.0}, {0.0, std::nan(""), 0.0});
              }).find("omega_rad_s"),
              std::string::npos);
    EXPECT_NE(refusal_message([] {
                  motion_of({1.0, 2.0, 3.0}, {0.0, infinity, 0.0});
              }).find("omega_rad_s"),
              std::string::npos);
}

TEST(Extremes, ABodyAtRestStaysAtRest) {
    RotationState start;
    start.space_from_body = Quaterniond(0.5, 0.5, 0.5, 0.5);
    const FreeRotation motion(InertiaTensor::from_principal_moments({1.0, 2.0, 3.0}), start);
    EXPECT_EQ(motion.regime(), Regime::at_rest);
    for (const double t : {0.0, 1e300, -5.0}) {
        const MotionSample sample = motion.sample(t, everything);
        EXPECT_EQ(sample.state.omega_body, Vector3d::Zero());
        EXPECT_EQ(sample.state.space_from_body.coeffs(), start.space_from_body.coeffs());
        EXPECT_EQ(sample.herpolhode_space, Vector3d::Zero());
    }
}

TEST(Extremes, PowersOfTwoScaleTheMotionExactly) {
    for (const Vector3d& omega : {Vector3d(0.3, 1.0, 0.2), Vector3d(0.1, 0.2, 1.0),
                                  Vector3d(0.75, 0.5, 1.0), Vector3d(0.0, 0.0, 1.0)}) {
        const Vector3d moments(1.0, 2.0, 2.25);
        const FreeRotation motion = motion_of(moments, omega);
        for (const int exponent : {-665, -300, 300, 998}) {
            const FreeRotation heavier = motion_of(moments * std::ldexp(1.0, exponent), omega);
            for (const double t : {0.0, 0.7, 23.0}) {
                EXPECT_EQ(heavier.at(t).omega_body, motion.at(t).omega_body);
                EXPECT_EQ(heavier.at(t).space_from_body.coeffs(),
                          motion.at(t).space_from_body.coeffs());
            }
        }
        for (const int exponent : {-500, 500}) {
            const double scale = std::ldexp(1.0, exponent);
            const FreeRotation faster = motion_of(moments, omega * scale);
            for (const double t : {0.0, 0.7, 23.0}) {
                const MotionSample a = faster.sample(t / scale, everything);
                const MotionSample b = motion.sample(t, everything);
                EXPECT_EQ(a.state.omega_body, b.state.omega_body * scale);
                EXPECT_EQ(a.state.space_from_body.coeffs(), b.state.space_from_body.coeffs());
                EXPECT_EQ(a.herpolhode_space, b.herpolhode_space * scale);
            }
        }
    }
    EXPECT_LE(error_at({1e300, 2e300, 3e300}, {3e-301, 1e-300, 2e-301}, {0.0, 1e300, 2e301}),
              bound);
    EXPECT_LE(error_at({1e-200, 2e-200, 3e-200}, {0.3, 1.0, 0.2}, {0.0, 1.0, 20.0}), bound);
    EXPECT_LE(error_at({1.0, 2.0, 3.0}, {3e149, 1e150, 2e149}, {0.0, 1e-150, 2e-149}), bound);
}

TEST(Extremes, OnlyOverflowIsRefused) {
    EXPECT_NE(refusal_message([] {
                  motion_of({1e300, 2e300, 3e300}, {1e150, 0.0, 1e150});
              }).find("overflows"),
              std::string::npos);
    const FreeRotation fast = motion_of({1.0, 2.0, 3.0}, {3e149, 1e150, 2e149});
    EXPECT_NE(refusal_message([&] { fast.at(1e200); }).find("overflows"), std::string::npos);
    EXPECT_NE(refusal_message([&] { fast.at(infinity); }), "");
    EXPECT_NE(refusal_message([&] { fast.at(std::nan("")); }), "");
    // The phase has no accurate digit, but does not overflow: the result is still a rotation.
    for (const FreeRotation& motion :
         {motion_of({1.0, 2.0, 3.0}, {0.3, 1.0, 0.2}), motion_of({1.0, 2.0, 3.0}, {0.1, 0.2, 1.0}),
          motion_of({1.0, 2.0, 2.25}, {0.75, 0.5, 1.0}),
          motion_of({1.0, 2.0, 3.0}, {0.0, 0.0, 1.0})}) {
        for (const double t : {1e17, 1e30, -1e100, 1e307}) {
            const MotionSample sample = motion.sample(t, everything);
            EXPECT_NEAR(sample.state.space_from_body.norm(), 1.0, 1e-15);
            EXPECT_TRUE(sample.state.omega_body.allFinite());
            EXPECT_TRUE(sample.herpolhode_space.allFinite());
        }
    }
}

TEST(Extremes, AttitudesAreNormalisedOrRefused) {
    RotationState start;
    start.omega_body = {0.3, 1.0, 0.2};
    const InertiaTensor body = InertiaTensor::from_principal_moments({1.0, 2.0, 3.0});
    const FreeRotation plain(body, start);
    start.space_from_body = Quaterniond(2.0, 0.0, 0.0, 0.0);
    EXPECT_EQ(FreeRotation(body, start).at(3.0).space_from_body.coeffs(),
              plain.at(3.0).space_from_body.coeffs());
    start.space_from_body = Quaterniond(-1e-200, 0.0, 0.0, 0.0);
    EXPECT_EQ(FreeRotation(body, start).at(3.0).space_from_body.coeffs(),
              plain.at(3.0).space_from_body.coeffs());
    start.space_from_body = Quaterniond(0.0, 0.0, 0.0, 0.0);
    EXPECT_NE(refusal_message([&] {
                  FreeRotation(body, start);
              }).find("a finite quaternion other than zero"),
              std::string::npos);
    start.space_from_body = Quaterniond(1.0, std::nan(""), 0.0, 0.0);
    EXPECT_NE(refusal_message([&] { FreeRotation(body, start); }), "");
}

}  // namespace
}  // namespace poinsot
