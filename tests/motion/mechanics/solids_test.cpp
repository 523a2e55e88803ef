// Solids compared with integrals over their mass, and point masses with bodies calculated by hand.
#include "mechanics/solids.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "error/error.h"
#include "refusal.h"

namespace poinsot::solids_tests {
namespace {

using Eigen::Vector3d;

Vector3d moments_of(std::string_view name, std::vector<double> sizes, double mass = 1.0) {
    return inertia_of_solid(name, sizes, mass).moments_kg_m2();
}

// ∫f over [a, b] by Gauss's rule of ten points on pieces: exact for the polynomials used here.
double integral(double a, double b, const std::function<double(double)>& f) {
    static constexpr std::array<double, 5> x{0.1488743389816312, 0.4333953941292472,
                                             0.6794095682990244, 0.8650633666889845,
                                             0.9739065285171717};
    static constexpr std::array<double, 5> w{0.2955242247147529, 0.2692667193099963,
                                             0.2190863625159820, 0.1494513491505806,
                                             0.0666713443086881};
    constexpr int n_pieces = 400;
    double sum = 0.0;
    for (int piece = 0; piece < n_pieces; ++piece) {
        const double middle = a + (b - a) * (piece + 0.5) / n_pieces;
        const double half = 0.5 * (b - a) / n_pieces;
        for (std::size_t i = 0; i < x.size(); ++i) {
            sum += half * w[i] * (f(middle + half * x[i]) + f(middle - half * x[i]));
        }
    }
    return sum;
}

// Moments over mass of a body of revolution about e3, from annuli: inner and outer radius at height
// z, about the centre of mass.
Vector3d of_revolution(double z0, double z1, const std::function<double(double)>& inner,
                       const std::function<double(double)>& outer) {
    const auto power = [&](double z, int n) {
        return std::pow(outer(z), n) - std::pow(inner(z), n);
    };
    const double mass = integral(z0, z1, [&](double z) { return power(z, 2); });
    const double centre = integral(z0, z1, [&](double z) { return z * power(z, 2); }) / mass;
    const double radial = integral(z0, z1, [&](double z) { return 0.5 * power(z, 4); }) / mass;
    const double height =
        integral(z0, z1, [&](double z) { return (z - centre) * (z - centre) * power(z, 2); }) /
        mass;
    return {0.5 * radial + height, 0.5 * radial + height, radial};
}

// The rule for the integrals is accurate to 2e-14, measured.
void expect_near(const Vector3d& got, const Vector3d& expected, double tolerance) {
    EXPECT_LE((got - expected).cwiseAbs().maxCoeff(), tolerance * expected.maxCoeff())
        << got.transpose() << " instead of " << expected.transpose();
}

TEST(Solids, OfRevolutionAgreeWithTheIntegralOfTheirMass) {
    const auto none = [](double) { return 0.0; };
    expect_near(moments_of("cylinder", {0.7, 1.9}),
                of_revolution(0.0, 1.9, none, [](double) { return 0.7; }), 1e-13);
    expect_near(moments_of("cone", {0.7, 1.9}),
                of_revolution(0.0, 1.9, none, [](double z) { return 0.7 * (1.0 - z / 1.9); }),
                1e-13);
    expect_near(moments_of("sphere", {0.7}),
                of_revolution(-0.7, 0.7, none, [](double z) { return std::sqrt(0.49 - z * z); }),
                1e-13);
    expect_near(moments_of("ellipsoid", {0.7, 0.7, 1.1}),
                of_revolution(-1.1, 1.1, none,
                              [](double z) { return 0.7 * std::sqrt(1.0 - z * z / 1.21); }),
                1e-13);
    // The radii of the torus' annuli are square roots that meet at top and bottom: the rule
    // converges slowly there.
    const auto reach = [](double z) { return std::sqrt(std::max(0.0, 0.09 - z * z)); };
    expect_near(moments_of("torus", {1.0, 0.3}),
                of_revolution(
                    -0.3, 0.3, [&](double z) { return 1.0 - reach(z); },
                    [&](double z) { return 1.0 + reach(z); }),
                1e-7);
    expect_near(moments_of("tube", {0.4, 0.7, 1.9}),
                of_revolution(
                    0.0, 1.9, [](double) { return 0.4; }, [](double) { return 0.7; }),
                1e-13);
    expect_near(moments_of("rod", {1.9, 0.1}),
                of_revolution(0.0, 1.9, none, [](double) { return 0.1; }), 1e-13);
}

TEST(Solids, BoxIsASumOfItsEdges) {
    // ∫x² over an edge of length a and unit mass is a²/12.
    expect_near(moments_of("box", {1.0, 2.0, 3.0}, 12.0), {13.0, 10.0, 5.0}, 1e-15);
    expect_near(moments_of("ellipsoid", {1.0, 2.0, 3.0}, 5.0), {13.0, 10.0, 5.0}, 1e-15);
}

TEST(Solids, ThinBodiesAreLimitsOfThickBodies) {
    expect_near(moments_of("disc", {0.7}), moments_of("cylinder", {0.7, 1e-9}), 1e-15);
    expect_near(moments_of("plate", {0.7, 1.1}), moments_of("box", {0.7, 1.1, 1e-9}), 1e-15);
    expect_near(moments_of("ring", {0.7}), moments_of("torus", {0.7, 1e-9}), 1e-15);
    expect_near(moments_of("shell", {0.7}), Vector3d::Constant(2.0 / 3.0 * 0.49), 1e-15);
    EXPECT_TRUE(inertia_of_solid("plate", std::array{0.7, 1.1}, 1.3).planar());
    EXPECT_TRUE(inertia_of_solid("disc", std::array{0.7}, 1.3).planar());
}

TEST(Solids, EveryRowIsValidAtEveryScale) {
    for (const Solid& solid : solids()) {
        const std::array<double, 3> sizes{0.3, 0.7, 1.1};
        const std::span<const double> used(sizes.data(), static_cast<std::size_t>(solid.n_sizes));
        const Vector3d moments = inertia_of_solid(solid.name, used, 2.0).moments_kg_m2();
        EXPECT_GT(moments.minCoeff(), 0.0) << solid.name;
        EXPECT_EQ(InertiaTensor::from_principal_moments(moments).moments_kg_m2(), moments);
        // Sizes near the ends of the exponent range: squares alone would underflow or overflow.
        std::array<double, 3> tiny{};
        for (std::size_t i = 0; i < 3; ++i) tiny[i] = std::ldexp(sizes[i], -550);
        const Vector3d small =
            inertia_of_solid(solid.name, {tiny.data(), used.size()}, std::ldexp(2.0, 600))
                .moments_kg_m2();
        EXPECT_EQ(small, moments.unaryExpr([](double I) { return std::ldexp(I, -500); }))
            << solid.name;
    }
}

TEST(Solids, RefuseInvalidSizesAndMasses) {
    EXPECT_NE(refusal_message([] {
                  moments_of("cyllinder", {1.0, 1.0});
              }).find("\"cylinder\""),
              std::string::npos);
    EXPECT_NE(refusal_message([] {
                  moments_of("box", {1.0, 2.0});
              }).find("3 values, not 2"),
              std::string::npos);
    EXPECT_NE(refusal_message([] {
                  moments_of("box", {1.0, 0.0, 1.0});
              }).find("size_m[1] = 0"),
              std::string::npos);
    EXPECT_NE(refusal_message([] { moments_of("sphere", {std::nan("")}); }), "");
    EXPECT_NE(refusal_message([] { moments_of("sphere", {1.0}, -1.0); }).find("mass_kg"),
              std::string::npos);
    EXPECT_NE(refusal_message([] { moments_of("sphere", {1e200}, 1.0); }).find("beyond"),
              std::string::npos);
}

TEST(PointMasses, MatchTheTextbookTensorAboutTheirCentre) {
    // Masses at ±1, ±2, ±3 along the axes, moved off the origin.
    std::vector<PointMass> masses;
    const Vector3d offset(5.0, -7.0, 11.0);
    for (int i = 0; i < 3; ++i) {
        for (const double side : {-1.0, 1.0}) {
            masses.push_back({0.5, offset + side * (i + 1.0) * Vector3d::Unit(i)});
        }
    }
    const MassDistribution body = inertia_of_masses(masses);
    EXPECT_EQ(body.centre_of_mass_m_body, offset);
    EXPECT_EQ(body.mass_kg, 3.0);
    EXPECT_EQ(body.inertia.moments_kg_m2(), Vector3d(13.0, 10.0, 5.0));
    EXPECT_TRUE(body.inertia.body_axes_are_principal());
}

TEST(PointMasses, KeepEveryDigitFarFromTheOrigin) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::vector<PointMass> near;
    std::vector<PointMass> far;
    for (int n = 0; n < 20; ++n) {
        // Multiples of 2^−24, so that adding 1e8 rounds nothing.
        const auto coordinate = [&] {
            return std::round(std::ldexp(normal(random), 24)) * 0x1p-24;
        };
        const PointMass mass{1.0 + 0.1 * n, {coordinate(), coordinate(), coordinate()}};
        near.push_back(mass);
        far.push_back({mass.mass_kg, mass.at_m + Vector3d::Constant(1e8)});
    }
    const InertiaTensor here = inertia_of_masses(near).inertia;
    const InertiaTensor there = inertia_of_masses(far).inertia;
    EXPECT_EQ(here.moments_kg_m2(), there.moments_kg_m2());
    EXPECT_EQ(here.body_from_principal(), there.body_from_principal());
}

TEST(PointMasses, CoplanarMassesAreALamina) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 200; ++n) {
        const Vector3d x(normal(random), normal(random), normal(random));
        const Vector3d y(normal(random), normal(random), normal(random));
        std::array<PointMass, 5> masses;
        for (PointMass& mass : masses) mass = {1.0, normal(random) * x + normal(random) * y};
        EXPECT_TRUE(inertia_of_masses(masses).inertia.planar());
    }
}

