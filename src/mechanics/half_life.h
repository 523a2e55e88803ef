// The friction inside a body that takes a given time to burn half of the energy that it can.
#pragma once

#include <Eigen/Core>

#include "mechanics/inertia.h"

namespace poinsot {

// DissipationTorque::rate_1_s for which the excess T − L²/(2 I_max), I_max the largest moment, is
// half of its start's after half_life_s. Motions of up to some thousand turns are stepped through;
// of longer ones, T falls by its mean over each polhode, which is off by less than a part in the
// thousands of turns. Throws InputError for a start at rest or along a principal axis, to 1e-12
// of ω: there it stays, or has nothing to lose.
double dissipation_rate_of_half_life(const InertiaTensor& inertia,
                                     const Eigen::Vector3d& omega_body, double half_life_s);

// Mean of |L × ω|²/L² over one polhode of the free motion with this L and T, in rad²/s²: with
// friction κ, T falls at κ times as much (RotationDynamics). `momentum` in kg m²/s and `twice_T`
// in J, 2T between L²/I_max and L²/I_min. Source: the squares of the momenta are those of Jacobi's
// functions, Landau & Lifshitz, Mechanics §37, whose means are in K and E (DLMF 22.16.20).
double mean_burning(const Eigen::Vector3d& moments_kg_m2, double momentum, double twice_T);

}  // namespace poinsot
