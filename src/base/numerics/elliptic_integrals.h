// Elliptic integrals in wide double-double, and the elementary functions that theta series need.
// Every integral takes the complementary modulus k′, or arguments computed from it, so that no
// digits cancel near k = 1. Relative errors are below 1e-29. Integrals throw InputError for
// arguments that are not finite, and for those of their domain's edge, where they are infinite.
#pragma once

#include "numerics/wide_double.h"

namespace poinsot {

// π and ln 2 to 107 bits.
inline constexpr DoubleDouble pi_dd{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble ln2_dd{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// K = ∫dφ/√(cos²φ + k′²sin²φ) over a quarter turn, by the arithmetic-geometric mean. Precondition:
// k′ > 0. Source: DLMF 19.8.5.
WideDouble complete_first_kind(const WideDouble& complementary_modulus);

// ∫(a cos²φ + b sin²φ)/((cos²φ + p sin²φ)√(cos²φ + k′²sin²φ)) dφ over a quarter turn. Precondition:
// k′, p > 0; a, b ≥ 0. Source: Bulirsch, Numer. Math. 13 (1969) 305.
WideDouble bulirsch_cel(const WideDouble& complementary_modulus, const WideDouble& p,
                        const WideDouble& a, const WideDouble& b);

// Carlson's symmetric integral R_F(x, y, z). Precondition: at most one argument is zero. Source:
// DLMF 19.36(i).
WideDouble carlson_rf(WideDouble x, WideDouble y, WideDouble z);

// e^x − 1 for |x| ≤ ½ ln 2.
DoubleDouble exp_minus_one(DoubleDouble x);
// exp(x); returns zero where the result underflows in double.
DoubleDouble exp(DoubleDouble x);

struct SinCosDD {
    DoubleDouble sin;
    DoubleDouble cos;
};
// sin and cos of x rad for |x| ≤ π.
SinCosDD sin_cos(DoubleDouble x);

}  // namespace poinsot
