#include "drawing/stage/type/clock_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot {

namespace {

constexpr int most_digits = 8;
constexpr int least_decimals = 2;
// The last digit changes at least this many times during a film.
constexpr double n_steps = 20.0;

int decimals_for(double span) {
    if (!(span > 0.0)) return least_decimals;
    // Even for the smallest spans, the number of decimals is finite.
    const double n_a_unit = std::min(n_steps / span, std::numeric_limits<double>::max());
    return std::max(least_decimals, static_cast<int>(std::ceil(std::log10(n_a_unit))));
}

int digits_before_the_point(double value) {
    return value < 1.0 ? 1 : 1 + static_cast<int>(std::floor(std::log10(value)));
}

}  // namespace

ClockText::ClockText(double first_s, double last_s) {
    const double largest_s = std::max(std::abs(first_s), std::abs(last_s));
    const double span_s = last_s > first_s ? last_s - first_s : largest_s;
    unit_ = time_unit_of(span_s);
    const auto n_before = [&] { return digits_before_the_point(largest_s / unit_.seconds); };
    n_decimals_ = decimals_for(span_s / unit_.seconds);
    // A short film at a late time has the unit of that time.
    if (n_before() + n_decimals_ > most_digits) {
        unit_ = time_unit_of(largest_s);
        n_decimals_ = std::clamp(decimals_for(span_s / unit_.seconds), least_decimals,
                                 std::max(least_decimals, most_digits - n_before()));
    }
    with_exponent_ =
        n_before() + least_decimals > most_digits ||
        (largest_s > 0.0 && largest_s / unit_.seconds < std::pow(10.0, 2 - most_digits));
}

std::string ClockText::format_in(double per_s) const {
    if (with_exponent_) return "g";
    const double n_decimals = std::ceil(n_decimals_ - std::log10(unit_.seconds * per_s) - 1e-9);
    constexpr double most = 15.0;  // of a double
    return fmt::format(".{}f", static_cast<int>(std::clamp(n_decimals, 0.0, most)));
}

std::string ClockText::at(double time_s) const {
    const double value = time_s / unit_.seconds;
    std::string digits =
        with_exponent_ ? fmt::format("{:.3e}", value) : fmt::format("{:.{}f}", value, n_decimals_);
    // A minus sign instead of a hyphen, as in printed formulas.
    for (std::size_t at = 0; (at = digits.find('-', at)) != std::string::npos;)
        digits.replace(at, 1, "\u2212");
    return fmt::format("$t$ = {} {}", digits, unit_.name);
}

}  // namespace poinsot
