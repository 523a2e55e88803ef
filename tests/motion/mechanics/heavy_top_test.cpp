// Lagrange's top compared with 40-digit references, an independent Taylor integration of Euler's
// equations in long double, closed forms and its own invariants.
#include "mechanics/top/heavy_top.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "error/error.h"
#include "mechanics/heavy_top_oracle.h"
#include "mechanics/motion.h"
#include "mechanics/reference_cases.h"
#include "mechanics/top_families.h"
#include "numerics/least_turn.h"
#include "refusal.h"

namespace poinsot::heavy_top_tests {
namespace {

constexpr double pi = std::numbers::pi;
using reference::Json;
using tops::Difference;
using tops::difference;
using tops::generic_top;
using tops::Quad;
using tops::TaylorTop;
using tops::uniform;
using tops::Wide;
constexpr double infinity = std::numeric_limits<double>::infinity();

HeavyTopProblem lecture_top() {
    return {.moment_transverse_kg_m2 = 1.0,
            .moment_axial_kg_m2 = 0.5,
            .mgl_N_m = 1.0,
            .theta_rad = 0.7,
            .omega3_rad_s = 8.0};
}

// p_φ, p_ψ and E of a state, each relative to the size of its terms.
double invariant_residual(const HeavyTop& top, const HeavyTopProblem& p,
                          const RotationState& state) {
    const Eigen::Vector3d up = state.space_from_body.conjugate() * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d moments(p.moment_transverse_kg_m2, p.moment_transverse_kg_m2,
                                  p.moment_axial_kg_m2);
    const Eigen::Vector3d momentum = moments.cwiseProduct(state.omega_body);
    const double kinetic = 0.5 * momentum.dot(state.omega_body);
    const double energy_scale = kinetic + std::abs(p.mgl_N_m);
    const double norm =
        momentum.norm() + std::sqrt(p.moment_transverse_kg_m2) * std::sqrt(std::abs(p.mgl_N_m));
    return std::max(
        {std::abs(momentum.dot(up) - top.invariants().p_phi_kg_m2_s) / norm,
         std::abs(momentum[2] - top.invariants().p_psi_kg_m2_s) / norm,
         std::abs(kinetic + p.mgl_N_m * up[2] - top.invariants().energy_J) / energy_scale,
         std::abs(state.space_from_body.norm() - 1.0)});
}

// ---------------------------------------------------------------------------------------------

class HeavyTopReference : public testing::Test {
 protected:
    static Wide number(const Json& json) { return reference::long_number(json); }
    template <std::size_t n>
    static std::array<Wide, n> numbers(const Json& json) {
        std::array<Wide, n> result{};
        for (std::size_t i = 0; i < n; ++i) result.at(i) = number(json.at(i));
        return result;
    }

