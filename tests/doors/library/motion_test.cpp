// The public motion: the numbers of the motions inside, and errors for what cannot be computed.
#include "library/poinsot/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "error/error.h"
#include "mechanics/free_rotation_oracle.h"
#include "mechanics/motion.h"
#include "refusal.h"

namespace poinsot::library {
namespace {

using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const Vector3d moments{1.0, 2.0, 3.0}, omega{0.01, 2.0, 0.01};

bool refused_for(const std::string& word, const auto& call) {
    return refusal_message(call).find(word) != std::string::npos;
}

TEST(LibraryMotion, AgreesWithTheTextbooksFormulasAtAnyInstant) {
    const Motion motion(moments, omega);
    const oracle::FreeMotion truth(moments, omega);
    for (const double time_s : {0.0, 0.3, -12.5, 1e5, 1e12}) {
        const State state = motion.at(time_s);
        const oracle::Answer answer = truth.at(time_s);
        EXPECT_EQ(state.time_s, time_s);
        const Quaternion attitude(
            static_cast<double>(answer.attitude[0]), static_cast<double>(answer.attitude[1]),
            static_cast<double>(answer.attitude[2]), static_cast<double>(answer.attitude[3]));
        EXPECT_NEAR(std::abs(attitude.coeffs().dot(state.space_from_body.coeffs())), 1.0, 4e-15);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            EXPECT_NEAR(state.omega_body[row], static_cast<double>(answer.omega[i]), 4e-15);
            EXPECT_NEAR(state.herpolhode_space[row], static_cast<double>(answer.herpolhode[i]),
                        1e-14);
        }
    }
}

TEST(LibraryMotion, GivesManyInstantsAsOneByOne) {
    const Motion motion(moments, omega);
    const std::vector<double> times{5.0, -1.0, 5.0, 0.0};
    std::vector<State> states(times.size());
    motion.at(times, states);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const State alone = motion.at(times[i]);
        EXPECT_EQ(states[i].time_s, times[i]);
        EXPECT_EQ(states[i].omega_body, alone.omega_body);
        EXPECT_EQ(states[i].space_from_body.coeffs(), alone.space_from_body.coeffs());
        EXPECT_EQ(states[i].herpolhode_space, alone.herpolhode_space);
    }
    states.pop_back();
    EXPECT_EQ(refusal_message([&] { motion.at(times, states); }),
              "at: there are 4 times and 3 states; give as many of both");
}

// Turning the body axes turns ω and the attitude with them; the motion in space is the same.
TEST(LibraryMotion, TakesATensorInAnyBodyAxes) {
    const Quaternion turn = Quaternion(0.6, 0.1, -0.5, 0.4).normalized();
    const Eigen::Matrix3d axes = turn.toRotationMatrix();
    Eigen::Matrix3d tensor = axes * moments.asDiagonal() * axes.transpose();
    tensor = 0.5 * (tensor + tensor.transpose()).eval();
    const Motion principal(moments, omega);
    MotionOptions options;
    options.start_attitude = turn.conjugate();
    const Motion turned = Motion::with_tensor(tensor, axes * omega, options);
    EXPECT_TRUE((turned.body_from_principal() * turned.moments_kg_m2().asDiagonal() *
                 turned.body_from_principal().transpose())
                    .isApprox(tensor, 1e-14));
    for (const double time_s : {0.0, 1.7, 20.0}) {
        const State a = principal.at(time_s), b = turned.at(time_s);
        // The rounding of the tensor changes the motion by some ulp, which grow with the time.
        EXPECT_TRUE(b.omega_body.isApprox(axes * a.omega_body, 1e-11)) << time_s;
        EXPECT_TRUE((b.space_from_body.toRotationMatrix() * axes)
                        .isApprox(a.space_from_body.toRotationMatrix(), 1e-11))
            << time_s;
    }
}

TEST(LibraryMotion, HasTheConstantsOfTheStart) {
    const Motion motion(moments, omega);
    const Constants constants = motion.constants();
    const Vector3d momentum = moments.cwiseProduct(omega);
    EXPECT_NEAR(constants.kinetic_energy_J, 0.5 * momentum.dot(omega), 1e-15);
    EXPECT_NEAR(constants.momentum_kg_m2_s, momentum.norm(), 1e-15);
    EXPECT_TRUE(constants.momentum_space.isApprox(momentum, 1e-15));
    ASSERT_TRUE(constants.polhode_period_s);
    const State later = motion.at(*constants.polhode_period_s);
    EXPECT_TRUE(later.omega_body.isApprox(omega, 1e-12));
    EXPECT_NEAR(*constants.advance_per_period_rad / *constants.polhode_period_s,
                constants.precession_rad_s, 1e-14);
}

