// Elementary functions of wide double-double numbers, with relative errors below 1e-29: for tops
// and theta series.
#pragma once

#include "numerics/wide_double.h"

namespace poinsot {

// e^x. Precondition: |x| < 2^30.
WideDouble exp(const WideDouble& x);

struct WideSinCos {
    WideDouble sin, cos;
};
// Sine and cosine of x rad. Precondition: |x| < 2^30. Near a zero the error is that of π rounded to
// 160 bits.
WideSinCos sin_cos(const WideDouble& x);
// sinh x and cosh x. Precondition: |x| < 2^30.
WideSinCos sinh_cosh(const WideDouble& x);

// The polar angle of (x, y) in (−π, π], in rad; 0 for (0, 0).
WideDouble atan2(const WideDouble& y, const WideDouble& x);

// x^n. Precondition: n ≥ 0.
WideDouble power(const WideDouble& x, int n);

}  // namespace poinsot
