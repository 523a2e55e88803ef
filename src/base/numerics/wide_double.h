// Double-double numbers with a separate integer exponent, for setting up a motion: with wobbles of
// 1e-300, squares and ratios neither underflow nor lose a digit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "numerics/double_double.h"

namespace poinsot {

// The value significand·2^exponent, ½ ≤ |significand| < 1 or zero.
class WideDouble {
 public:
    WideDouble() = default;
    // The implicit conversion from double lets mixed expressions read as in the formulas.
    WideDouble(double value) : WideDouble(DoubleDouble(value), 0) {}  // NOLINT(*-explicit-*)
    explicit WideDouble(DoubleDouble value, int exponent = 0) {
        if (value.hi == 0.0) return;
        int shift = 0;
        std::frexp(value.hi, &shift);
        significand_ = poinsot::ldexp(value, -shift);
        exponent_ = exponent + shift;
    }

    bool is_finite() const { return std::isfinite(significand_.hi); }
    bool is_zero() const { return significand_.hi == 0.0; }
    int sign() const { return (significand_.hi > 0.0) - (significand_.hi < 0.0); }
    // The exponent e with 2^(e−1) ≤ |value| < 2^e; 0 for zero.
    int exponent() const { return exponent_; }
    DoubleDouble significand() const { return significand_; }

    // value / 2^scale; overflows and underflows as doubles do.
    DoubleDouble over_power_of_two(int scale) const {
        return ldexp(significand_, exponent_ - scale);
    }
    DoubleDouble double_double() const { return over_power_of_two(0); }
    double rounded() const { return std::ldexp(significand_.rounded(), exponent_); }
    // The value rounded to double's 53 bits, without double's range.
    WideDouble rounded_to_53_bits() const {
        return WideDouble(DoubleDouble(significand_.rounded()), exponent_);
    }

    friend WideDouble operator-(const WideDouble& a) {
        return from_parts(-a.significand_, a.exponent_);
    }
    friend WideDouble operator+(const WideDouble& a, const WideDouble& b) {
        if (a.is_zero()) return b;
        if (b.is_zero()) return a;
        if (a.exponent_ < b.exponent_) return b + a;
        const int shift = b.exponent_ - a.exponent_;
        if (shift < -220) return a;
        return normalised(a.significand_ + scaled(b.significand_, shift), a.exponent_);
    }
    friend WideDouble operator-(const WideDouble& a, const WideDouble& b) { return a + (-b); }
    friend WideDouble operator*(const WideDouble& a, const WideDouble& b) {
        return normalised(a.significand_ * b.significand_, a.exponent_ + b.exponent_);
    }
    // Precondition: b ≠ 0.
    friend WideDouble operator/(const WideDouble& a, const WideDouble& b) {
        return normalised(a.significand_ / b.significand_, a.exponent_ - b.exponent_);
    }
    friend bool operator<(const WideDouble& a, const WideDouble& b) { return (a - b).sign() < 0; }
    friend bool operator>(const WideDouble& a, const WideDouble& b) { return b < a; }
    friend bool operator<=(const WideDouble& a, const WideDouble& b) { return !(b < a); }
    friend bool operator>=(const WideDouble& a, const WideDouble& b) { return !(a < b); }
    friend bool operator==(const WideDouble& a, const WideDouble& b) { return (a - b).is_zero(); }

    friend WideDouble abs(const WideDouble& a) { return a.sign() < 0 ? -a : a; }
    // Precondition: a ≥ 0.
    friend WideDouble sqrt(const WideDouble& a) {
        const int odd = a.exponent_ & 1;
        return normalised(sqrt(scaled(a.significand_, odd)), (a.exponent_ - odd) / 2);
    }
    friend WideDouble ldexp(const WideDouble& a, int exponent) {
        return a.is_zero() ? a : from_parts(a.significand_, a.exponent_ + exponent);
    }

 private:
    static WideDouble from_parts(DoubleDouble significand, int exponent) {
        WideDouble result;
        result.significand_ = significand;
        result.exponent_ = exponent;
        return result;
    }
    // x·2^exponent for −1022 ≤ exponent ≤ 1023.
    static DoubleDouble scaled(DoubleDouble x, int exponent) {
        const double power =
            std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52U);
        return {x.hi * power, x.lo * power};
    }
    // from_parts for the result of an operation on normal numbers: reads the exponent from the
    // bits.
    static WideDouble normalised(DoubleDouble value, int exponent) {
        if (value.hi == 0.0) return {};
        const auto bits = std::bit_cast<std::uint64_t>(value.hi);
        const int shift = static_cast<int>((bits >> 52U) & 0x7ffU) - 1022;
        return from_parts(scaled(value, -shift), exponent + shift);
    }

    DoubleDouble significand_;
    int exponent_ = 0;
};

inline WideDouble square(const WideDouble& a) { return a * a; }

}  // namespace poinsot
