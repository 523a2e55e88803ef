// The constants of Jacobi's solution for one motion, computed once in wide double-double.
//
// Notation, as in van Zon & Schofield, J. Comput. Phys. 225 (2007) 145: the polhode encircles the
// axis a, b is the axis of the middle moment, c the other one. Signs of the axes are chosen so that
// (a, b, c) is right-handed, the momentum along a is positive and along c is of the sign of s. Then
//     momentum = (A dn u, B sn u, s C cn u),   u = λ t + u₀,   s = +1 if a has the lowest moment.
// The attitude is computed in the axes that follow a with the least rotation: in these axes no pole
// appears at zero wobble.
#pragma once

#include <Eigen/Core>
#include <array>

#include "mechanics/regime.h"
#include "numerics/wide_double.h"

namespace poinsot {

using WideTriple = std::array<WideDouble, 3>;

struct JacobiSolution {
    Regime regime = Regime::at_rest;
    std::array<int, 3> axis{0, 1, 2};           // principal axis of a, b, c
    std::array<double, 3> sign{1.0, 1.0, 1.0};  // of each along its principal axis
    int s = 1;
    WideDouble momentum;      // |L|
    WideDouble twice_energy;  // 2T
    WideTriple moments;       // Ia, Ib, Ic
    WideTriple delta;         // L² − 2T·I of a, b, c, each accurate however small
    WideTriple amplitude;     // A, B, C
    WideTriple start;         // momentum at the start in a, b, c
    // sn u₀, cn u₀, dn u₀.
    WideDouble sn;
    WideDouble cn;
    WideDouble dn;
    WideDouble modulus;                       // k
    WideDouble complementary_modulus = 1.0;   // k′; zero on the separatrix
    WideDouble rate;                          // λ, rad/s
    WideDouble quarter_period;                // K; zero on the separatrix, where it is infinite
    WideDouble complementary_quarter_period;  // K′; zero for a symmetric body: it is infinite
    WideDouble third_kind_argument;  // F(φ, k′) = 2K′ − β, where Θ vanishes at u = −iβ
    WideDouble mean_turn_rate;       // Ω: mean rate about L of the axes that follow a
    WideDouble start_phase;          // u₀/2K; on the separatrix u₀
};

// Σ_j I_j ω_j² (I_j − I_i) = L² − 2T·I_i, rounded once: its sign tells the families of polhodes
// apart, and it is zero on the separatrix alone. kg² m⁴/s²; moments and rates as below.
WideDouble momentum_difference(const Eigen::Vector3d& moments_kg_m2,
                               const Eigen::Vector3d& omega_principal, int i);

// Moments in kg m² and angular velocity in rad/s along the principal axes, both finite, moments
// positive. In permanent rotation and at rest only regime, axis, momentum and twice_energy are set.
// Source: Jacobi 1849; van Zon & Schofield 2007; Celledoni, Fassò, Säfström & Zanna, SIAM J. Sci.
// Comput. 30 (2008) 2084. Departures: k′² is computed from L² − 2T·Ib, not as 1 − k², and that
// difference is exact (Shewchuk's expansions); the sum for Ω does not cancel for needles.
// `on_separatrix`: L² = 2T·Ib is known to hold exactly, and ω is the rounding of a point of the
// separatrix, to which the start is moved.
JacobiSolution solve_free_rotation(const Eigen::Vector3d& moments_kg_m2,
                                   const Eigen::Vector3d& omega_principal,
                                   bool on_separatrix = false);

}  // namespace poinsot
