// The integrators: one function each. A row of the table in methods.cpp names it.
#pragma once

#include "mechanics/methods.h"

namespace poinsot {

// Explicit, for any torque.
Propagator euler(const MethodStart& start);   // order 1
Propagator rk4(const MethodStart& start);     // order 4
Propagator dopri5(const MethodStart& start);  // order 5, adaptive, dense output of order 4
// Runge–Kutta–Munthe-Kaas of order 4 for the attitude, with L in space: L is kept without a torque.
Propagator rkmk4(const MethodStart& start);

// Implicit midpoint rule in momentum with a Cayley update of the attitude, order 2: keeps L in
// space and T to rounding at every step.
Propagator midpoint(const MethodStart& start);

// Strang splitting into exact rotations about the principal axes, order 2: symplectic, keeps L in
// space; with gravity, half a kick before and after.
Propagator splitting(const MethodStart& start);

// Preprocessed discrete Moser–Veselov algorithm of order 2, 4, 6, 8 or 10: keeps L in space and T
// to rounding at every step.
Propagator dmv(const MethodStart& start);

// The two invariants' functions that preprocess the moments of dmv: 1/Ĩ = (1+s)/I + d with
// s = Σ s[k] h^{2k+2}, d = Σ d[k] h^{2k+2}; k = 0…3. momentum and moments in principal axes.
struct MoserVeselovSeries {
    double s[4] = {0.0, 0.0, 0.0, 0.0};
    double d[4] = {0.0, 0.0, 0.0, 0.0};
};
MoserVeselovSeries moser_veselov_series(const Eigen::Vector3d& moments,
                                        const Eigen::Vector3d& momentum);

}  // namespace poinsot
