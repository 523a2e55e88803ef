// Jacobi's solution compared with reference motions, computed to 40 digits by Taylor series, and
// with the laws of every torque-free motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>

#include "mechanics/families.h"
#include "mechanics/motion.h"
#include "mechanics/reference_cases.h"

namespace poinsot::free_rotation_tests {
namespace {

using reference::Json;
using Triple = std::array<long double, 3>;

Triple triple_of(const Json& json, std::size_t first = 0) {
    Triple x{};
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = reference::long_number(json.at(first + i));
    }
    return x;
}

long double norm(const Triple& x) { return std::hypot(x[0], x[1], x[2]); }

// |x − reference|, in long double, so that the difference itself is not rounded to double.
long double distance(const Eigen::Vector3d& x, const Triple& reference) {
    return std::hypot(x[0] - reference[0], x[1] - reference[1], x[2] - reference[2]);
}

// Angle between an attitude and q = (w, x, y, z), for small angles.
long double reference_angle(const Eigen::Quaterniond& attitude, const Json& q) {
    const Triple vector = triple_of(q, 1);
    const long double w = reference::long_number(q.at(0));
    const auto difference = [&](long double sign) {
        return std::hypot(attitude.w() - sign * w, std::hypot(attitude.x() - sign * vector[0],
                                                              attitude.y() - sign * vector[1],
                                                              attitude.z() - sign * vector[2]));
    };
    return 2.0L * std::min(difference(1.0L), difference(-1.0L));
}

Motion reference_motion(const Json& c) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(
        {reference::number(c["I1"]), reference::number(c["I2"]), reference::number(c["I3"])},
        Physicality::waived);
    const Json& omega = c["omega0"];
    problem.start.omega_body = {reference::number(omega[0]), reference::number(omega[1]),
                                reference::number(omega[2])};
    return Motion(problem);
}

TEST(FreeRotation, AgreesWithReferenceCases) {
    const Json file = reference::read_reference("torque_free.json");
    ASSERT_EQ(file["cases"].size(), 34U);
    for (const Json& c : file["cases"]) {
        const Motion motion = reference_motion(c);
        // A subnormal component of ω has fewer digits.
        const bool subnormal = c["name"].get<std::string>() == "denormal_component";
        for (const Json& sample : c["samples"]) {
            const std::string where =
                c["name"].get<std::string>() + " t = " + sample["t"].get<std::string>();
            const MotionSample now =
                motion.sample(reference::number(sample["t"]),
                              {.attitude = true, .herpolhode = true, .euler_angles = false});
            const Triple omega = triple_of(sample["omega"]);
            const long double omega_error = distance(now.state.omega_body, omega);
            EXPECT_LE(omega_error, 2e-15L * norm(omega)) << where;  // measured 4.7e-16
            const long double attitude_error =
                reference_angle(now.state.space_from_body, sample["q"]);
            EXPECT_LE(attitude_error, 2e-15L) << where;  // measured 6.5e-16
            const Triple h = triple_of(sample["herpolhode"]);
            const long double h_error = distance(now.herpolhode_space, h);
            // measured 9.2e-16
            EXPECT_LE(h_error, subnormal ? 1e-298L : 3e-15L * norm(h)) << where;
        }
    }
}

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr Quantities everything{.attitude = true, .herpolhode = true, .euler_angles = false};

FreeRotation free_rotation(const Vector3d& moments, const Vector3d& omega) {
    RotationState start;
    start.omega_body = omega;
    return {InertiaTensor::from_principal_moments(moments), start};
}