TEST(PointMasses, NameTheMissingExtent) {
    const auto message = [](std::vector<PointMass> masses) {
        return refusal_message([&] { inertia_of_masses(masses); });
    };
    EXPECT_NE(message({}).find("empty"), std::string::npos);
    EXPECT_NE(message({{1.0, {1.0, 2.0, 3.0}}}).find("at one point"), std::string::npos);
    EXPECT_NE(message({{1.0, {1.0, 2.0, 3.0}}, {2.0, {1.0, 2.0, 3.0}}}).find("at one point"),
              std::string::npos);
    EXPECT_NE(message({{1.0, {0.1, 0.2, 0.3}}, {2.0, {0.3, 0.6, 0.9}}}).find("on one line"),
              std::string::npos);
    // Collinear except for the rounding of the coordinates.
    EXPECT_NE(message({{1.0, {1e8, 1e8, 1e8}},
                       {2.0, {1e8 + 0.1, 1e8 + 0.2, 1e8 + 0.3}},
                       {2.0, {1e8 + 0.7, 1e8 + 1.4, 1e8 + 2.1}}})
                  .find("on one line"),
              std::string::npos);
    EXPECT_NE(message({{0.0, {1.0, 2.0, 3.0}}}).find("body.masses[0].mass_kg = 0"),
              std::string::npos);
    EXPECT_NE(message({{1.0, {1.0, std::nan(""), 3.0}}}).find("body.masses[0].at_m"),
              std::string::npos);
}

}  // namespace
}  // namespace poinsot::solids_tests
