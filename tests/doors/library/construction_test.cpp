// The public construction against its definitions.
#include "library/poinsot/construction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "error/error.h"

namespace poinsot::library {
namespace {

using Eigen::Vector3d;

constexpr double infinite = std::numeric_limits<double>::infinity();

const Vector3d I{1.0, 2.0, 3.0}, start_omega{0.01, 2.0, 0.01};

// The distance of a point from a closed polyline.
double distance_from(const std::vector<Vector3d>& points, const Vector3d& point) {
    double least = infinite;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d& from = points[i == 0 ? points.size() - 1 : i - 1];
        const Vector3d along = points[i] - from;
        const double share = std::clamp(along.dot(point - from) / along.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (from + share * along - point).norm());
    }
    return least;
}

TEST(LibraryConstruction, TouchesThePlaneAtTheContactPoint) {
    const Motion motion(I, start_omega);
    const Construction construction(motion);
    const Vector3d momentum = I.cwiseProduct(start_omega);
    const double distance = std::sqrt(momentum.dot(start_omega)) / momentum.norm();
    EXPECT_NEAR(construction.plane_distance(), distance, 1e-15);
    EXPECT_TRUE(construction.half_axes().isApprox(I.cwiseSqrt().cwiseInverse(), 1e-15));
    EXPECT_TRUE(construction.normal_space().isApprox(momentum.normalized(), 1e-15));
    const std::vector<double> times{0.0, 3.7, -1e4};
    const std::vector<Vector3d> herpolhode = construction.herpolhode(times);
    const Construction::Radii radii = construction.herpolhode_radii();
    for (std::size_t i = 0; i < times.size(); ++i) {
        const ContactPoint contact = construction.contact(times[i]);
        EXPECT_NEAR(contact.body.dot(I.cwiseProduct(contact.body)), 1.0, 1e-14);
        EXPECT_NEAR(contact.space.dot(construction.normal_space()), distance, 1e-14);
        EXPECT_TRUE(contact.space.isApprox(
            herpolhode[i] + construction.plane_distance() * construction.normal_space(), 1e-13));
        EXPECT_GE(herpolhode[i].norm(), radii.least * (1.0 - 1e-12));
        EXPECT_LE(herpolhode[i].norm(), radii.greatest * (1.0 + 1e-12));
        const State state = motion.at(times[i]);
        EXPECT_TRUE(contact.space.isApprox(state.space_from_body * contact.body, 1e-14));
        const Residuals residuals = construction.residuals(times[i]);
        EXPECT_LT(residuals.contact_plane_gap, 2e-14);
        EXPECT_LT(residuals.momentum, 2e-14);
    }
}

TEST(LibraryConstruction, GivesThePolhodeWithinATolerance) {
    const Construction construction(Motion(I, start_omega));
    for (const double tolerance : {1e-2, 1e-5}) {
        const Polhode polhode = construction.polhode(tolerance);
        EXPECT_TRUE(polhode.closed);
        EXPECT_LE(polhode.largest_distance, tolerance);
        for (int i = 0; i < 50; ++i)
            EXPECT_LE(distance_from(polhode.points, construction.contact(0.37 * i).body),
                      tolerance);
    }
    EXPECT_GT(construction.polhode(1e-5).points.size(), construction.polhode(1e-2).points.size());
}

TEST(LibraryConstruction, KnowsTheConesOfASymmetricBody) {
    const auto cones = Construction(Motion({2.0, 2.0, 1.0}, {0.5, 0.0, 2.0})).cones();
    ASSERT_TRUE(cones);
    EXPECT_EQ(cones->symmetry_axis, 2);
    EXPECT_NEAR(cones->body_half_angle_rad, std::atan2(0.5, 2.0), 1e-15);
    EXPECT_NEAR(cones->space_precession_rad_s, std::sqrt(1.0 + 4.0) / 2.0, 1e-15);
    EXPECT_FALSE(Construction(Motion(I, start_omega)).cones());
}

TEST(LibraryConstruction, FlipsWhereOmegaAlongTheMiddleAxisVanishes) {
    const Motion motion(I, start_omega);
    const Construction construction(motion);
    const double period_s = motion.constants().polhode_period_s.value();
    const std::vector<double> flips = construction.flips(0.0, 10.0 * period_s);
    EXPECT_EQ(flips.size(), 20u);
    for (const double time_s : flips) EXPECT_NEAR(motion.at(time_s).omega_body[1], 0.0, 1e-12);
    EXPECT_TRUE(Construction(Motion(I, {1.0, 0.0, 0.0})).flips(0.0, 1e9).empty());
    EXPECT_THROW(static_cast<void>(construction.flips(0.0, 1e9)), InputError);
    EXPECT_THROW(static_cast<void>(construction.flips(0.0, infinite)), InputError);
}

TEST(LibraryConstruction, CertifiesExactMotionsAndFindsSteppingErrors) {
    std::vector<double> times;
    for (int i = 0; i < 100; ++i) times.push_back(0.1 * i);
    const Certificate exact = Construction(Motion(I, start_omega)).certificate(times);
    EXPECT_TRUE(exact.holds);
    EXPECT_EQ(exact.claims.size(), 7u);
    for (const Claim& claim : exact.claims)
        EXPECT_TRUE(claim.holds()) << claim.name << ": " << claim.worst;
    const Construction coarse(
        Motion(I, start_omega, {.method = "rk4", .step_s = 0.1, .last_time_s = 10.0}));
    EXPECT_FALSE(coarse.certificate(times, 1e-9).holds);
    EXPECT_TRUE(coarse.certificate(times, 1e-2).holds);
    EXPECT_THROW(static_cast<void>(coarse.certificate(times, 0.0)), InputError);
}

TEST(LibraryConstruction, RefusesMotionsWithoutAnInvariablePlane) {
    EXPECT_THROW(Construction(Motion(I, {0.0, 0.0, 0.0})), InputError);
    EXPECT_THROW(Construction(Motion::heavy_top(1.0, 1.0, 1.0, {.theta_rad = 1.0})), InputError);
    const Construction construction(Motion(I, start_omega));
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), infinite})
        EXPECT_THROW(static_cast<void>(construction.polhode(bad)), InputError) << bad;
    EXPECT_THROW(static_cast<void>(construction.contact(infinite)), InputError);
}

}  // namespace
}  // namespace poinsot::library
