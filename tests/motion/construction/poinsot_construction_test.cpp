// Properties of Poinsot's construction: contact, tangency, rolling without slipping, equal speeds,
// a herpolhode without inflection.
#include "construction/poinsot_construction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "construction/polhode.h"
#include "construction/timed_path.h"
#include "error/error.h"
#include "mechanics/motion.h"

namespace poinsot {
namespace {

struct Body {
    std::string name;
    Eigen::Vector3d moments;
    Eigen::Vector3d omega;
};

MotionProblem problem_of(const Body& body) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(body.moments);
    problem.start.omega_body = body.omega;
    return problem;
}

// One body of every regime, and seeded random ones.
std::vector<Body> bodies() {
    std::vector<Body> all{{"sphere", {2.0, 2.0, 2.0}, {0.3, -0.4, 0.5}},
                          {"oblate", {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
                          {"prolate", {3.0, 3.0, 1.0}, {0.5, 0.3, 1.0}},
                          {"about largest", {1.0, 2.0, 2.9}, {0.2, 0.3, 1.0}},
                          {"about smallest", {1.0, 2.0, 2.9}, {1.0, 0.3, 0.2}},
                          {"racket", {3.0, 2.0, 1.0}, {0.01, 2.0, 0.01}},
                          {"separatrix", {1.0, 2.0, 2.25}, {0.75, 0.5, 1.0}},
                          {"permanent", {1.0, 2.0, 2.5}, {0.0, 0.0, 1.5}}};
    std::mt19937_64 random(20261121);
    std::uniform_real_distribution<double> moment(0.2, 1.0);
    std::normal_distribution<double> component;
    for (int k = 0; k < 40; ++k) {
        // Second moments of mass are positive, so the sums obey the triangle inequality.
        const double x = moment(random);
        const double y = moment(random);
        const double z = moment(random);
        all.push_back({"random " + std::to_string(k),
                       {y + z, z + x, x + y},
                       {component(random), component(random), component(random)}});
    }
    return all;
}

// The herpolhode's point as films draw it, in the plane: space axes, relative to the plane's point
// on L.
Eigen::Vector3d herpolhode_point(const PoinsotConstruction& construction, const Motion& motion,
                                 double time_s) {
    const MotionSample sample =
        motion.sample(time_s, {.attitude = false, .herpolhode = true, .euler_angles = false});
    return construction.contact_in_plane(sample.herpolhode_space);
}

TimedPath herpolhode_path(const PoinsotConstruction& construction, const Motion& motion,
                          double first_time_s, double last_time_s, double shortest_feature_s,
                          double tolerance) {
    return sample_path([&](double t) { return herpolhode_point(construction, motion, t); },
                       first_time_s, last_time_s, shortest_feature_s, tolerance);
}

TEST(PoinsotConstruction, ContactPointLiesOnPlaneAndEllipsoid) {
    for (const Body& body : bodies()) {
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        for (const double t : {0.0, 0.7, 3.1, 20.0, -5.0}) {
            const RotationState state = motion.at(t);
            const Eigen::Vector3d contact = construction.contact_space(state);
            EXPECT_NEAR(contact.dot(construction.normal_space()), construction.plane_distance(),
                        4e-15 * construction.plane_distance())
                << body.name;
            const Eigen::Vector3d in_body = construction.contact_body(state.omega_body);
            EXPECT_NEAR(in_body.dot(body.moments.cwiseProduct(in_body)), 1.0, 4e-15) << body.name;
        }
    }
}

TEST(PoinsotConstruction, NormalAtContactIsAlongMomentum) {
    for (const Body& body : bodies()) {
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        for (const double t : {0.0, 1.3, 11.0}) {
            const RotationState state = motion.at(t);
            const Eigen::Vector3d gradient =
                state.space_from_body * Eigen::Vector3d(body.moments.cwiseProduct(
                                            construction.contact_body(state.omega_body)));
            EXPECT_LT(gradient.normalized().cross(construction.normal_space()).norm(), 4e-15)
                << body.name;
            EXPECT_GT(gradient.dot(construction.normal_space()), 0.0) << body.name;
        }
    }
}

TEST(PoinsotConstruction, RollsWithoutSlipping) {
    // The point of tangency follows from the attitude alone; its material velocity, from the
    // difference of two attitudes, vanishes to second order in the time step.
    constexpr double h = 1e-5;
    for (const Body& body : bodies()) {
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        for (const double t : {0.0, 0.9, 7.7}) {
            const RotationState state = motion.at(t);
            const Eigen::Vector3d touching =
                construction.tangency_point_space(state.space_from_body);
            EXPECT_NEAR(touching.dot(construction.normal_space()), construction.plane_distance(),
                        4e-15 * construction.plane_distance())
                << body.name;
            const Eigen::Vector3d material = state.space_from_body.conjugate() * touching;
            const Eigen::Vector3d velocity = (motion.at(t + h).space_from_body * material -
                                              motion.at(t - h).space_from_body * material) /
                                             (2.0 * h);
            // Third derivative of the attitude is of order ω³; h²ω³/6 plus rounding eps/h.
            const double bound = h * h * std::pow(1.0 + body.omega.norm(), 3) * 4.0 + 1e-10;
            EXPECT_LT(velocity.norm(), bound * touching.norm()) << body.name;
        }
    }
}

TEST(PoinsotConstruction, PolhodeAndHerpolhodeAreTracedAtEqualSpeed) {
    constexpr double h = 1e-4;
    for (const Body& body : bodies()) {
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        for (const double t : {0.0, 2.2}) {
            const RotationState before = motion.at(t - h);
            const RotationState after = motion.at(t + h);
            const double on_body = (construction.contact_body(after.omega_body) -
                                    construction.contact_body(before.omega_body))
                                       .norm();
            const double in_space =
                (construction.contact_space(after) - construction.contact_space(before)).norm();
            EXPECT_NEAR(on_body, in_space, 40.0 * h * h * h * std::pow(1.0 + body.omega.norm(), 3))
                << body.name;
        }
    }
}

TEST(PoinsotConstruction, RefusesABodyAtRest) {
    EXPECT_THROW(PoinsotConstruction(InertiaTensor::from_principal_moments({1.0, 2.0, 2.5}), {}),
                 InputError);
}

TEST(PoinsotConstruction, AnglesAndRatiosDoNotDependOnScale) {
    const Eigen::Vector3d omega{0.3, -0.8, 0.5};
    const Eigen::Vector3d moments{1.0, 2.0, 2.5};
    RotationState start;
    start.omega_body = omega;
    const PoinsotConstruction plain(InertiaTensor::from_principal_moments(moments), start);
    for (const double scale : {0x1p-700, 0x1p-40, 0x1p40, 0x1p500}) {
        start.omega_body = omega * scale;
        const PoinsotConstruction spun(InertiaTensor::from_principal_moments(moments), start);
        EXPECT_EQ(spun.plane_distance(), plain.plane_distance());
        EXPECT_EQ(spun.contact_body(start.omega_body), plain.contact_body(omega));
    }
}

TEST(Polhode, LiesOnEllipsoidAndPassesThroughTheMotion) {
    for (const Body& body : bodies()) {
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        const Polhode polhode(motion.problem().inertia, body.omega);
        constexpr double tolerance = 1e-3;
        std::vector<Eigen::Vector3d> points = polhode.sampled(tolerance);
        for (const Eigen::Vector3d& p : points) {
            EXPECT_NEAR(p.dot(body.moments.cwiseProduct(p)), 1.0, 1e-14) << body.name;
        }
        if (polhode.closed()) points.push_back(points.front());
        // Every contact point is within the tolerance of the polyline.
        for (const double t : {0.0, 0.4, 1.9, 6.0, -2.0}) {
            const Eigen::Vector3d contact = construction.contact_body(motion.at(t).omega_body);
            double least = (contact - points.front()).norm();
            for (std::size_t k = 1; k < points.size(); ++k) {
                const Eigen::Vector3d along = points[k] - points[k - 1];
                const double s = std::clamp(
                    (contact - points[k - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
                least = std::min(least, (contact - points[k - 1] - s * along).norm());
            }
            EXPECT_LT(least, 1.5 * tolerance) << body.name << " at t = " << t;
        }
    }
}

TEST(Polhode, AnnulusIsTheRangeOfTheHerpolhode) {
    for (const Body& body : bodies()) {
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        const Polhode::Annulus annulus = Polhode(motion.problem().inertia, body.omega).annulus();
        double least = 1e300;
        double most = 0.0;
        for (int k = 0; k <= 4000; ++k) {
            const Eigen::Vector3d p = herpolhode_point(construction, motion, 0.01 * k);
            const double radius = p.cross(construction.normal_space()).norm();
            least = std::min(least, radius);
            most = std::max(most, radius);
        }
        EXPECT_GE(least, annulus.inner - 1e-14) << body.name;
        EXPECT_LE(most, annulus.outer + 1e-14) << body.name;
        if (motion.regime() == Regime::elliptic_about_highest ||
            motion.regime() == Regime::elliptic_about_lowest) {
            // Samples in steps of 0.01 s miss a smooth extreme by the square of the step.
            EXPECT_LT(most, annulus.outer * (1.0 + 1e-2)) << body.name;
            EXPECT_GT(most, annulus.outer * (1.0 - 1e-2)) << body.name;
        }
    }
}

TEST(Polhode, AnnulusIsAccurateForTheSmallestWobble) {
    // ω ⟂ L of a wobble of size ε about the highest axis is proportional to ε: down to 1e-300,
    // whose square underflows.
    const InertiaTensor body = InertiaTensor::from_principal_moments({1.0, 2.0, 2.5});
    const auto annulus = [&body](double size) {
        return Polhode(body, {size, 2.0 * size, 1.0}).annulus();
    };
    for (const double size : {1e-100, 1e-170, 1e-300}) {
        EXPECT_NEAR(annulus(size).inner / size, annulus(1e-12).inner / 1e-12, 1e-14);
        EXPECT_NEAR(annulus(size).outer / size, annulus(1e-12).outer / 1e-12, 1e-14);
    }
}

TEST(Herpolhode, IsThePathOfTheContactPoint) {
    // From ω perpendicular to L, and from ω transformed to space by the attitude.
    for (const Body& body : bodies()) {
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        const Eigen::Vector3d foot = construction.plane_distance() * construction.normal_space();
        for (const double t : {0.0, 0.7, 3.1, 20.0, -5.0}) {
            const Eigen::Vector3d contact = construction.contact_space(motion.at(t));
            const Eigen::Vector3d drawn = foot + herpolhode_point(construction, motion, t);
            EXPECT_LE((drawn - contact).norm(), 1e-14 * contact.norm()) << body.name;
        }
    }
}

TEST(Herpolhode, HasNoInflection) {
    // For a real body the signed curvature keeps its sign (Landau & Lifshitz §37; Poinsot 1834).
    for (const Body& body : bodies()) {
        const Polhode polhode(InertiaTensor::from_principal_moments(body.moments), body.omega);
        if (polhode.kind() == Polhode::Kind::point) continue;
        const Motion motion(problem_of(body));
        const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
        constexpr double h = 1e-3;
        int positive = 0;
        int negative = 0;
        for (int k = 0; k < 3000; ++k) {
            const double t = 0.01 * k;
            const Eigen::Vector3d a = herpolhode_point(construction, motion, t - h);
            const Eigen::Vector3d b = herpolhode_point(construction, motion, t);
            const Eigen::Vector3d c = herpolhode_point(construction, motion, t + h);
            const double turn = (b - a).cross(c - b).dot(construction.normal_space());
            if (std::abs(turn) < 1e-15) continue;
            (turn > 0.0 ? positive : negative)++;
        }
        EXPECT_TRUE(positive == 0 || negative == 0)
            << body.name << ": " << positive << " left turns, " << negative << " right turns";
    }
}

TEST(Herpolhode, SamplesAreWithinToleranceAtTheirInstants) {
    const Body body{"generic", {1.0, 2.0, 2.9}, {1.678, 0.0, 0.639}};
    const Motion motion(problem_of(body));
    const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
    constexpr double tolerance = 1e-4;
    const TimedPath curve = herpolhode_path(construction, motion, 0.0, 20.0, 0.5, tolerance);
    for (int k = 0; k <= 500; ++k) {
        const double t = 0.04 * k;
        const double index = curve.index_at(t);
        const auto i = std::min(static_cast<std::size_t>(index), curve.points.size() - 2);
        const double f = index - static_cast<double>(i);
        const Eigen::Vector3d drawn = curve.points[i] + f * (curve.points[i + 1] - curve.points[i]);
        const Eigen::Vector3d truth = herpolhode_point(construction, motion, t);
        // The distance from the chord is at most the tolerance; along the chord, it is less than
        // the curve's change of speed in one piece.
        EXPECT_LT((drawn - truth).norm(), 10.0 * tolerance) << t;
    }
    EXPECT_EQ(curve.index_at(-1.0), 0.0);
    EXPECT_EQ(curve.index_at(1e9), static_cast<double>(curve.points.size() - 1));
}

TEST(Herpolhode, ShorterIntervalIsPartOfALongerOne) {
    const Body body{"generic", {1.0, 2.0, 2.9}, {1.678, 0.0, 0.639}};
    const Motion motion(problem_of(body));
    const PoinsotConstruction construction(motion.problem().inertia, motion.problem().start);
    const TimedPath whole = herpolhode_path(construction, motion, 0.1, 20.0, 0.7, 1e-4);
    for (const double last : {0.1, 0.37, 7.3}) {
        const TimedPath part = herpolhode_path(construction, motion, 0.1, last, 0.7, 1e-4);
        ASSERT_LT(part.points.size(), whole.points.size());
        for (std::size_t i = 0; i < part.points.size(); ++i) {
            EXPECT_EQ(part.times_s[i], whole.times_s[i]);
            EXPECT_EQ(part.points[i], whole.points[i]);
        }
        // It reaches the last instant and continues only a little beyond it.
        EXPECT_GE(part.times_s.back(), last);
        EXPECT_LE(part.times_s.back(), last + 0.35);
    }
}

TEST(RollingCones, AnglesAndRatesMatchTheTextbook) {
    // I = (2, 2, 3), ω = (0.5, 0.3, 1): tan α_body = ω⊥/ω₃, tan β = I₁ω⊥/(I₃ω₃) between L and e₃.
    const Eigen::Vector3d omega{0.5, 0.3, 1.0};
    const auto cones = rolling_cones(InertiaTensor::from_principal_moments({2.0, 2.0, 3.0}), omega);
    ASSERT_TRUE(cones);
    const double perpendicular = std::hypot(0.5, 0.3);
    const double alpha = std::atan(perpendicular);
    const double beta = std::atan(2.0 * perpendicular / 3.0);
    EXPECT_NEAR(cones->body_half_angle_rad, alpha, 1e-15);
    EXPECT_NEAR(cones->space_half_angle_rad, std::abs(alpha - beta), 2e-15);
    EXPECT_NEAR(cones->body_precession_rad_s, 0.5, 1e-15);
    EXPECT_FALSE(cones->body_cone_outside);
    EXPECT_NEAR(cones->space_precession_rad_s, Eigen::Vector3d(1.0, 0.6, 3.0).norm() / 2.0, 1e-15);

    EXPECT_FALSE(rolling_cones(InertiaTensor::from_principal_moments({2.0, 2.0, 2.0}), omega));
    EXPECT_FALSE(rolling_cones(InertiaTensor::from_principal_moments({1.0, 2.0, 2.5}), omega));
}

TEST(RollingCones, TouchAlongOmega) {
    // The angle between the axes is the sum (prolate) or difference (oblate) of the half-angles.
    for (const Eigen::Vector3d& moments :
         {Eigen::Vector3d{2.0, 2.0, 3.0}, Eigen::Vector3d{3.0, 3.0, 1.0}}) {
        const Eigen::Vector3d omega{0.5, 0.3, 1.0};
        const auto cones = rolling_cones(InertiaTensor::from_principal_moments(moments), omega);
        ASSERT_TRUE(cones);
        const Eigen::Vector3d L = moments.cwiseProduct(omega);
        const double between = std::atan2(std::hypot(L[0], L[1]), L[2]);
        const double sum = cones->body_cone_outside
                               ? cones->body_half_angle_rad + cones->space_half_angle_rad
                               : cones->body_half_angle_rad - cones->space_half_angle_rad;
        EXPECT_NEAR(between, sum, 2e-15);
    }
}

// Angles and rates do not depend on the unit of mass, nor rates over |ω| on that of time.
TEST(RollingCones, HaveTheSameRatesInEveryUnit) {
    const Eigen::Vector3d moments{2.0, 2.0, 1.0}, omega{0.1, 0.0, 1.0};
    const double precession = std::hypot(2.0 * 0.1, 1.0) / 2.0;
    const double half_angle = std::atan(0.1) - std::atan(2.0 * 0.1);
    for (const double kg_m2 : {1e-300, 1e-200, 1e-160, 1.0, 1e155, 1e200, 1e300}) {
        for (const double rad_s : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
            const auto cones = rolling_cones(InertiaTensor::from_principal_moments(kg_m2 * moments),
                                             rad_s * omega);
            ASSERT_TRUE(cones);
            EXPECT_NEAR(cones->space_precession_rad_s / rad_s, precession, 1e-15) << kg_m2;
            EXPECT_NEAR(cones->body_precession_rad_s / rad_s, -0.5, 1e-15) << kg_m2;
            EXPECT_NEAR(cones->space_half_angle_rad, std::abs(half_angle), 1e-15) << kg_m2;
            EXPECT_NEAR(cones->body_half_angle_rad, std::atan(0.1), 1e-15) << kg_m2;
        }
    }
    // A wobble whose square underflows.
    const auto small = rolling_cones(InertiaTensor::from_principal_moments({1.0, 1.0, 1e-200}),
                                     {1e-200, 0.0, 1.0});
    ASSERT_TRUE(small);
    EXPECT_NEAR(small->space_precession_rad_s / 1e-200, std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(small->space_half_angle_rad, std::atan(1.0), 1e-15);
}

TEST(Separatrices, LieOnTheEllipsoidWithTheMiddleRatio) {
    const Eigen::Vector3d moments{2.25, 1.0, 2.0};
    const auto curves = separatrices(InertiaTensor::from_principal_moments(moments), 1e-3);
    ASSERT_EQ(curves.size(), 2u);
    for (const auto& curve : curves) {
        for (const Eigen::Vector3d& p : curve) {
            EXPECT_NEAR(p.dot(moments.cwiseProduct(p)), 1.0, 1e-14);
            // L² = 2T·I₂ there: |Jρ|² = I₂.
            EXPECT_NEAR(moments.cwiseProduct(p).squaredNorm(), 2.0, 1e-14);
        }
    }
    EXPECT_TRUE(separatrices(InertiaTensor::from_principal_moments({2.0, 2.0, 3.0}), 1e-3).empty());
}

// ω too large by a share of δ: L by δ, T by 2δ + δ², and the contact is beyond the plane by δ.
TEST(PoinsotConstruction, ResidualsOfAWrongStateAreItsErrors) {
    const Body body{"generic", {1.0, 2.0, 2.9}, {1.0, 0.3, 0.2}};
    const Motion motion(problem_of(body));
    const PoinsotConstruction construction(motion.problem().inertia, motion.at(0.0));
    constexpr double share = 1e-3;
    RotationState state = motion.at(0.0);
    state.omega_body *= 1.0 + share;
    const RollingResiduals residuals = construction.residuals(state);
    EXPECT_NEAR(residuals.momentum, share, 1e-14);
    EXPECT_NEAR(residuals.energy, 2.0 * share + share * share, 1e-14);
    EXPECT_NEAR(residuals.contact_plane_gap, share, 1e-14);
    EXPECT_NEAR(residuals.tangency_gap, 0.0, 1e-14);
}

}  // namespace
}  // namespace poinsot
