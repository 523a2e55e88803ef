// Elementary functions of wide double-double numbers, relative errors below 1e-29: for tops and
// theta series.
#pragma once

#include "numerics/wide_double.h"

namespace poinsot {

// Precondition: |x| < 2^30.
WideDouble exp(const WideDouble& x);

struct WideSinCos {
    WideDouble sin, cos;
};
// Of x rad, |x| < 2^30; near a zero the error is that of π to 160 bits.
WideSinCos sin_cos(const WideDouble& x);
// sinh x and cosh x, |x| < 2^30.
WideSinCos sinh_cosh(const WideDouble& x);

// The angle of (x, y) in (−π, π]; 0 for (0, 0).
WideDouble atan2(const WideDouble& y, const WideDouble& x);

// x^n, n ≥ 0.
WideDouble power(const WideDouble& x, int n);

}  // namespace poinsot