// Steady precession at θ = 60° of a top with A = C = 1 and Mgl = 1: φ̇² cos θ − ω₃φ̇ + 1 = 0, with
// A = C and ω₃ = ψ̇ + φ̇ cos θ.
TEST(LibraryMotion, KnowsTheHeavyTop) {
    const double theta = std::acos(0.5);
    const double spin = 3.0, phi_dot = spin - std::sqrt(spin * spin - 2.0);
    const TopStart start{.theta_rad = theta, .phi_dot_rad_s = phi_dot, .omega3_rad_s = spin};
    const Motion top = Motion::heavy_top(1.0, 1.0, 1.0, start);
    EXPECT_EQ(top.regime(), Regime::heavy_top);
    for (const double time_s : {0.0, 3.0, 500.0}) {
        const EulerAngles angles = top.euler_angles(time_s);
        // φ̇ and θ are rounded, so that the top nutates by some ulp.
        EXPECT_NEAR(angles.theta_rad, theta, 1e-13);
        EXPECT_NEAR(angles.phi_rad, phi_dot * time_s, 1e-12 * (1.0 + phi_dot * time_s));
    }
    const TopConstants constants = top.top_constants();
    EXPECT_NEAR(constants.p_psi_kg_m2_s, spin, 1e-15);
    EXPECT_NEAR(constants.precession_rad_s, phi_dot, 1e-13);
    EXPECT_TRUE(refused_for("top_constants", [&] { static_cast<void>(top.constants()); }));
    EXPECT_TRUE(refused_for("a free body has constants",
                            [&] { static_cast<void>(Motion(moments, omega).top_constants()); }));
}

// A constant torque along the only axis of rotation: ω = ω₀ + N t/I.
TEST(LibraryMotion, StepsUnderTorques) {
    const Vector3d spin{0.0, 0.0, 1.0};
    MotionOptions options;
    options.torque = ConstantTorqueInBody{{0.0, 0.0, 0.6}};
    options.method = "dopri5";
    options.tolerance = 1e-12;
    options.last_time_s = 4.0;
    const Motion driven(moments, spin, options);
    EXPECT_EQ(driven.regime(), Regime::integrated);
    EXPECT_NEAR(driven.at(4.0).omega_body[2], 1.0 + 0.6 * 4.0 / 3.0, 1e-10);
    EXPECT_NE(refusal_message([&] { static_cast<void>(driven.at(5.0)); }), "");
    options.torque = ConstantTorqueInSpace{{0.0, 0.0, 0.6}};
    EXPECT_NEAR(Motion(moments, spin, options).at(4.0).omega_body[2], 1.8, 1e-10);
    options.torque = InternalFriction{0.5};
    const Vector3d end = Motion(moments, omega, options).at(4.0).omega_body;
    EXPECT_LT(end.dot(moments.cwiseProduct(end)), omega.dot(moments.cwiseProduct(omega)));
    EXPECT_NEAR(moments.cwiseProduct(end).norm(), moments.cwiseProduct(omega).norm(), 1e-9);
    options.torque = Drag{.linear_1_s = {0.0, 0.0, 0.5}};
    EXPECT_NEAR(Motion(moments, spin, options).at(4.0).omega_body[2], std::exp(-2.0), 1e-10);
    // A physical pendulum that turns about e1, from the horizontal to the lowest point: the
    // potential energy Mgl has become ½ I1 ω².
    options.torque = Gravity{.mgl_N_m = 2.0, .arm_body = {0.0, 3.0, 0.0}};
    const Motion pendulum(moments, {0.0, 0.0, 0.0}, options);
    double fastest = 0.0;
    for (int i = 0; i <= 4000; ++i)
        fastest = std::max(fastest, std::abs(pendulum.at(1e-3 * i).omega_body[0]));
    EXPECT_NEAR(fastest, 2.0, 1e-5);
}

TEST(LibraryMotion, NamesEveryRegimeAsTheProgramDoes) {
    for (int i = 0; i <= static_cast<int>(Regime::integrated); ++i)
        EXPECT_EQ(name_of(static_cast<Regime>(i)),
                  poinsot::name_of(static_cast<poinsot::Regime>(i)));
    EXPECT_EQ(Motion(moments, {0.0, 0.0, 0.0}).regime(), Regime::at_rest);
    EXPECT_EQ(Motion(moments, {0.0, 1.0, 0.0}).regime(), Regime::permanent);
    EXPECT_EQ(Motion({2.0, 2.0, 1.0}, omega).regime(), Regime::symmetric);
    EXPECT_EQ(Motion(moments, {1.0, 0.1, 0.1}).regime(), Regime::elliptic_about_lowest);
    EXPECT_EQ(Motion(moments, {0.1, 0.1, 1.0}).regime(), Regime::elliptic_about_highest);
    EXPECT_EQ(Motion(moments, {0.1, 0.1, 1.0}).regime_sentence(),
              "polhode about e3, the axis of the largest moment (elliptic)");
}

