#include "mechanics/solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "error/error.h"
#include "numerics/power_of_two.h"
#include "numerics/symmetric_eigen.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

using Sizes = std::span<const double>;

// Moments of uniform solids over their mass, about the centre of mass, symmetry axis e3.
// Source: any table of moments of inertia, e.g. Goldstein, Poole & Safko, ch. 5, problems.
Eigen::Vector3d box(Sizes s) {
    const double x = s[0] * s[0];
    const double y = s[1] * s[1];
    const double z = s[2] * s[2];
    return Eigen::Vector3d(y + z, z + x, x + y) / 12.0;
}
Eigen::Vector3d ellipsoid(Sizes s) {
    const double x = s[0] * s[0];
    const double y = s[1] * s[1];
    const double z = s[2] * s[2];
    return Eigen::Vector3d(y + z, z + x, x + y) / 5.0;
}
Eigen::Vector3d about_e3(double across, double along) { return {across, across, along}; }
Eigen::Vector3d cylinder(Sizes s) {
    const double r2 = s[0] * s[0];
    return about_e3((3.0 * r2 + s[1] * s[1]) / 12.0, 0.5 * r2);
}
Eigen::Vector3d tube(Sizes s) {
    const double r2 = s[0] * s[0] + s[1] * s[1];
    return about_e3((3.0 * r2 + s[2] * s[2]) / 12.0, 0.5 * r2);
}
Eigen::Vector3d cone(Sizes s) {
    const double r2 = s[0] * s[0];
    return about_e3(3.0 * (4.0 * r2 + s[1] * s[1]) / 80.0, 0.3 * r2);
}
Eigen::Vector3d sphere(Sizes s) { return Eigen::Vector3d::Constant(0.4 * s[0] * s[0]); }
Eigen::Vector3d shell(Sizes s) { return Eigen::Vector3d::Constant(2.0 / 3.0 * s[0] * s[0]); }
Eigen::Vector3d torus(Sizes s) {
    const double R2 = s[0] * s[0];
    const double a2 = s[1] * s[1];
    return about_e3((4.0 * R2 + 5.0 * a2) / 8.0, R2 + 0.75 * a2);
}
Eigen::Vector3d rod(Sizes s) {
    const double r2 = s[1] * s[1];
    return about_e3((3.0 * r2 + s[0] * s[0]) / 12.0, 0.5 * r2);
}
Eigen::Vector3d disc(Sizes s) {
    const double r2 = s[0] * s[0];
    return about_e3(0.25 * r2, 0.5 * r2);
}
Eigen::Vector3d ring(Sizes s) {
    const double r2 = s[0] * s[0];
    return about_e3(0.5 * r2, r2);
}
Eigen::Vector3d plate(Sizes s) {
    const double x = s[0] * s[0];
    const double y = s[1] * s[1];
    return Eigen::Vector3d(y, x, x + y) / 12.0;
}

constexpr std::array<Solid, 12> solid_rows{{
    {"box", 3, "edge lengths along e1, e2, e3", box},
    {"ellipsoid", 3, "half-axes along e1, e2, e3", ellipsoid},
    {"cylinder", 2, "radius, height along e3", cylinder},
    {"cone", 2, "base radius, height along e3", cone},
    {"sphere", 1, "radius", sphere},
    {"torus", 2, "radius of the centre line, radius of the tube; axis e3", torus},
    {"rod", 2, "length along e3, radius", rod},
    {"disc", 1, "radius; thin, axis e3", disc},
    {"plate", 2, "edge lengths along e1, e2; thin", plate},
    {"ring", 1, "radius; thin, axis e3", ring},
    {"shell", 1, "radius; thin spherical shell", shell},
    {"tube", 3, "inner radius, outer radius, height along e3", tube},
}};

const Solid& solid_named(std::string_view name) {
    if (const Solid* row = find_row(solid_rows, name)) return *row;
    throw InputError(unknown("shape", name, names_of(solid_rows)));
}

void check_mass(double mass_kg, std::string_view what) {
    if (std::isfinite(mass_kg) && mass_kg > 0.0) return;
    throw InputError(fmt::format("{} = {}: a mass must be finite and positive", what, mass_kg));
}

// The difference of a double and a double-double, rounded to two doubles.
DoubleDouble difference(double a, DoubleDouble b) { return DoubleDouble(a) - b; }

struct ScaledMass {
    double mass;
    Eigen::Vector3d at;
};

struct SecondMoments {
    std::array<DoubleDouble, 3> centre;
    DoubleDouble mass;
    TensorDD inertia;
};

// Sums in double-double: an offset of 1e8 loses no digit of the inertia.
SecondMoments second_moments(std::span<const ScaledMass> masses) {
    SecondMoments sum;
    std::array<DoubleDouble, 3> moment;
    for (const ScaledMass& m : masses) {
        sum.mass = sum.mass + m.mass;
        for (int i = 0; i < 3; ++i) moment[i] = moment[i] + two_product(m.mass, m.at[i]);
    }
    for (int i = 0; i < 3; ++i) sum.centre[i] = moment[i] / sum.mass;

    TensorDD second;
    for (const ScaledMass& m : masses) {
        std::array<DoubleDouble, 3> d;
        for (int i = 0; i < 3; ++i) d[i] = difference(m.at[i], sum.centre[i]);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) second[i][j] = second[i][j] + d[i] * d[j] * m.mass;
        }
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        sum.inertia[i][i] = second[j][j] + second[k][k];
        sum.inertia[i][j] = sum.inertia[j][i] = -second[i][j];
    }
    return sum;
}

