// Scaling by powers of two, which rounds nothing: squares and products of what is brought to order
// one neither over- nor underflow.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace poinsot {

// The exponent e with 2^(e−1) ≤ |x| < 2^e; 0 for zero.
inline int exponent_of(double x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return exponent;
}
// That of the largest element.
template <typename Derived>
int exponent_of(const Eigen::MatrixBase<Derived>& x) {
    return exponent_of(x.derived().cwiseAbs().maxCoeff());
}

// x·2^exponent, element by element.
template <typename Derived>
typename Derived::PlainObject ldexp(const Eigen::MatrixBase<Derived>& x, int exponent) {
    return x.derived().unaryExpr(
        [exponent](double element) { return std::ldexp(element, exponent); });
}

// |x| with the digits of x.norm(), also where that over- or underflows.
template <typename Derived>
double norm_of(const Eigen::MatrixBase<Derived>& x) {
    const int exponent = exponent_of(x);
    return std::ldexp(ldexp(x, -exponent).norm(), exponent);
}

}  // namespace poinsot
