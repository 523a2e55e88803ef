// Rational numbers of any size: what decimals, fractions and units of measure say, exactly, until
// one rounding makes a double of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace poinsot {

// A natural number of any size, as the digits of Rational.
class Natural {
 public:
    Natural(std::uint64_t value = 0);  // NOLINT(google-explicit-constructor): 2 * n reads as it is
    static Natural power_of_ten(int exponent);

    bool is_zero() const { return words_.empty(); }
    int bit_width() const;

    Natural shifted_left(int bits) const;
    // *this · factor + addend, in place.
    void multiply_add(std::uint32_t factor, std::uint32_t addend);
    friend Natural operator+(const Natural& a, const Natural& b);
    // Precondition: a ≥ b.
    friend Natural operator-(const Natural& a, const Natural& b);
    friend Natural operator*(const Natural& a, const Natural& b);
    friend bool operator<(const Natural& a, const Natural& b);
    friend bool operator==(const Natural& a, const Natural& b) = default;

 private:
    void trim();
    std::vector<std::uint32_t> words_;  // the lowest first, none that is 0 at the end
};

class Rational {
 public:
    Rational(std::int64_t whole = 0);  // NOLINT(google-explicit-constructor): 1 / r as in formulas
    // A finite double, exactly.
    static Rational of_double(double value);

    bool is_zero() const { return above_.is_zero(); }
    bool is_negative() const { return negative_; }
    // The nearest double, of two equally near the one whose last bit is 0; infinite beyond the
    // largest.
    double nearest() const;

    Rational operator-() const;
    friend Rational operator+(const Rational& a, const Rational& b);
    friend Rational operator-(const Rational& a, const Rational& b) { return a + (-b); }
    friend Rational operator*(const Rational& a, const Rational& b);
    // Precondition: b is not 0.
    friend Rational operator/(const Rational& a, const Rational& b);

 private:
    friend std::optional<Rational> take_decimal(std::string_view& text);

    // ± above / below · 10^exponent
    bool negative_ = false;
    Natural above_, below_{1};
    int exponent_ = 0;
};

// Cuts a decimal such as "-1.5e3" off the front of the text, as std::from_chars reads one. Nothing
// where there is none, where it has more than a thousand significant digits, or where it is
// neither 0 nor between 10^-5000 and 10^5000.
std::optional<Rational> take_decimal(std::string_view& text);

// A decimal that is all of the text; otherwise as take_decimal.
std::optional<Rational> rational_of(std::string_view text);

// The numbers first + k·step, each rounded once.
class Progression {
 public:
    Progression(const Rational& first, const Rational& step);

    // The double nearest to first + k·step.
    double at(std::int64_t k) const;

 private:
    // The nearest sum of two doubles, high + low.
    struct Pair {
        double high, low;
    };
    static Pair pair_of(const Rational& number);

    Rational first_, step_;
    Pair first_pair_, step_pair_;
};

}  // namespace poinsot