// Throws if the masses span fewer than two dimensions, beyond the rounding of their coordinates.
void check_extent(const Eigen::Vector3d& moments, double mass, double rounding) {
    const double negligible = mass * rounding * rounding;
    if (moments.maxCoeff() <= negligible) {
        throw InputError(
            "body.masses: all masses are at one point, so the body has no extent and no inertia "
            "about it; give masses at three points that are not in line");
    }
    const double least = std::max(negligible, 1e-26 * moments.maxCoeff());
    if (moments.minCoeff() <= least) {
        throw InputError(
            "body.masses: all masses lie on one line, so the body has no extent across it and no "
            "inertia about it; add a mass off the line");
    }
}

}  // namespace

std::span<const Solid> solids() { return solid_rows; }

InertiaTensor inertia_of_solid(std::string_view name, std::span<const double> size_m,
                               double mass_kg) {
    const Solid& solid = solid_named(name);
    if (size_m.size() != static_cast<std::size_t>(solid.n_sizes)) {
        throw InputError(fmt::format("size_m of a {} has {} values, not {}: {}", name,
                                     solid.n_sizes, size_m.size(), solid.size_meaning));
    }
    for (std::size_t i = 0; i < size_m.size(); ++i) {
        if (std::isfinite(size_m[i]) && size_m[i] > 0.0) continue;
        throw InputError(
            fmt::format("size_m[{}] = {}: the sizes of a {} ({}) must be finite and positive", i,
                        size_m[i], name, solid.size_meaning));
    }
    check_mass(mass_kg, "mass_kg");

    const int exponent = exponent_of(std::ranges::max(size_m));
    std::array<double, 3> scaled{};
    for (std::size_t i = 0; i < size_m.size(); ++i) scaled[i] = std::ldexp(size_m[i], -exponent);
    const int mass_exponent = exponent_of(mass_kg);
    Eigen::Vector3d moments = solid.moments_per_mass_m2({scaled.data(), size_m.size()}) *
                              std::ldexp(mass_kg, -mass_exponent);
    for (double& I : moments) I = std::ldexp(I, mass_exponent + 2 * exponent);
    if (!std::isfinite(moments.maxCoeff()) || !(moments.minCoeff() > 0.0)) {
        throw InputError(fmt::format(
            "size_m and mass_kg of the {} give moments of {}, {}, {} kg m^2, beyond what a double "
            "holds; choose other units",
            name, moments[0], moments[1], moments[2]));
    }
    // A solid's moments satisfy the triangle inequality except for their rounding.
    return InertiaTensor::from_principal_moments(moments, Physicality::waived);
}

MassDistribution inertia_of_masses(std::span<const PointMass> masses) {
    if (masses.empty()) throw InputError("body.masses is empty: give at least three masses");
    double largest_mass = 0.0;
    double largest_coordinate = 0.0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        check_mass(masses[i].mass_kg, fmt::format("body.masses[{}].mass_kg", i));
        if (!masses[i].at_m.allFinite()) {
            throw InputError(
                fmt::format("body.masses[{}].at_m: coordinates must be finite numbers", i));
        }
        largest_mass = std::max(largest_mass, masses[i].mass_kg);
        largest_coordinate = std::max(largest_coordinate, masses[i].at_m.cwiseAbs().maxCoeff());
    }

    const int mass_exponent = exponent_of(largest_mass);
    const int exponent = exponent_of(largest_coordinate);
    std::vector<ScaledMass> scaled;
    for (const PointMass& m : masses) {
        scaled.push_back({std::ldexp(m.mass_kg, -mass_exponent), ldexp(m.at_m, -exponent)});
    }
    const SecondMoments sum = second_moments(scaled);
    bool axes_are_principal = true;
    for (int i = 0; i < 3; ++i) {
        axes_are_principal = axes_are_principal && sum.inertia[i][(i + 1) % 3].hi == 0.0;
    }
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const SymmetricEigen eigen =
        symmetric_eigen(sum.inertia, axes_are_principal ? 0.0 : 4.0 * epsilon);
    Eigen::Vector3d moments;
    for (int i = 0; i < 3; ++i) moments[i] = eigen.values[i].rounded();
    check_extent(moments, sum.mass.hi, 2.0 * epsilon);

    for (double& I : moments) I = std::ldexp(I, mass_exponent + 2 * exponent);
    Eigen::Vector3d centre;
    for (int i = 0; i < 3; ++i) centre[i] = std::ldexp(sum.centre[i].rounded(), exponent);
    return {InertiaTensor::from_principal_axes(moments, eigen.vectors), centre,
            std::ldexp(sum.mass.rounded(), mass_exponent)};
}

}  // namespace poinsot