TEST(LibraryMotion, RefusesWhatCannotBeComputed) {
    EXPECT_TRUE(refused_for("make I3 at most 2", [] { Motion({1.0, 1.0, 3.0}, omega); }));
    EXPECT_EQ(refusal_message([] {
                  Motion({1.0, 1.0, 3.0}, omega, {.allow_unphysical = true});
              }),
              "");
    EXPECT_NE(refusal_message([] { Motion({0.0, 1.0, 1.0}, omega); }), "");
    EXPECT_TRUE(refused_for("rk4", [] { Motion(moments, omega, {.torque = Gravity{1.0}}); }));
    EXPECT_TRUE(refused_for("exact", [] { Motion(moments, omega, {.method = "exacd"}); }));
    MotionOptions stepped{.method = "rk4", .last_time_s = 1.0};
    const auto refused = [&stepped] {
        return refusal_message([&] { Motion(moments, omega, stepped); });
    };
    EXPECT_EQ(refused(), "");
    stepped.step_s = -1.0;
    EXPECT_NE(refused(), "");
    stepped.step_s.reset();
    stepped.start_attitude = Quaternion(0.0, 0.0, 0.0, 0.0);
    EXPECT_NE(refused(), "");
    stepped.start_attitude = Quaternion::Identity();
    stepped.torque = Gravity{1.0, {0.0, 0.0, 0.0}};
    EXPECT_NE(refused(), "");
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_NE(refusal_message([&] { Motion({1.0, bad, 1.0}, omega); }), "") << bad;
        EXPECT_NE(refusal_message([&] { Motion(moments, {bad, 0.0, 0.0}); }), "") << bad;
        EXPECT_NE(refusal_message([&] { static_cast<void>(Motion(moments, omega).at(bad)); }), "");
        EXPECT_NE(refusal_message([&] { Motion::heavy_top(1.0, 1.0, bad, {.theta_rad = 1.0}); }),
                  "");
        EXPECT_NE(refusal_message([&] { Motion::heavy_top(1.0, 1.0, 1.0, {.theta_rad = bad}); }),
                  "");
        stepped.torque = ConstantTorqueInBody{{bad, 0.0, 0.0}};
        EXPECT_NE(refused(), "") << bad;
        stepped.torque = Gravity{1.0, {bad, 0.0, 1.0}};
        EXPECT_NE(refused(), "") << bad;
        stepped.torque = NoTorque{};
        stepped.last_time_s = bad;
        EXPECT_NE(refused(), "") << bad;
        stepped.last_time_s = 1.0;
        Eigen::Matrix3d tensor = moments.asDiagonal();
        tensor(0, 1) = tensor(1, 0) = bad;
        EXPECT_NE(refusal_message([&] { Motion::with_tensor(tensor, omega); }), "") << bad;
    }
}

// No state is returned that is not finite.
TEST(LibraryMotion, ReturnsNothingBeyondTheRangeOfDouble) {
    for (const double theta : {-0.1, 3.2, 1e16, 1e150, 1e308}) {
        const std::string said =
            refusal_message([=] { Motion::heavy_top(1.0, 1.0, 1.0, {.theta_rad = theta}); });
        EXPECT_NE(said.find("theta_rad is"), std::string::npos) << said;
        EXPECT_NE(said.find("give an angle from 0 to 3.14"), std::string::npos) << said;
    }
    EXPECT_NE(refusal_message([] {
                  Motion::heavy_top(1.0, 2.0, 1.0, {.theta_rad = 0.5, .omega3_rad_s = 1e308});
              }).find("omega3_rad_s: the angular momentum of the top overflows"),
              std::string::npos);
    const Motion fast =
        Motion::heavy_top(1.9, 0.339, 1.0, {.theta_rad = 0.5, .omega3_rad_s = 1e308});
    EXPECT_EQ(fast.at(0.0).omega_body, Eigen::Vector3d(0.0, 0.0, 1e308));
    EXPECT_TRUE(fast.at(1e-308).herpolhode_space.allFinite());
    // |L| stays, though 2T has no double.
    const Motion impossible({1.32, 2e-41, 1.0}, {-0.9, 2.0, 1e300}, {.allow_unphysical = true});
    for (const double time_s : {0.0, 1e-300}) {
        const Eigen::Vector3d rate = impossible.at(time_s).omega_body;
        const Eigen::Vector3d momentum(1.32 * rate[0], 2e-41 * rate[1], rate[2]);
        EXPECT_NEAR(momentum.stableNorm() / 1e300, 1.0, 1e-14);
    }
}

// A motion that was moved from is still one.
TEST(LibraryMotion, CopiesWhereOthersMove) {
    Motion first(moments, omega);
    const Motion second = std::move(first);
    EXPECT_EQ(first.at(1.0).omega_body,
              second.at(1.0).omega_body);  // NOLINT(bugprone-use-after-move)
}

}  // namespace
}  // namespace poinsot::library
