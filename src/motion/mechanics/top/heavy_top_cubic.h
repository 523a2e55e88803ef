// The cubic of Lagrange's top in wide double-double arithmetic: the first half of its setup.
//
// x = 1 − cos θ, y = 2 − x, β = 2Mgl/A, a = Cω3/A, and with the primed derivative in time
//   φ' sin²θ = d + a x,   e = d + 2a,   ω⊥² = γ + β x,
//   x'² = P(x) = x y (γ + β x) − (d + a x)² = (x1 − x)(x − x2)(β x + G),   G = −β x3,
// all with β ≥ 0, x3 ≤ 0 ≤ x2 ≤ x ≤ x1 ≤ 2. G in place of x3 makes β = 0 an ordinary case.
#pragma once

#include "numerics/wide_double.h"

namespace poinsot::top_setup {

inline int sign_of(const WideDouble& x) { return x < 0 ? -1 : 1; }

// The start with e3 along the symmetry axis, and β ≥ 0 after a possible reversal.
struct TopAtStart {
    WideDouble A, C, mgl;
    WideDouble qw, qx, qy, qz;  // unit
    WideDouble omega1, omega2, omega3;
};

// The same top with its body axes turned half a turn about e1, which makes e3 point the other way.
TopAtStart reversed(const TopAtStart& start);

// Everything about the cubic P.
struct Cubic {
    WideDouble x0, y0, x_dot;  // at the start
    WideDouble beta, a, d, e, gamma;
    WideDouble p0, p1, p2;  // P(x0 + w) = p0 + p1 w + p2 w² − β w³
    WideDouble x1, x2, y1, y2;
    WideDouble above, below;  // x1 − x0, x0 − x2
    WideDouble delta;         // x1 − x2
    WideDouble G, X;          // −β x3, β x2
    bool steady = false;
    bool unstable = false;  // steady at a maximum of the effective potential
};

// Finds the roots as distances from the start and as products, never as differences of large
// numbers. Precondition: mgl ≥ 0, a unit quaternion.
Cubic solve_cubic(const TopAtStart& start);

}  // namespace poinsot::top_setup