    template <typename Check>
    static void for_each_sample(Check check) {
        const Json file = reference::read_reference("heavy_top.json");
        int n_samples = 0;
        for (const Json& c : file["cases"]) {
            const HeavyTopProblem problem{.moment_transverse_kg_m2 = reference::number(c["A"]),
                                          .moment_axial_kg_m2 = reference::number(c["C"]),
                                          .mgl_N_m = reference::number(c["Mgl"]),
                                          .theta_rad = reference::number(c["theta0"]),
                                          .theta_dot_rad_s = reference::number(c["thetadot0"]),
                                          .phi_dot_rad_s = reference::number(c["phidot0"]),
                                          .omega3_rad_s = reference::number(c["omega3"])};
            for (const Json& sample : c["samples"]) {
                SCOPED_TRACE(c["name"].get<std::string>() +
                             ", t = " + sample["t"].get<std::string>());
                check(problem, sample);
                ++n_samples;
            }
        }
        EXPECT_EQ(n_samples, 55);
    }
};

TEST_F(HeavyTopReference, AgreesInAttitudeAndAngularVelocity) {
    for_each_sample([](const HeavyTopProblem& problem, const Json& sample) {
        const HeavyTop top(problem);
        const RotationState state = top.at(reference::number(sample["t"]));
        const Difference d =
            difference(problem, state, numbers<4>(sample["q"]), numbers<3>(sample["omega"]));
        EXPECT_LE(d.attitude, 1e-15);  // measured 1.4e-16
        EXPECT_LE(d.omega, 1e-15);
    });
}

TEST_F(HeavyTopReference, AgreesInEulerAngles) {
    for_each_sample([](const HeavyTopProblem& problem, const Json& sample) {
        const HeavyTop top(problem);
        const EulerAngles angles = top.euler_angles(reference::number(sample["t"]));
        // Half an ulp of the angle is the smallest error of a double: ψ reaches 609 rad.
        const auto within = [](double angle, Wide reference) {
            return static_cast<double>(std::abs(angle - reference) /
                                       std::max(Wide(1), std::abs(reference)));
        };
        EXPECT_LE(within(angles.theta_rad, number(sample["theta"])), 1e-15);  // measured 3e-16
        EXPECT_LE(within(angles.phi_rad, number(sample["phi"])), 1e-15);      // measured 3e-16
        EXPECT_LE(within(angles.psi_rad, number(sample["psi"])), 1e-15);      // measured 4e-16
    });
}

TEST_F(HeavyTopReference, AgreesWhenStartedFromRoundedStates) {
    // A scene gives a RotationState, whose quaternion and ω are rounded.
    for_each_sample([](const HeavyTopProblem& p, const Json& sample) {
        const InertiaTensor inertia = InertiaTensor::from_principal_moments(
            {p.moment_transverse_kg_m2, p.moment_transverse_kg_m2, p.moment_axial_kg_m2});
        const HeavyTop top(inertia, Gravity{.mgl_N_m = p.mgl_N_m}, start_of(p));
        const MotionSample s = top.sample(reference::number(sample["t"]), {.euler_angles = true});
        const Difference d =
            difference(p, s.state, numbers<4>(sample["q"]), numbers<3>(sample["omega"]));
        EXPECT_LE(d.attitude, 1e-13);
        EXPECT_LE(d.omega, 1e-13);
        EXPECT_LE(std::abs(s.euler.theta_rad - number(sample["theta"])), 1e-13);
        EXPECT_LE(std::abs(s.euler.phi_rad - number(sample["phi"])), 1e-13);
        EXPECT_LE(std::abs(s.euler.psi_rad - number(sample["psi"])), 1e-13);
    });
}

class HeavyTopFamily : public testing::TestWithParam<tops::Family> {};

TEST_P(HeavyTopFamily, AgreesWithTaylor) {
    const tops::Residuals worst = tops::measure(GetParam(), 0, GetParam().of_any_scale ? 50 : 100);
    // Measured 5.0e-16 and 1.0e-15 over 2,000 tops of all families: see accuracy_table.
    EXPECT_LE(worst.attitude, tops::bounds.attitude);
    EXPECT_LE(worst.omega, tops::bounds.omega);
}

std::string test_name(const testing::TestParamInfo<tops::Family>& info) {
    std::string name;
    for (const char c : info.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            name += c;
        } else if (name.back() != '_') {
            name += '_';
        }
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Extremes, HeavyTopFamily,
                         testing::ValuesIn(tops::all().begin(), tops::all().end()), test_name);

// DoubleDouble is sufficient for the oracle: 113 bits agree where the motion amplifies most.
TEST(HeavyTopOracle, DoubleDoubleAgreesWith113Bits) {
    for (const tops::Family& family : tops::all()) {
        if (!family.amplifies) continue;
        for (const unsigned seed : {1U, 2U}) {
            SCOPED_TRACE(family.name);
            tops::Random random(seed);
            const HeavyTopProblem problem = family.draw(random);
            TaylorTop<DoubleDouble> pairs(problem);
            TaylorTop<Quad> quad(problem);
            const int exponent = family.of_any_scale ? TaylorTop<Quad>::exponent_of(problem) : 0;
            const double duration_s = std::ldexp(family.duration_s, -exponent);
            pairs.advance(duration_s);
            quad.advance(duration_s);
            // Both round to the same long doubles or to neighbours: an ulp below 1 is 5.4e-20.
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_LE(std::abs(pairs.quaternion()[i] - quad.quaternion()[i]), 6e-20L);
            }
        }
    }
}

// The rounded value of φ̇ sin θ that start_of gives lies within an ulp of the exact one.
void expect_start(const HeavyTopProblem& p, const Eigen::Vector3d& omega) {
    EXPECT_EQ(omega[0], p.theta_dot_rad_s);
    EXPECT_EQ(omega[2], p.omega3_rad_s);
    const Quad exact = Quad(p.phi_dot_rad_s) * sin(Quad(p.theta_rad));
    const Quad off = abs(omega[1] - exact);
    EXPECT_LE(off, ldexp(abs(exact), -52) + std::numeric_limits<double>::denorm_min());
}

TEST(HeavyTop, StartsWithExactlyWhatItWasGiven) {
    for (const tops::Family& family : tops::all()) {
        for (unsigned seed = 1; seed <= 500; ++seed) {
            SCOPED_TRACE(std::string(family.name) + ", " + std::to_string(seed));
            tops::Random random(seed);
            const HeavyTopProblem p = family.draw(random);
            const HeavyTop top(p);
            const MotionSample sample = top.sample(0.0, {.herpolhode = true, .euler_angles = true});
            expect_start(p, top.at(0.0).omega_body);
            expect_start(p, sample.state.omega_body);
            for (const EulerAngles& angles : {top.euler_angles(0.0), sample.euler}) {
                ASSERT_EQ(angles.theta_rad, p.theta_rad);
                ASSERT_EQ(angles.phi_rad, 0.0);
                ASSERT_EQ(angles.psi_rad, 0.0);
            }
            // The same body and state, turned, with the arm along any axis, from another instant.
            const double A = p.moment_transverse_kg_m2;
            const double C = p.moment_axial_kg_m2;
            RotationState start;
            start.time_s = 0.7;
            start.space_from_body = Eigen::Quaterniond(0.1, -0.7, 0.5, 0.5);
            start.omega_body = {p.theta_dot_rad_s, p.omega3_rad_s, -p.phi_dot_rad_s};
            const Gravity gravity{.mgl_N_m = p.mgl_N_m, .arm_body = {0.0, -1.0, 0.0}};
            const auto inertia =
                InertiaTensor::from_principal_moments({A, C, A}, Physicality::waived);
            const HeavyTop turned(inertia, gravity, start);
            ASSERT_EQ(turned.at(0.7).omega_body, start.omega_body);
            ASSERT_EQ(turned.at(0.7).space_from_body.coeffs(), start.space_from_body.coeffs());
        }
    }
}

TEST(HeavyTop, RefusesWhatLiesBeyondTheRangeOfDouble) {
    using P = HeavyTopProblem;
    const auto refusal = [&](auto change) {
        P p{.moment_transverse_kg_m2 = 1.9,
            .moment_axial_kg_m2 = 0.339,
            .mgl_N_m = 1.0,
            .theta_rad = 0.5};
        change(p);
        return refusal_message([&] { HeavyTop{p}; });
    };
    const std::string overflows = ": the angular momentum of the top overflows; choose other units";
    EXPECT_EQ(refusal([](P& p) { p.omega3_rad_s = 1e308, p.moment_axial_kg_m2 = 2.0; }),
              "omega3_rad_s" + overflows);
    EXPECT_EQ(refusal([](P& p) { p.theta_dot_rad_s = 1e308; }), "theta_dot_rad_s" + overflows);
    EXPECT_EQ(refusal([](P& p) { p.phi_dot_rad_s = 1.7e308, p.theta_rad = 1.5; }),
              "phi_dot_rad_s" + overflows);
    for (const double theta : {-1e-300, 3.1416, 1e16, 1e150, 1e308}) {
        EXPECT_NE(refusal([=](P& p) { p.theta_rad = theta; }).find("give an angle from 0 to 3.14"),
                  std::string::npos);
        EXPECT_NE(refusal_message([=] { start_of(P{.theta_rad = theta}); }), "");
    }
    EXPECT_EQ(refusal([](P& p) { p.theta_rad = pi; }), "");
}

// Up to the rate at which L overflows, every number is finite, at the start and later.
TEST(HeavyTop, IsFiniteUpToTheOverflowOfItsMomentum) {
    for (const double omega3 : {1e153, 1e154, 1e155, 1e290, 1e300, 1e308}) {
        const HeavyTop top({.moment_transverse_kg_m2 = 1.9,
                            .moment_axial_kg_m2 = 0.339,
                            .mgl_N_m = 1.0,
                            .theta_rad = 0.5,
                            .phi_dot_rad_s = 0.3 * omega3,
                            .omega3_rad_s = omega3});
        for (const double turns : {0.0, 1.0, -3.0, 1e10}) {
            SCOPED_TRACE(omega3);
            const MotionSample s =
                top.sample(turns / omega3, {.herpolhode = true, .euler_angles = true});
            EXPECT_TRUE(s.state.omega_body.allFinite());
            EXPECT_TRUE(s.state.space_from_body.coeffs().allFinite());
            EXPECT_TRUE(s.herpolhode_space.allFinite());
            // ω's part across L = (A ω1, A ω2, C ω3), by the angle between them.
            const Eigen::Vector3d omega = s.state.omega_body / omega3;
            const Eigen::Vector3d momentum(1.9 * omega[0], 1.9 * omega[1], 0.339 * omega[2]);
            EXPECT_NEAR(s.herpolhode_space.stableNorm() / omega3,
                        omega.cross(momentum.normalized()).norm(), 1e-14);
            EXPECT_TRUE(std::isfinite(s.euler.phi_rad));
        }
    }
}

TEST(HeavyTop, ConservesItsInvariantsAtAllTimes) {
    std::mt19937_64 random(9);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
        const HeavyTopProblem p = generic_top(random);
        const HeavyTop top(p);
        for (const double t : {0.0, 1.0, -3.0, 1e6, -1e9, 1e12, 1e15}) {
            worst = std::max(worst, invariant_residual(top, p, top.at(t)));
        }
    }
    EXPECT_LE(worst, 4e-15);  // measured 8.6e-16
}

