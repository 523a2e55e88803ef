// Arithmetic in pairs of doubles: a value is the unevaluated sum hi + lo, |lo| ≤ ½ ulp(hi), with
// about 106 bits. Used where the setup of a motion would lose digits by cancellation in double.
//
// Sources: Dekker, Numer. Math. 18 (1971) 224; Knuth, TAOCP 2 §4.2.2; Joldes, Muller & Popescu, ACM
// TOMS 44 (2017) 15. Every operation relies on IEEE rounding to nearest without contraction.
#pragma once

#include <cfloat>
#include <cmath>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "poinsot's mechanics needs IEEE arithmetic: do not compile it with -ffast-math"
#endif
#if FLT_EVAL_METHOD != 0
#error "poinsot's mechanics needs doubles without excess precision: use SSE2, not the x87"
#endif

namespace poinsot {

// A value hi + lo with twice double's precision and the same exponent range.
struct DoubleDouble {
    double hi = 0.0;
    double lo = 0.0;

    constexpr DoubleDouble() = default;
    // The implicit conversion from double lets mixed expressions read as in the formulas.
    constexpr DoubleDouble(double value) : hi(value) {}  // NOLINT(google-explicit-constructor)
    constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}

    constexpr double rounded() const { return hi + lo; }
};

// a + b exactly, for |a| ≥ |b| or a = 0 (Dekker).
constexpr DoubleDouble fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

// a + b exactly (Knuth).
constexpr DoubleDouble two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// Veltkamp's split of a into two halves of 26 bits; precondition: |a| < 2^996.
constexpr DoubleDouble split(double a) {
    const double t = 134217729.0 * a;  // 2^27 + 1
    const double high = t - (t - a);
    return {high, a - high};
}

// a·b exactly unless the low part underflows (Dekker); no fused multiply-add, so that the digits
// are the same on every processor.
constexpr DoubleDouble two_product(double a, double b) {
    const double product = a * b;
    const DoubleDouble x = split(a);
    const DoubleDouble y = split(b);
    return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

// The relative error is ≤ 3·2^−106, also under cancellation (Joldes et al., algorithm 6).
constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = two_sum(a.hi, b.hi);
    const DoubleDouble t = two_sum(a.lo, b.lo);
    const DoubleDouble v = fast_two_sum(s.hi, s.lo + t.hi);
    return fast_two_sum(v.hi, t.lo + v.lo);
}
constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = two_product(a.hi, b.hi);
    return fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.hi / b.hi;
    const DoubleDouble remainder = a - b * first;
    const double second = remainder.hi / b.hi;
    const DoubleDouble rest = remainder - b * second;
    return fast_two_sum(first, second) + rest.hi / b.hi;
}

constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
    return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}
constexpr bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }

constexpr DoubleDouble abs(DoubleDouble a) { return a.hi < 0.0 ? -a : a; }

// Precondition: a ≥ 0.
inline DoubleDouble sqrt(DoubleDouble a) {
    if (!(a.hi > 0.0)) return 0.0;
    const double root = std::sqrt(a.hi);
    const DoubleDouble rest = a - two_product(root, root);
    return fast_two_sum(root, rest.hi / (2.0 * root));
}

// a·2^exponent.
inline DoubleDouble ldexp(DoubleDouble a, int exponent) {
    return {std::ldexp(a.hi, exponent), std::ldexp(a.lo, exponent)};
}

}  // namespace poinsot
