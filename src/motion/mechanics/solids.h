// Inertia of the solids of the lecture and of point masses, about the centre of mass.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "mechanics/inertia.h"

namespace poinsot {

// A uniform solid: a row of the solids' table. size_m has n_sizes entries, in the order that
// size_meaning says.
struct Solid {
    std::string_view name;          // "box"
    int n_sizes;                    // 3
    std::string_view size_meaning;  // "edge lengths along e1, e2, e3"
    Eigen::Vector3d (*moments_per_mass_m2)(std::span<const double> size_m);
};

// box, ellipsoid (half-axes), cylinder (radius, height; axis e3), cone (base radius, height),
// sphere (radius), torus (centre-line radius, tube radius), rod and others as rows.
std::span<const Solid> solids();

// Inertia of a solid of the table. Throws InputError for an unknown name (with the nearest), a
// wrong count of sizes, or a size or mass that is not finite and positive.
InertiaTensor inertia_of_solid(std::string_view name, std::span<const double> size_m,
                               double mass_kg);

struct PointMass {
    double mass_kg = 0.0;
    Eigen::Vector3d at_m = Eigen::Vector3d::Zero();  // body axes, any origin
};

struct MassDistribution {
    InertiaTensor inertia;  // about the centre of mass, in the axes of at_m
    Eigen::Vector3d centre_of_mass_m_body;
    double mass_kg;
};

// Inertia of point masses by compensated sums and the parallel axis theorem. Throws InputError
// naming the missing extent for one mass, coincident or collinear masses, and for a mass that is
// not finite and positive.
MassDistribution inertia_of_masses(std::span<const PointMass> masses);

}  // namespace poinsot