TEST(HeavyTop, IsFiniteAndConservesAtExtremeScales) {
    std::mt19937_64 random(10);
    double worst = 0.0;
    for (int i = 0; i < 1500; ++i) {
        const auto wild = [&] {
            return std::pow(10.0, uniform(random, -60.0, 60.0)) * (random() % 2 == 0 ? 1.0 : -1.0);
        };
        HeavyTopProblem p;
        p.moment_transverse_kg_m2 = std::abs(wild());
        p.moment_axial_kg_m2 = p.moment_transverse_kg_m2 * std::pow(10.0, uniform(random, -12, 0));
        p.mgl_N_m = wild();
        p.theta_rad = std::min(pi, std::pow(10.0, uniform(random, -150.0, 1.0)));
        p.theta_dot_rad_s = random() % 3 == 0 ? 0.0 : wild();
        p.phi_dot_rad_s = random() % 3 == 0 ? 0.0 : wild();
        p.omega3_rad_s = random() % 3 == 0 ? 0.0 : wild();
        const HeavyTop top(p);
        const double period = top.nutation().period_s;
        EXPECT_FALSE(std::isnan(period));
        for (const double k : {0.0, 0.3, -1.7, 1e3, 1e22, -1e160}) {
            const double t = k * (std::isfinite(period) ? period : 1.0);
            const RotationState state = top.at(t);
            ASSERT_TRUE(state.space_from_body.coeffs().allFinite()) << i;
            ASSERT_TRUE(state.omega_body.allFinite()) << i;
            ASSERT_FALSE(std::isnan(top.euler_angles(t).phi_rad)) << i;
            worst = std::max(worst, invariant_residual(top, p, state));
        }
    }
    EXPECT_LE(worst, 5e-15);  // measured 1.1e-15
}

