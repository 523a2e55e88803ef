#include "numerics/wide_functions.h"

#include <cmath>

#include "numerics/elliptic_integrals.h"

namespace poinsot {

namespace {

// For |x| below 2^−60, the next term of every series here is below 2^−120 of the first.
constexpr int tiny = -60;
bool is_tiny(const WideDouble& x) { return x.is_zero() || x.exponent() < tiny; }

// e^x = (1 + rest)·2^exponent with |x − exponent·ln 2| ≤ ½ ln 2. Precondition: x is not tiny.
struct ExpParts {
    DoubleDouble rest;
    int exponent;
};
ExpParts exp_parts(DoubleDouble x) {
    const double n = std::nearbyint(x.hi / ln2_dd.hi);
    return {exp_minus_one(x - ln2_dd * n), static_cast<int>(n)};
}

}  // namespace

WideDouble exp(const WideDouble& x) {
    if (is_tiny(x)) return WideDouble(1.0) + x;
    const ExpParts parts = exp_parts(x.double_double());
    return WideDouble(parts.rest + 1.0, parts.exponent);
}

WideSinCos sinh_cosh(const WideDouble& x) {
    if (is_tiny(x)) return {x, 1.0};
    const ExpParts parts = exp_parts(abs(x).double_double());
    const WideDouble grown(parts.rest + 1.0, parts.exponent);
    const WideDouble shrunk = WideDouble(1.0) / grown;
    // Where e^x is near 1, use e^x − 1: no digits cancel.
    const WideDouble sinh = parts.exponent == 0 ? ldexp(WideDouble(parts.rest) * (shrunk + 1.0), -1)
                                                : ldexp(grown - shrunk, -1);
    return {x.sign() < 0 ? -sinh : sinh, ldexp(grown + shrunk, -1)};
}

WideSinCos sin_cos(const WideDouble& x) {
    if (is_tiny(x)) return {x, 1.0};
    const DoubleDouble value = x.double_double();
    // Subtracts whole quarter turns, so that no digits cancel near a zero of sine or cosine.
    const double n = std::nearbyint(value.hi / (0.5 * pi_dd.hi));
    DoubleDouble rest = value;
    if (n != 0.0) {
        constexpr double third_word_of_pi = -0x1.f1976b7ed8fbcp-109;
        rest = rest - two_product(0.5 * n, pi_dd.hi);
        rest = rest - two_product(0.5 * n, pi_dd.lo);
        rest = rest - DoubleDouble(0.5 * n * third_word_of_pi);
    }
    const SinCosDD turn = sin_cos(rest);
    const WideDouble s(turn.sin), c(turn.cos);
    switch (static_cast<long long>(n) & 3) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

WideDouble atan2(const WideDouble& y, const WideDouble& x) {
    if (y.is_zero() && x.is_zero()) return 0.0;
    const WideDouble quarter = ldexp(WideDouble(pi_dd), -1);
    if (x.is_zero() || (!y.is_zero() && x.exponent() < y.exponent() + tiny))
        return (y.sign() < 0 ? -quarter : quarter) - x / y;
    if (y.is_zero() || y.exponent() < x.exponent() + tiny) {
        const WideDouble turn = ldexp(y.sign() < 0 ? -quarter : quarter, 1);
        return x.sign() > 0 ? y / x : turn + y / x;
    }
    // The angle in double, and the remainder: it is below 2^−50, so that its cube is negligible.
    const double near = std::atan2(y.over_power_of_two(x.exponent()).rounded(),
                                   x.over_power_of_two(x.exponent()).rounded());
    const WideSinCos turn = sin_cos(WideDouble(near));
    return (y * turn.cos - x * turn.sin) / (x * turn.cos + y * turn.sin) + near;
}

WideDouble power(const WideDouble& x, int n) {
    WideDouble result = 1.0;
    WideDouble square = x;
    for (; n > 0; n /= 2) {
        if (n % 2 == 1) result = result * square;
        square = square * square;
    }
    return result;
}

}  // namespace poinsot
