#include "numerics/elliptic_integrals.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "error/error.h"

namespace poinsot {

namespace {

// Each step of the means halves the difference of the exponents, or at least doubles the digits
// that agree (Carlson's gains two bits): even exponents of 2^20 take fewer. More steps are those of
// arguments outside of a function's domain.
constexpr int most_steps = 64;

[[noreturn]] void refuse_arguments() {
    throw InputError(
        "an elliptic integral of this motion has no value: the motion's numbers lie beyond the "
        "range of double-precision numbers; choose other units");
}

// Of NaN no comparison ends a loop.
void require_finite(std::initializer_list<WideDouble> arguments) {
    for (const WideDouble& x : arguments)
        if (!x.is_finite()) refuse_arguments();
}

}  // namespace

WideDouble complete_first_kind(const WideDouble& complementary_modulus) {
    require_finite({complementary_modulus});
    WideDouble a = 1.0;
    WideDouble g = complementary_modulus;
    for (int step = 0; step < most_steps; ++step) {
        // Each step squares the relative difference: once it is below 2^−54, the next step is
        // exact.
        const WideDouble gap = a - g;
        if (gap.is_zero() || gap.exponent() <= a.exponent() - 54)
            return WideDouble(pi_dd) / (a + g);
        const WideDouble mean = ldexp(a + g, -1);
        g = sqrt(a * g);
        a = mean;
    }
    refuse_arguments();
}

WideDouble bulirsch_cel(const WideDouble& complementary_modulus, const WideDouble& p,
                        const WideDouble& a, const WideDouble& b) {
    require_finite({complementary_modulus, p, a, b});
    WideDouble kc = complementary_modulus;
    WideDouble e = kc;
    WideDouble m = 1.0;
    WideDouble p_n = sqrt(p);
    WideDouble a_n = a;
    WideDouble b_n = b / p_n;
    for (int step = 0; step < most_steps; ++step) {
        const WideDouble f = a_n;
        a_n = a_n + b_n / p_n;
        const WideDouble g = e / p_n;
        b_n = ldexp(b_n + f * g, 1);
        p_n = p_n + g;
        const WideDouble m_before = m;
        m = m + kc;
        const WideDouble gap = m_before - kc;
        if (gap.is_zero() || gap.exponent() < m_before.exponent() - 54)
            return ldexp(WideDouble(pi_dd), -1) * (b_n + a_n * m) / (m * (m + p_n));
        kc = ldexp(sqrt(e), 1);
        e = kc * m;
    }
    refuse_arguments();
}

WideDouble carlson_rf(WideDouble x, WideDouble y, WideDouble z) {
    require_finite({x, y, z});
    const WideDouble third = WideDouble(1.0) / 3.0;
    for (int step = 0; step < most_steps; ++step) {
        const WideDouble mean = (x + y + z) * third;
        const WideDouble X = (mean - x) / mean;
        const WideDouble Y = (mean - y) / mean;
        const WideDouble Z = -(X + Y);
        const auto size_of = [](const WideDouble& w) { return w.is_zero() ? -1000 : w.exponent(); };
        const int size = std::max({size_of(X), size_of(Y), size_of(Z)});
        // The series to the seventh order has an error below (2^−14)^8.
        if (size <= -14) {
            const WideDouble e2 = X * Y - Z * Z;
            const WideDouble e3 = X * Y * Z;
            const WideDouble series = WideDouble(1.0) - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 -
                                      e2 * e3 * 3.0 / 44.0 - e2 * e2 * e2 * 5.0 / 208.0 +
                                      e3 * e3 * 3.0 / 104.0 + e2 * e2 * e3 / 16.0;
            return series / sqrt(mean);
        }
        const WideDouble sx = sqrt(x);
        const WideDouble sy = sqrt(y);
        const WideDouble sz = sqrt(z);
        const WideDouble lambda = sx * (sy + sz) + sy * sz;
        x = ldexp(x + lambda, -2);
        y = ldexp(y + lambda, -2);
        z = ldexp(z + lambda, -2);
    }
    refuse_arguments();
}

DoubleDouble exp(DoubleDouble x) {
    if (x.hi < -760.0) return 0.0;
    const double n = std::nearbyint(x.hi / ln2_dd.hi);
    return ldexp(exp_minus_one(x - ln2_dd * n) + 1.0, static_cast<int>(n));
}

DoubleDouble exp_minus_one(DoubleDouble x) {
    // The Taylor series of x/2^8, then eight squarings.
    const DoubleDouble r = ldexp(x, -8);
    DoubleDouble term = r;
    DoubleDouble sum = r;
    for (int k = 2; k <= 10; ++k) {
        term = term * r / DoubleDouble(static_cast<double>(k));
        sum = sum + term;
    }
    // With s = e^r − 1, squaring e^r takes s to s(2 + s): no digit is lost to the leading 1.
    for (int k = 0; k < 8; ++k) sum = sum * (sum + 2.0);
    return sum;
}

SinCosDD sin_cos(DoubleDouble x) {
    // Taylor series of x/8, then three doublings of the angle with versed cosine 1 − cos.
    const DoubleDouble y = ldexp(x, -3);
    const DoubleDouble y2 = y * y;
    DoubleDouble sin_term = y;
    DoubleDouble sine = y;
    DoubleDouble versed_term = y2 * 0.5;
    DoubleDouble versed = versed_term;
    for (int k = 1; k <= 12; ++k) {
        const double n = 2.0 * k;
        sin_term = -(sin_term * y2) / DoubleDouble(n * (n + 1.0));
        versed_term = -(versed_term * y2) / DoubleDouble((n + 1.0) * (n + 2.0));
        sine = sine + sin_term;
        versed = versed + versed_term;
    }
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble cosine = DoubleDouble(1.0) - versed;
        versed = sine * sine * 2.0;
        sine = sine * cosine * 2.0;
    }
    return {sine, DoubleDouble(1.0) - versed};
}

}  // namespace poinsot