// Where the phase has no accurate digit, the result is still a state of the motion: here of a
// pendulum that stays near the vertical for 130 units of phase, at instants 10^100 periods away.
TEST(HeavyTop, ConservesWherePhaseHasNoDigits) {
    HeavyTopProblem p;
    p.moment_transverse_kg_m2 = 2e-19;
    p.moment_axial_kg_m2 = 1e-23;
    p.mgl_N_m = 2e44;
    p.theta_rad = 3e-57;
    const HeavyTop top(p);
    const double period = top.nutation().period_s;
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double t = 1e100 * (1.0 + 3.7e-5 * i) * period;
        worst = std::max(worst, invariant_residual(top, p, top.at(t)));
    }
    EXPECT_LE(worst, 5e-15);
}

// The nutation's period and the precession over it, by the trapezoidal rule in 50 digits: the
// integrands are periodic and analytic, so the rule converges geometrically.
struct Quadrature {
    using Real = boost::multiprecision::cpp_bin_float_50;
    Real period;
    Real precession;
    Real rotation;  // ψ's advance

    explicit Quadrature(const HeavyTopProblem& p) {
        const Real A = p.moment_transverse_kg_m2;
        const Real beta = 2 * Real(p.mgl_N_m) / A;
        const Real a = Real(p.moment_axial_kg_m2) * p.omega3_rad_s / A;
        const Real x0 = 1 - cos(Real(p.theta_rad));
        const Real across = Real(p.phi_dot_rad_s) * x0 * (2 - x0);
        const Real d = across - a * x0;
        const Real gamma = square(Real(p.theta_dot_rad_s)) +
                           square(Real(p.phi_dot_rad_s)) * x0 * (2 - x0) - beta * x0;
        const auto cubic = [&](const Real& x) {
            return Real(x * (2 - x) * (gamma + beta * x) - square(Real(d + a * x)));
        };
        const Real low = bisect(cubic, 0, x0);
        const Real high = bisect(cubic, 2, x0);
        // cubic = (high − x)(x − low)(β x + G).
        const Real G =
            gamma * 2 == 0 ? Real(0) : Real(beta * (high + low) - (2 * beta - gamma - a * a));
        constexpr int n_points = 4000;
        const Real pi_50 = boost::math::constants::pi<Real>();
        for (int i = 0; i < n_points; ++i) {
            const Real angle = pi_50 * (2 * i + 1) / n_points;
            const Real x = (high + low) / 2 + (high - low) / 2 * cos(angle);
            const Real weight = 2 * pi_50 / (n_points * sqrt(Real(beta * x + G)));
            period += weight;
            const Real phi_dot = (d + a * x) / (x * (2 - x));
            precession += weight * phi_dot;
            rotation += weight * (p.omega3_rad_s - phi_dot * (1 - x));
        }
    }

