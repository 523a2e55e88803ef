#include "text/rational.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

namespace poinsot {

namespace {

constexpr int word_bits = 32;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Cuts the digits off the front.
std::string_view take_digits(std::string_view& text) {
    const std::size_t n = static_cast<std::size_t>(
        std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
    const std::string_view digits = text.substr(0, n);
    text.remove_prefix(n);
    return digits;
}

// Cuts an exponent such as "e-3" off the front; what is none is left there, and 0.
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

Natural::Natural(std::uint64_t value) {
    for (; value != 0; value >>= word_bits) words_.push_back(static_cast<std::uint32_t>(value));
}

Natural Natural::power_of_ten(int exponent) {
    constexpr std::uint32_t ten_to_9 = 1'000'000'000;
    Natural power(1);
    for (; exponent >= 9; exponent -= 9) power.multiply_add(ten_to_9, 0);
    for (; exponent > 0; --exponent) power.multiply_add(10, 0);
    return power;
}

int Natural::bit_width() const {
    if (words_.empty()) return 0;
    return word_bits * (static_cast<int>(words_.size()) - 1) +
           static_cast<int>(std::bit_width(words_.back()));
}

void Natural::trim() {
    while (!words_.empty() && words_.back() == 0) words_.pop_back();
}

Natural Natural::shifted_left(int bits) const {
    Natural shifted;
    if (is_zero()) return shifted;
    shifted.words_.assign(static_cast<std::size_t>(bits / word_bits), 0);
    std::uint64_t carry = 0;
    for (const std::uint32_t word : words_) {
        carry |= std::uint64_t{word} << (bits % word_bits);
        shifted.words_.push_back(static_cast<std::uint32_t>(carry));
        carry >>= word_bits;
    }
    shifted.words_.push_back(static_cast<std::uint32_t>(carry));
    shifted.trim();
    return shifted;
}

void Natural::multiply_add(std::uint32_t factor, std::uint32_t addend) {
    std::uint64_t carry = addend;
    for (std::uint32_t& word : words_) {
        carry += std::uint64_t{word} * factor;
        word = static_cast<std::uint32_t>(carry);
        carry >>= word_bits;
    }
    if (carry != 0) words_.push_back(static_cast<std::uint32_t>(carry));
}

Natural operator+(const Natural& a, const Natural& b) {
    Natural sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < std::max(a.words_.size(), b.words_.size()); ++i) {
        if (i < a.words_.size()) carry += a.words_[i];
        if (i < b.words_.size()) carry += b.words_[i];
        sum.words_.push_back(static_cast<std::uint32_t>(carry));
        carry >>= word_bits;
    }
    if (carry != 0) sum.words_.push_back(static_cast<std::uint32_t>(carry));
    return sum;
}

Natural operator-(const Natural& a, const Natural& b) {
    assert(!(a < b));
    Natural difference = a;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < difference.words_.size(); ++i) {
        const std::uint64_t subtracted = (i < b.words_.size() ? b.words_[i] : 0) + borrow;
        std::uint32_t& word = difference.words_[i];
        borrow = word < subtracted ? 1 : 0;
        word = static_cast<std::uint32_t>(word - subtracted);
    }
    difference.trim();
    return difference;
}

Natural operator*(const Natural& a, const Natural& b) {
    Natural product;
    product.words_.assign(a.words_.size() + b.words_.size(), 0);
    for (std::size_t i = 0; i < a.words_.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.words_.size(); ++j) {
            carry += product.words_[i + j] + std::uint64_t{a.words_[i]} * b.words_[j];
            product.words_[i + j] = static_cast<std::uint32_t>(carry);
            carry >>= word_bits;
        }
        product.words_[i + b.words_.size()] = static_cast<std::uint32_t>(carry);
    }
    product.trim();
    return product;
}

bool operator<(const Natural& a, const Natural& b) {
    if (a.words_.size() != b.words_.size()) return a.words_.size() < b.words_.size();
    return std::lexicographical_compare(a.words_.rbegin(), a.words_.rend(), b.words_.rbegin(),
                                        b.words_.rend());
}

Rational::Rational(std::int64_t whole)
    : negative_(whole < 0),
      above_(whole < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(whole)
                       : static_cast<std::uint64_t>(whole)) {}