double angle(const Quaterniond& a, const Quaterniond& b) {
    return 2.0 * std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

struct Named {
    Regime regime;
    Vector3d moments;
    Vector3d omega;
};

// One motion of every regime.
const std::array<Named, 6> regimes{{
    {Regime::permanent, {1.0, 2.0, 2.5}, {0.0, 0.0, 1.5}},
    {Regime::symmetric, {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
    {Regime::elliptic_about_highest, {1.0, 2.0, 2.5}, {0.1, 0.2, 1.0}},
    {Regime::elliptic_about_lowest, {1.0, 2.0, 2.5}, {1.0, 0.2, 0.1}},
    {Regime::elliptic_about_highest, {1.0, 2.0, 2.5}, {0.3, 2.0, 0.4}},
    {Regime::separatrix, {1.0, 2.0, 2.25}, {0.75, 0.5, 1.0}},
}};

TEST(FreeRotation, ChoosesTheRegimeAtConstruction) {
    for (const Named& c : regimes) {
        EXPECT_EQ(free_rotation(c.moments, c.omega).regime(), c.regime) << name_of(c.regime);
    }
    EXPECT_EQ(free_rotation({1.0, 2.0, 2.5}, Vector3d::Zero()).regime(), Regime::at_rest);
    EXPECT_EQ(free_rotation({2.0, 2.0, 2.0}, {1.0, 2.0, 3.0}).regime(), Regime::permanent);
}

TEST(FreeRotation, StartsInTheGivenState) {
    const Quaterniond attitude = Quaterniond(0.3, -0.5, 0.7, 0.1).normalized();
    for (const Named& c : regimes) {
        const FreeRotation plain = free_rotation(c.moments, c.omega);
        RotationState start;
        start.time_s = 3.25;
        start.space_from_body = attitude;
        start.omega_body = c.omega;
        const FreeRotation moved(InertiaTensor::from_principal_moments(c.moments), start);
        EXPECT_LE((moved.at(3.25).omega_body - c.omega).norm(), 1e-15 * c.omega.norm());
        EXPECT_LE(angle(moved.at(3.25).space_from_body, attitude), 1e-15);
        for (const double t : {-7.5, 0.25, 40.0}) {
            const MotionSample a = plain.sample(t, everything);
            const MotionSample b = moved.sample(t + 3.25, everything);
            // t + 3.25 is exact, so that only the evaluations' own errors remain.
            EXPECT_LE((a.state.omega_body - b.state.omega_body).norm(), 2e-15 * c.omega.norm());
            EXPECT_LE(angle(attitude * a.state.space_from_body, b.state.space_from_body), 2e-15);
            EXPECT_LE((attitude * a.herpolhode_space - b.herpolhode_space).norm(), 2e-15);
        }
    }
}

TEST(FreeRotation, AnyStateOfTheMotionStartsTheSameMotion) {
    for (const Named& c : regimes) {
        const InertiaTensor inertia = InertiaTensor::from_principal_moments(c.moments);
        const FreeRotation motion = free_rotation(c.moments, c.omega);
        const FreeRotation resumed(inertia, motion.at(2.0));
        for (const double t : {0.0, 5.0}) {
            // The start of the resumed motion has rounding errors of 1e-16, which the motion
            // amplifies.
            EXPECT_LE(angle(motion.at(t).space_from_body, resumed.at(t).space_from_body), 2e-14);
        }
    }
}

TEST(FreeRotation, BodyAxesNeedNotBePrincipal) {
    const Matrix3d axes = Eigen::AngleAxisd(0.6, Vector3d(1.0, 2.0, -2.0) / 3.0).toRotationMatrix();
    for (const Named& c : regimes) {
        const FreeRotation principal = free_rotation(c.moments, c.omega);
        RotationState start;
        start.omega_body = axes * c.omega;
        const FreeRotation turned(InertiaTensor::from_principal_axes(c.moments, axes), start);
        for (const double t : {0.0, 1.0, 8.0}) {
            const MotionSample a = principal.sample(t, everything);
            const MotionSample b = turned.sample(t, everything);
            EXPECT_LE((axes * a.state.omega_body - b.state.omega_body).norm(), 1e-13);
            const Matrix3d expected =
                axes * a.state.space_from_body.toRotationMatrix() * axes.transpose();
            EXPECT_LE((expected - b.state.space_from_body.toRotationMatrix()).norm(), 1e-13);
            EXPECT_LE((axes * a.herpolhode_space - b.herpolhode_space).norm(), 1e-13);
        }
    }
}

TEST(FreeRotation, HerpolhodeIsOmegaPerpendicularToMomentum) {
    for (const Named& c : regimes) {
        const FreeRotation motion = free_rotation(c.moments, c.omega);
        const Vector3d L = motion.constants().momentum_space;
        for (const double t : {0.0, 0.9, 21.0}) {
            const MotionSample sample = motion.sample(t, everything);
            const Vector3d omega = sample.state.space_from_body * sample.state.omega_body;
            const Vector3d across = omega - L * (omega.dot(L) / L.squaredNorm());
            EXPECT_LE((across - sample.herpolhode_space).norm(), 4e-15);
            EXPECT_LE(std::abs(sample.herpolhode_space.dot(L)), 2e-15 * L.norm());
        }
    }
}

TEST(FreeRotation, ConstantsDescribeTheMotion) {
    for (const Named& c : regimes) {
        const FreeRotation motion = free_rotation(c.moments, c.omega);
        const FreeRotationConstants& k = motion.constants();
        const Vector3d L = c.moments.cwiseProduct(c.omega);
        EXPECT_DOUBLE_EQ(k.kinetic_energy_J, 0.5 * c.omega.dot(L));
        EXPECT_DOUBLE_EQ(k.momentum_kg_m2_s, L.norm());
        EXPECT_EQ(k.momentum_space, L);
        // The encircled axis is the one along which ω does not change sign.
        double least_radius = 1e300;
        double greatest_radius = 0.0;
        const double span = k.polhode_period_s.value_or(40.0);
        constexpr int n_samples = 8000;
        for (int i = -n_samples; i <= n_samples; ++i) {
            const MotionSample sample = motion.sample(span * i / n_samples, everything);
            if (motion.regime() != Regime::permanent) {
                EXPECT_GT(sample.state.omega_body[k.encircled_axis] * c.omega[k.encircled_axis],
                          0.0);
            }
            least_radius = std::min(least_radius, sample.herpolhode_space.norm());
            greatest_radius = std::max(greatest_radius, sample.herpolhode_space.norm());
        }
        // Between samples the radius differs by the square of the step.
        EXPECT_NEAR(least_radius, k.least_herpolhode_radius_rad_s, 1e-5);
        EXPECT_NEAR(greatest_radius, k.greatest_herpolhode_radius_rad_s, 1e-5);
    }
}

TEST(FreeRotation, PolhodeClosesAndHerpolhodeAdvancesInOnePeriod) {
    for (const Named& c : regimes) {
        const FreeRotation motion = free_rotation(c.moments, c.omega);
        const FreeRotationConstants& k = motion.constants();
        ASSERT_EQ(k.polhode_period_s.has_value(),
                  c.regime != Regime::permanent && c.regime != Regime::separatrix);
        if (!k.polhode_period_s) continue;
        const double period = *k.polhode_period_s;
        EXPECT_LE((motion.at(period).omega_body - c.omega).norm(), 1e-14);
        const Vector3d axis = k.momentum_space.normalized();
        // The herpolhode's angle about L, tracked in small steps.
        double followed = 0.0;
        Vector3d last = motion.sample(0.0, everything).herpolhode_space;
        constexpr int n_steps = 1000;
        for (int i = 1; i <= n_steps; ++i) {
            const Vector3d now = motion.sample(period * i / n_steps, everything).herpolhode_space;
            followed += std::atan2(axis.dot(last.cross(now)), last.dot(now));
            last = now;
        }
        EXPECT_NEAR(followed, *k.advance_per_period_rad, 1e-12);
        EXPECT_DOUBLE_EQ(k.mean_advance_rate_rad_s * period, *k.advance_per_period_rad);
    }
}

TEST(FreeRotation, SymmetricBodyPrecessesAsInTheTextbook) {
    // L/I₁ about L, (I₃ − I₁)ω₃/I₁ in body axes (Landau & Lifshitz, Mechanics §35, §36).
    const FreeRotation motion = free_rotation({2.0, 2.0, 3.0}, {0.5, 0.3, 1.0});
    const FreeRotationConstants& k = motion.constants();
    EXPECT_DOUBLE_EQ(k.mean_advance_rate_rad_s, k.momentum_kg_m2_s / 2.0);
    EXPECT_DOUBLE_EQ(*k.polhode_period_s, 2.0 * 3.14159265358979323846 / 0.5);
    const double turn = 0.5 * 1.7;
    const Vector3d omega = motion.at(1.7).omega_body;
    EXPECT_NEAR(omega[0], 0.5 * std::cos(turn) - 0.3 * std::sin(turn), 1e-15);
    EXPECT_NEAR(omega[1], 0.3 * std::cos(turn) + 0.5 * std::sin(turn), 1e-15);
    EXPECT_EQ(omega[2], 1.0);
}

void expect_smooth(const FreeRotation& motion, double omega_norm) {
    const double step = 1e-3;
    RotationState last = motion.at(-20.0);
    for (int i = 1; i <= 40000; ++i) {
        const RotationState now = motion.at(-20.0 + i * step);
        const double turned = angle(now.space_from_body, last.space_from_body);
        EXPECT_LE(std::abs(turned - now.omega_body.norm() * step), 1e-5 * omega_norm);
        EXPECT_LE((now.omega_body - last.omega_body).norm(), 10.0 * step);
        last = now;
    }
}

TEST(FreeRotation, IsContinuousInTime) {
    // Steps much smaller than the motion: a jump would be large against ω·step.
    for (const Named& c : regimes) {
        expect_smooth(free_rotation(c.moments, c.omega), c.omega.norm());
    }
}

TEST(FreeRotation, ComputesOnlyRequestedQuantities) {
    for (const Named& c : regimes) {
        const FreeRotation motion = free_rotation(c.moments, c.omega);
        const MotionSample full = motion.sample(3.0, everything);
        const MotionSample omega_only =
            motion.sample(3.0, {.attitude = false, .herpolhode = false, .euler_angles = false});
        EXPECT_EQ(omega_only.state.omega_body, full.state.omega_body);
        EXPECT_EQ(omega_only.state.space_from_body.coeffs(), Quaterniond::Identity().coeffs());
        EXPECT_EQ(omega_only.herpolhode_space, Vector3d::Zero());
        const MotionSample curve =
            motion.sample(3.0, {.attitude = false, .herpolhode = true, .euler_angles = false});
        EXPECT_EQ(curve.herpolhode_space, full.herpolhode_space);
        EXPECT_EQ(motion.at(3.0).space_from_body.coeffs(), full.state.space_from_body.coeffs());
    }
}

TEST(FreeRotation, EulerAnglesReproduceTheAttitude) {
    for (const Named& c : regimes) {
        const FreeRotation motion = free_rotation(c.moments, c.omega);
        for (const double t : {0.0, 0.4, 9.0}) {
            const MotionSample sample =
                motion.sample(t, {.attitude = true, .herpolhode = false, .euler_angles = true});
            const Quaterniond back = Eigen::AngleAxisd(sample.euler.phi_rad, Vector3d::UnitZ()) *
                                     Eigen::AngleAxisd(sample.euler.theta_rad, Vector3d::UnitX()) *
                                     Eigen::AngleAxisd(sample.euler.psi_rad, Vector3d::UnitZ());
            EXPECT_LE(angle(back, sample.state.space_from_body), 2e-15);
        }
    }
}

TEST(FreeRotation, ReturnsItsStartExactlyWithoutAJump) {
    const Quaterniond attitude(0.5, -0.5, 0.5, 0.5);
    for (const Named& c : regimes) {
        for (const double start_s : {0.0, 2.5}) {
            RotationState start;
            start.time_s = start_s;
            start.space_from_body = attitude;
            start.omega_body = c.omega;
            const FreeRotation motion(InertiaTensor::from_principal_moments(c.moments), start);
            const RotationState given = motion.at(start_s);
            EXPECT_EQ(given.omega_body, c.omega);
            EXPECT_EQ(given.space_from_body.coeffs(), attitude.coeffs());
            // At neighbouring instants the series are evaluated.
            for (const double beside : {-1e-300, 1e-300}) {
                const double t =
                    start_s == 0.0 ? beside : std::nextafter(start_s, start_s + beside * 1e308);
                const RotationState state = motion.at(t);
                EXPECT_LE((state.omega_body - c.omega).norm(), 2e-15 * c.omega.norm());
                EXPECT_LE((state.space_from_body.coeffs() - attitude.coeffs()).norm(), 2e-15);
            }
        }
    }
}

}  // namespace
}  // namespace poinsot::free_rotation_tests

// The exact free motion stays within its bounds in every family of extremes; accuracy_table tests
// 10,000 bodies per family and prints the results.
namespace poinsot::families {
namespace {

constexpr int n_bodies = 300;

class FreeRotationFamily : public testing::TestWithParam<Family> {};

TEST_P(FreeRotationFamily, StaysWithinBounds) {
    const Residuals r = measure(GetParam(), 0, n_bodies);
    EXPECT_EQ(r.n_not_finite, 0);
    // Measured over 10,000 bodies of all families: see the output of accuracy_table.
    EXPECT_LE(r.omega, GetParam().omega_bound);
    EXPECT_LE(r.attitude_rad, GetParam().attitude_bound);
    EXPECT_LE(r.herpolhode, GetParam().herpolhode_bound);
    EXPECT_TRUE(within_bounds(GetParam(), r)) << "energy " << r.energy << ", momentum "
                                              << r.momentum << ", |q| − 1 " << r.unit_quaternion;
}

std::string test_name(const testing::TestParamInfo<Family>& info) {
    std::string name;
    for (const char c : info.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Extremes, FreeRotationFamily,
                         testing::ValuesIn(all().begin(), all().end()), test_name);

}  // namespace
}  // namespace poinsot::families