 private:
    static Real square(const Real& x) { return x * x; }
    template <typename Function>
    static Real bisect(const Function& f, Real negative, Real positive) {
        for (int i = 0; i < 180; ++i) {
            const Real middle = (negative + positive) / 2;
            (f(middle) < 0 ? negative : positive) = middle;
        }
        return positive;
    }
};

TEST(HeavyTop, IsAsAccurateAfterABillionPeriodsAsInTheFirst) {
    std::mt19937_64 random(11);
    double worst_theta = 0.0;
    double worst_phi = 0.0;
    double worst_omega = 0.0;
    for (int i = 0; i < 20; ++i) {
        HeavyTopProblem p = generic_top(random);
        p.mgl_N_m = std::abs(p.mgl_N_m);
        p.theta_rad = uniform(random, 0.3, 2.8);
        const HeavyTop top(p);
        const Quadrature exact(p);
        EXPECT_NEAR(top.nutation().period_s / static_cast<double>(exact.period), 1.0, 3e-16);
        // t is a double; the equivalent instant of the first period is computed in 50 digits.
        const double t = 1e9 * top.nutation().period_s;
        const Quadrature::Real n = floor(Quadrature::Real(t) / exact.period);
        const auto early = static_cast<double>(t - n * exact.period);
        const EulerAngles first = top.euler_angles(early);
        const EulerAngles far = top.euler_angles(t);
        const auto phi = static_cast<double>(first.phi_rad + n * exact.precession);
        // ω is that of the first period, turned back by ψ's advance.
        const Quadrature::Real rest = t - n * exact.period - early;
        TaylorTop<DoubleDouble> oracle(p);
        oracle.advance(early);
        oracle.advance(static_cast<double>(rest));
        const auto [omega1, omega2, omega3] = oracle.omega();
        const auto turn = static_cast<Wide>(
            fmod(n * exact.rotation, 2 * boost::math::constants::pi<Quadrature::Real>()));
        const std::array<Wide, 3> expected{omega1 * std::cos(turn) + omega2 * std::sin(turn),
                                           omega2 * std::cos(turn) - omega1 * std::sin(turn),
                                           omega3};
        const RotationState state = top.at(t);
        worst_omega = std::max(worst_omega, difference(p, state, {1, 0, 0, 0}, expected).omega);
        worst_theta = std::max(worst_theta, std::abs(far.theta_rad - first.theta_rad));
        worst_phi = std::max(worst_phi, std::abs(far.phi_rad / phi - 1.0));
    }
    EXPECT_LE(worst_theta, 4e-15);  // measured 3.3e-16
    EXPECT_LE(worst_phi, 4e-16);    // measured 0
    EXPECT_LE(worst_omega, tops::bounds.omega);
}

