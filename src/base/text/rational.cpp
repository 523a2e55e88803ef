#include "text/rational.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

namespace poinsot {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Cuts the digits off the front.
std::string_view take_digits(std::string_view& text) {
    const std::size_t n = static_cast<std::size_t>(
        std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
    const std::string_view digits = text.substr(0, n);
    text.remove_prefix(n);
    return digits;
}

// Removes an exponent such as "e-3" from the front and returns it. Returns 0 and leaves the text if
// it does not begin with an exponent.
std::int64_t take_exponent(std::string_view& text) {
    if (!text.starts_with('e') && !text.starts_with('E')) return 0;
    std::string_view rest = text.substr(1);
    const bool negative = rest.starts_with('-');
    if (negative || rest.starts_with('+')) rest.remove_prefix(1);
    const std::string_view digits = take_digits(rest);
    if (digits.empty()) return 0;
    text = rest;
    constexpr std::int64_t most = 1'000'000'000'000;  // more than any text has digits
    std::int64_t exponent = 0;
    for (const char digit : digits) exponent = std::min(10 * exponent + (digit - '0'), most);
    return negative ? -exponent : exponent;
}

// whole·2^exponent to the nearest double, ties to even. Precondition: whole has 56 or 57 bits, the
// last of which is 1 where anything but 0 was cut off behind it.
double rounded(std::uint64_t whole, int exponent) {
    constexpr int least_exponent = -1074;  // of the smallest double
    const int n_dropped =
        std::max(static_cast<int>(std::bit_width(whole)) - std::numeric_limits<double>::digits,
                 least_exponent - exponent);
    if (n_dropped >= 64) return 0.0;
    const std::uint64_t half = std::uint64_t{1} << (n_dropped - 1);
    const std::uint64_t dropped = whole & (2 * half - 1);
    std::uint64_t kept = whole >> n_dropped;
    if (dropped > half || (dropped == half && kept % 2 == 1)) ++kept;
    return std::ldexp(static_cast<double>(kept), exponent + n_dropped);
}

}  // namespace

double nearest_double(const Rational& number) {
    using boost::multiprecision::cpp_int;
    if (number.is_zero()) return 0.0;
    const double sign = number < 0 ? -1.0 : 1.0;
    cpp_int above = abs(numerator(number)), below = denominator(number);
    // Scaled by a power of 2 the quotient has 56 or 57 bits before its point.
    constexpr int n_bits = 57;
    const std::int64_t shift =
        n_bits - 1 + static_cast<std::int64_t>(msb(below)) - static_cast<std::int64_t>(msb(above));
    (shift > 0 ? above : below) <<= std::abs(shift);
    cpp_int whole, rest;
    divide_qr(above, below, whole, rest);
    return sign * rounded(static_cast<std::uint64_t>(whole) | (rest.is_zero() ? 0u : 1u),
                          static_cast<int>(-shift));
}

std::optional<Rational> take_decimal(std::string_view& text) {
    std::string_view rest = text;
    const bool negative = rest.starts_with('-');
    if (negative) rest.remove_prefix(1);
    std::string digits(take_digits(rest));
    std::size_t n_after_point = 0;
    if (rest.starts_with('.')) {
        rest.remove_prefix(1);
        const std::string_view after = take_digits(rest);
        n_after_point = after.size();
        digits += after;
    }
    if (digits.empty()) return std::nullopt;
    const std::int64_t n_given = static_cast<std::int64_t>(digits.size());
    const std::int64_t power = take_exponent(rest) - static_cast<std::int64_t>(n_after_point);

    // Zeros at either end are no digits of the number.
    Rational number = 0;
    const std::size_t first = digits.find_first_not_of('0');
    if (first != std::string::npos) {
        const std::size_t end = digits.find_last_not_of('0') + 1;
        constexpr std::size_t most_digits = 1000;
        constexpr std::int64_t most_exponent = 5000;
        const std::int64_t exponent = power + n_given - static_cast<std::int64_t>(end);
        const std::int64_t leading = power + n_given - static_cast<std::int64_t>(first);
        if (end - first > most_digits || std::abs(leading) > most_exponent) return std::nullopt;
        using boost::multiprecision::cpp_int;
        const cpp_int significant(digits.substr(first, end - first));
        const cpp_int scale = pow(cpp_int(10), static_cast<unsigned>(std::abs(exponent)));
        number = exponent > 0 ? Rational(significant * scale) : Rational(significant, scale);
        if (negative) number = -number;
    }
    text = rest;
    return number;
}

std::optional<Rational> rational_of(std::string_view text) {
    const auto number = take_decimal(text);
    return text.empty() ? number : std::nullopt;
}

Progression::Pair Progression::pair_of(const Rational& number) {
    const double high = nearest_double(number);
    if (!std::isfinite(high)) return {high, 0.0};
    return {high, nearest_double(number - Rational(high))};
}

Progression::Progression(const Rational& first, const Rational& step)
    : first_(first), step_(step), first_pair_(pair_of(first)), step_pair_(pair_of(step)) {}

// Ziv's strategy: first with some 100 bits, and exactly if these do not determine the rounding.
// Source: Ziv, ACM TOMS 17 (1991) 410.
double Progression::at(std::int64_t k) const {
    const double n = static_cast<double>(k);
    const double product = n * step_pair_.high;
    const double product_low = std::fma(n, step_pair_.high, -product) + n * step_pair_.low;
    const double sum = first_pair_.high + product;
    const double product_in_sum = sum - first_pair_.high;
    const double sum_low = (first_pair_.high - (sum - product_in_sum)) + (product - product_in_sum);
    const double low = sum_low + (product_low + first_pair_.low);
    // The low parts are rounded a few times at 2^-106 of the terms; products below 1e-290 would
    // lose theirs to underflow.
    const double size = std::abs(first_pair_.high) + std::abs(product);
    const double error = 0x1p-100 * size;
    const bool in_range = size > 1e-250 && size < 1e300;
    if (in_range && sum + (low - error) == sum + (low + error)) return sum + low;
    return nearest_double(first_ + k * step_);
}

}  // namespace poinsot