double Rational::nearest() const {
    const double sign = negative_ ? -1.0 : 1.0;
    if (is_zero()) return 0.0;
    // Far beyond double's range no digit is needed: 2^1100 and 2^-1100 are.
    const double log2_of_it = above_.bit_width() - below_.bit_width() + exponent_ * std::log2(10.0);
    if (log2_of_it > 1100.0) return sign * std::numeric_limits<double>::infinity();
    if (log2_of_it < -1100.0) return sign * 0.0;

    Natural above = above_, below = below_;
    Natural& scaled = exponent_ > 0 ? above : below;
    scaled = scaled * Natural::power_of_ten(std::abs(exponent_));
    // Long division in binary, from a quotient between 1/2 and 2.
    const int shift = below.bit_width() - above.bit_width();
    Natural& smaller = shift > 0 ? above : below;
    smaller = smaller.shifted_left(std::abs(shift));
    constexpr int n_bits = 57;
    std::uint64_t whole = 0;
    for (int i = 0; i < n_bits; ++i) {
        const bool bit = !(above < below);
        if (bit) above = above - below;
        above.multiply_add(2, 0);
        whole = 2 * whole + (bit ? 1 : 0);
    }
    if (!above.is_zero()) whole |= 1;
    return sign * rounded(whole, 1 - n_bits - shift);
}

Rational Rational::of_double(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    exponent -= std::numeric_limits<double>::digits;
    Rational number(
        static_cast<std::int64_t>(std::ldexp(mantissa, std::numeric_limits<double>::digits)));
    Natural& scaled = exponent > 0 ? number.above_ : number.below_;
    scaled = scaled.shifted_left(std::abs(exponent));
    return number;
}

Rational Rational::operator-() const {
    Rational negated = *this;
    negated.negative_ = !negative_ && !is_zero();
    return negated;
}

Rational operator+(const Rational& a, const Rational& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    Rational sum;
    sum.exponent_ = std::min(a.exponent_, b.exponent_);
    Natural a_above = a.above_ * Natural::power_of_ten(a.exponent_ - sum.exponent_);
    Natural b_above = b.above_ * Natural::power_of_ten(b.exponent_ - sum.exponent_);
    sum.below_ = a.below_;
    if (!(a.below_ == b.below_)) {
        a_above = a_above * b.below_;
        b_above = b_above * a.below_;
        sum.below_ = a.below_ * b.below_;
    }
    if (a.negative_ == b.negative_) {
        sum.negative_ = a.negative_;
        sum.above_ = a_above + b_above;
    } else {
        const bool a_is_less = a_above < b_above;
        sum.above_ = a_is_less ? b_above - a_above : a_above - b_above;
        sum.negative_ = !sum.is_zero() && (a_is_less ? b.negative_ : a.negative_);
    }
    return sum;
}

Rational operator*(const Rational& a, const Rational& b) {
    Rational product;
    if (a.is_zero() || b.is_zero()) return product;
    product.negative_ = a.negative_ != b.negative_;
    product.above_ = a.above_ * b.above_;
    product.below_ = a.below_ * b.below_;
    product.exponent_ = a.exponent_ + b.exponent_;
    return product;
}

Rational operator/(const Rational& a, const Rational& b) {
    assert(!b.is_zero());
    Rational inverse;
    inverse.negative_ = b.negative_;
    inverse.above_ = b.below_;
    inverse.below_ = b.above_;
    inverse.exponent_ = -b.exponent_;
    return a * inverse;
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
    Rational number;
    const std::size_t first = digits.find_first_not_of('0');
    if (first != std::string::npos) {
        const std::size_t end = digits.find_last_not_of('0') + 1;
        constexpr std::size_t most_digits = 1000;
        constexpr std::int64_t most_exponent = 5000;
        const std::int64_t exponent = power + n_given - static_cast<std::int64_t>(end);
        const std::int64_t leading = power + n_given - static_cast<std::int64_t>(first);
        if (end - first > most_digits || std::abs(leading) > most_exponent) return std::nullopt;
        for (std::size_t i = first; i < end; ++i)
            number.above_.multiply_add(10, static_cast<std::uint32_t>(digits[i] - '0'));
        number.negative_ = negative;
        number.exponent_ = static_cast<int>(exponent);
    }
    text = rest;
    return number;
}

std::optional<Rational> rational_of(std::string_view text) {
    const auto number = take_decimal(text);
    return text.empty() ? number : std::nullopt;
}

Progression::Pair Progression::pair_of(const Rational& number) {
    const double high = number.nearest();
    if (!std::isfinite(high)) return {high, 0.0};
    return {high, (number - Rational::of_double(high)).nearest()};
}

Progression::Progression(const Rational& first, const Rational& step)
    : first_(first), step_(step), first_pair_(pair_of(first)), step_pair_(pair_of(step)) {}

// Ziv's strategy: in some 100 bits first, and exactly where those do not tell how to round.
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
    return (first_ + Rational(k) * step_).nearest();
}

}  // namespace poinsot