TEST(HeavyTop, GrowsFromTheVerticalAsTheLinearSolutionDoes) {
    // Unstable: with φ̇0 = a/2 the axis leaves as θ0 cosh κt in axes turning at a/2.
    for (const double theta : {1e-300, 1e-160, 1e-100, 1e-30}) {
        const HeavyTop top({.moment_axial_kg_m2 = 0.5,
                            .mgl_N_m = 1.0,
                            .theta_rad = theta,
                            .phi_dot_rad_s = 0.5,
                            .omega3_rad_s = 2.0});
        const double kappa = std::sqrt(1.0 - 0.25);
        for (const double t : {0.0, 1.0, -7.0, 20.0}) {
            const EulerAngles angles = top.euler_angles(t);
            // κt is rounded and then exponentiated: some 20 ulp at t = 20.
            EXPECT_NEAR(angles.theta_rad / (theta * std::cosh(kappa * t)), 1.0, 1e-14) << theta;
            EXPECT_NEAR(angles.phi_rad, 0.5 * t, 1e-14) << theta;
        }
        EXPECT_EQ(top.regime(), TopRegime::wavy);
    }
}

TEST(HeavyTop, FollowsThePendulumsSeparatrix) {
    // From the lowest position at twice the small-swing frequency: θ = 4 atan e^{−|t|}.
    const InertiaTensor inertia = InertiaTensor::from_principal_moments({1.0, 1.0, 0.5});
    RotationState start;
    start.space_from_body = Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
    start.omega_body = {2.0, 0.0, 0.0};
    const HeavyTop top(inertia, Gravity{.mgl_N_m = 1.0}, start);
    EXPECT_EQ(top.regime(), TopRegime::separatrix);
    EXPECT_EQ(top.nutation().period_s, infinity);
    for (const double t : {0.0, 1e-9, 0.3, -2.0, 30.0, 300.0, -700.0}) {
        const double theta = 4.0 * std::atan(std::exp(-std::abs(t)));
        EXPECT_NEAR(top.euler_angles(t).theta_rad / theta, 1.0, 1e-15 + 3e-16 * std::abs(t)) << t;
    }
    EXPECT_EQ(top.euler_angles(1e6).theta_rad, 0.0);
}

TEST(HeavyTop, UsesUnroundedStartAnglesIfGiven) {
    // Near the separatrix one ulp of the start changes the next swing by far more than 1e-13.
    const TopStart given{.theta_rad = 2.0, .theta_dot_rad_s = -2.0 * std::sin(1.0) + 1e-9};
    const HeavyTopProblem angles{.moment_axial_kg_m2 = 0.5,
                                 .mgl_N_m = 1.0,
                                 .theta_rad = given.theta_rad,
                                 .theta_dot_rad_s = given.theta_dot_rad_s};
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments({1.0, 1.0, 0.5});
    problem.torque = Gravity{.mgl_N_m = 1.0};
    problem.start = start_of(angles);
    problem.top_start = given;
    const HeavyTop exact(angles);
    const Motion motion(problem);
    EXPECT_EQ(motion.at(60.0).omega_body, exact.at(60.0).omega_body);
    TaylorTop<Quad> oracle(angles);
    oracle.advance(60.0);
    const Difference d = difference(angles, motion.at(60.0), oracle.quaternion(), oracle.omega());
    EXPECT_LE(d.attitude, 2e-15);
    EXPECT_LE(d.omega, 2e-15);
    problem.top_start.reset();
    EXPECT_GT((Motion(problem).at(60.0).omega_body - exact.at(60.0).omega_body).norm(), 1e-12);
}

TEST(HeavyTop, PassesThroughTheVerticalWithAContinuousQuaternion) {
    const HeavyTop top({.moment_axial_kg_m2 = 0.5,
                        .mgl_N_m = 1.0,
                        .theta_rad = 0.0,
                        .theta_dot_rad_s = 0.6,
                        .omega3_rad_s = 3.0});
    EXPECT_EQ(top.regime(), TopRegime::through_vertical);
    const double step = 1e-3;
    for (int k = -20000; k < 20000; ++k) {
        const RotationState now = top.at(k * step);
        const RotationState next = top.at((k + 1) * step);
        const double turned =
            (now.space_from_body.coeffs() - next.space_from_body.coeffs()).norm() * 2.0;
        ASSERT_LE(turned, 1.01 * step * now.omega_body.norm()) << k;
    }
}

