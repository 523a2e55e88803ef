// The internal friction for which a body loses half of its dissipable energy in a given time.
#pragma once

#include <Eigen/Core>

#include "mechanics/inertia.h"

namespace poinsot {

// Returns the InternalFriction::rate_1_s for which the excess T − L²/(2 I_max), I_max the largest
// moment, falls to half of its initial value in half_life_s. Motions of up to some thousand turns
// are integrated step by step; for longer ones, T falls at its mean rate over each polhode, with a
// relative error below 1/(number of turns). Throws InputError for a start at rest or along a
// principal axis, to 1e-12 of ω: such a motion does not change or has no energy to lose.
double friction_rate_of_half_life(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
                                  double half_life_s);

// Returns the mean of |L × ω|²/L² over one polhode of the free motion with this L and T, in
// rad²/s²; with friction κ, dT/dt is −κ times this mean (RotationDynamics). `momentum` in kg m²/s
// and `twice_T` in J, 2T between L²/I_max and L²/I_min. Source: the squares of the momenta are
// those of Jacobi's functions, Landau & Lifshitz, Mechanics §37, whose means are in K and E (DLMF
// 22.16.20).
double mean_burning(const Eigen::Vector3d& moments_kg_m2, double momentum, double twice_T);

}  // namespace poinsot
