// Rational numbers of any size: what decimals, fractions and units of measure say, exactly, until
// one rounding makes a double of it.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <string_view>

namespace poinsot {

// A fraction of integers of any size.
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational::backend_type,
                                               boost::multiprecision::et_off>;

// The nearest double; of two equally near ones, the one whose last bit is 0; infinite beyond the
// largest.
double nearest_double(const Rational& number);

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