TEST(HeavyTop, WithoutGravityIsTheFreeSymmetricBody) {
    // R(t) = exp(t L/A) R(0) exp(t (1 − C/A) ω3 e3).
    std::mt19937_64 random(12);
    for (int i = 0; i < 50; ++i) {
        HeavyTopProblem p = generic_top(random);
        p.mgl_N_m = 0.0;
        const HeavyTop top(p);
        const RotationState start = start_of(p);
        const double A = p.moment_transverse_kg_m2;
        const double C = p.moment_axial_kg_m2;
        const Eigen::Vector3d rate =
            start.space_from_body *
            Eigen::Vector3d(start.omega_body[0], start.omega_body[1], C / A * p.omega3_rad_s);
        for (const double t : {0.4, -1.3, 10.0}) {
            const Eigen::Quaterniond expected =
                Eigen::AngleAxisd(t * rate.norm(), rate.normalized()) * start.space_from_body *
                Eigen::AngleAxisd(t * (1.0 - C / A) * p.omega3_rad_s, Eigen::Vector3d::UnitZ());
            // The expected phase t·rate is itself rounded to 1e-14 at t = 10.
            EXPECT_LE(top.at(t).space_from_body.angularDistance(expected), 5e-14);
        }
        EXPECT_EQ(top.regime(), TopRegime::no_gravity);
    }
}

TEST(HeavyTop, PrecessesSteadilyAtTheRootsOfItsQuadratic) {
    // cos θ φ̇² − a φ̇ + Mgl/A = 0, on both sides of the horizontal.
    for (const double theta : {0.4, 1.2, 1.9, 2.8}) {
        for (const double sign : {-1.0, 1.0}) {
            HeavyTopProblem p = lecture_top();
            p.theta_rad = theta;
            const double a = 4.0;
            const double cosine = std::cos(theta);
            const double root = std::sqrt(a * a - 4.0 * cosine);
            const double small = 2.0 / (a + root);
            const double large = (a + root) / (2.0 * cosine);
            p.phi_dot_rad_s = sign < 0 ? small : large;
            const HeavyTop top(p);
            EXPECT_EQ(top.regime(), sign < 0 ? TopRegime::steady_slow : TopRegime::steady_fast);
            EXPECT_NEAR(top.nutation().precession_rate_rad_s / p.phi_dot_rad_s, 1.0, 1e-15);
            EXPECT_NEAR(top.euler_angles(100.0).theta_rad, theta, 1e-14);
        }
    }
}

TEST(HeavyTop, TurnsWhereTheEffectivePotentialIsTheEnergy) {
    std::mt19937_64 random(13);
    for (int i = 0; i < 100; ++i) {
        const HeavyTopProblem p = generic_top(random);
        const HeavyTop top(p);
        const TopNutation& n = top.nutation();
        const double energy = top.invariants().energy_J;
        const double scale = std::abs(energy) + std::abs(p.mgl_N_m);
        const auto at_end = [&](double theta) {
            // V is steep near a vertical: an ulp of θ moves it by V'(θ) ε.
            const double slope = (top.effective_potential_J(theta * (1 + 1e-9)) -
                                  top.effective_potential_J(theta * (1 - 1e-9))) /
                                 2e-9;
            EXPECT_NEAR(top.effective_potential_J(theta), energy,
                        1e-14 * scale + 1e-15 * std::abs(slope));
        };
        at_end(n.theta_min_rad);
        at_end(n.theta_max_rad);
        for (const double t : {0.3, 1.7, 40.0}) {
            const double theta = top.euler_angles(t).theta_rad;
            EXPECT_LE(top.effective_potential_J(theta), energy + 1e-12 * scale);
            EXPECT_GE(theta, n.theta_min_rad * (1 - 1e-15));
            EXPECT_LE(theta, n.theta_max_rad * (1 + 1e-15));
        }
    }
}

TEST(HeavyTop, NamesItsRegimes) {
    const auto regime = [](auto change) {
        HeavyTopProblem p = lecture_top();
        change(p);
        return HeavyTop(p).regime();
    };
    using P = HeavyTopProblem;
    EXPECT_EQ(regime([](P&) {}), TopRegime::cusp);
    EXPECT_EQ(regime([](P& p) { p.phi_dot_rad_s = 0.35; }), TopRegime::wavy);
    EXPECT_EQ(regime([](P& p) { p.phi_dot_rad_s = -0.2; }), TopRegime::looping);
    EXPECT_EQ(regime([](P& p) { p.theta_rad = 0.0; }), TopRegime::sleeping);
    EXPECT_EQ(regime([](P& p) { p.theta_rad = 0.0, p.omega3_rad_s = 4.0; }), TopRegime::sleeping);
    EXPECT_EQ(regime([](P& p) { p.theta_rad = 0.0, p.omega3_rad_s = 3.9; }),
              TopRegime::sleeping_unstable);
    EXPECT_EQ(regime([](P& p) { p.theta_rad = 0.0, p.mgl_N_m = -1.0; }), TopRegime::hanging);
    EXPECT_EQ(regime([](P& p) { p.omega3_rad_s = 0.0; }), TopRegime::planar_pendulum);
    EXPECT_EQ(regime([](P& p) { p.mgl_N_m = 0.0; }), TopRegime::no_gravity);
    std::set<std::string_view> names;
    for (int i = 0; i <= static_cast<int>(TopRegime::no_gravity); ++i) {
        names.insert(name_of(static_cast<TopRegime>(i)));
    }
    EXPECT_EQ(names.size(), 12U);
}

TEST(HeavyTop, AcceptsAnySymmetryAxisOfTheBody) {
    // The lecture's top with its axis along e1, e2 or −e3, and rotated for three equal moments.
    const HeavyTopProblem p = lecture_top();
    const RotationState start = start_of(p);
    const HeavyTop plain(p);
    const Eigen::Quaterniond to_first(0.5, 0.5, 0.5, 0.5);  // e3 → e1
    const auto compare = [&](const Eigen::Vector3d& moments, const Gravity& gravity,
                             const Eigen::Quaterniond& body_from_top, const HeavyTop& expected,
                             const RotationState& from) {
        RotationState turned = from;
        turned.space_from_body = from.space_from_body * body_from_top.conjugate();
        turned.omega_body = body_from_top * from.omega_body;
        const HeavyTop top(InertiaTensor::from_principal_moments(moments), gravity, turned);
        for (const double t : {0.0, 0.7, 5.0}) {
            const RotationState state = top.at(t);
            const RotationState wanted = expected.at(t);
            EXPECT_LE((state.omega_body - body_from_top * wanted.omega_body).norm(), 1e-13);
            EXPECT_LE(state.space_from_body.angularDistance(wanted.space_from_body *
                                                            body_from_top.conjugate()),
                      1e-13);
        }
    };
    compare({0.5, 1, 1}, {.mgl_N_m = 1, .arm_body = {1, 0, 0}}, to_first, plain, start);
    compare({1, 0.5, 1}, {.mgl_N_m = 1, .arm_body = {0, 1, 0}}, to_first.conjugate(), plain, start);
    compare({1, 1, 0.5}, {.mgl_N_m = -1, .arm_body = {0, 0, -1}}, Eigen::Quaterniond::Identity(),
            plain, start);
    const HeavyTopProblem sphere{.mgl_N_m = 1.0, .theta_rad = 0.7, .omega3_rad_s = 5.0};
    const Eigen::Vector3d arm = Eigen::Vector3d(1, -2, 0.5).normalized();
    compare({1, 1, 1}, {.mgl_N_m = 1, .arm_body = arm}, least_turn(Eigen::Vector3d::UnitZ(), arm),
            HeavyTop(sphere), start_of(sphere));
}

TEST(HeavyTop, RefusesProblemsWithoutAnExactSolution) {
    const InertiaTensor asymmetric = InertiaTensor::from_principal_moments({1.0, 2.0, 2.5});
    const InertiaTensor symmetric = InertiaTensor::from_principal_moments({1.0, 1.0, 0.5});
    const Gravity upright{.mgl_N_m = 1.0};
    const Gravity oblique{.mgl_N_m = 1.0, .arm_body = {0.6, 0.0, 0.8}};
    EXPECT_FALSE(HeavyTop::accepts(asymmetric, upright));
    EXPECT_FALSE(HeavyTop::accepts(symmetric, oblique));
    EXPECT_TRUE(HeavyTop::accepts(symmetric, upright));
    EXPECT_THROW(HeavyTop(asymmetric, upright, {}), InputError);
    EXPECT_THROW(HeavyTop(symmetric, oblique, {}), InputError);
    HeavyTopProblem p = lecture_top();
    p.moment_axial_kg_m2 = 0.0;
    EXPECT_THROW(HeavyTop{p}, InputError);
    p = lecture_top();
    p.theta_rad = std::nan("");
    EXPECT_THROW(HeavyTop{p}, InputError);
    p.theta_rad = infinity;
    EXPECT_THROW(HeavyTop{p}, InputError);
    for (const double t : {1e300, infinity, -infinity, std::nan("")}) {
        EXPECT_THROW(HeavyTop(lecture_top()).at(t), InputError);
        p = lecture_top();
        p.theta_rad = 0.0;
        EXPECT_THROW(HeavyTop{p}.at(t), InputError);
    }
}

}  // namespace
}  // namespace poinsot::heavy_top_tests
