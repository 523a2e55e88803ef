#include "text/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace poinsot {

namespace {

// Whether a decimal that is out of double's range is too small for it rather than too large: by the
// place of its first digit before or behind the point, and its exponent.
bool is_too_small(std::string_view decimal) {
    const std::size_t e = std::min(decimal.find_first_of("eE"), decimal.size());
    const std::string_view digits = decimal.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::int64_t place = static_cast<std::int64_t>(point) -
                               static_cast<std::int64_t>(digits.find_first_of("123456789"));
    if (e == decimal.size()) return place < 0;
    const std::string_view power = without_plus(decimal.substr(e + 1));
    const auto exponent = number_of<std::int64_t>(power);
    return exponent ? *exponent < -place : power.starts_with('-');
}

#ifdef __cpp_lib_to_chars
std::from_chars_result decimal_at_front(std::string_view text, double& number) {
    return std::from_chars(text.data(), text.data() + text.size(), number);
}
#else
// For a library whose from_chars lacks doubles, as libc++ 19: strtod, which musl rounds to the
// nearest as well, of the text that from_chars would take.
std::from_chars_result decimal_at_front(std::string_view text, double& number) {
    const auto n_digits_at = [text](std::size_t from) {
        return std::min(text.find_first_not_of("0123456789", from), text.size()) - from;
    };
    std::size_t end = text.starts_with('-') ? 1 : 0;
    for (const auto& [name, value] : {std::pair<std::string_view, double>{"infinity", HUGE_VAL},
                                      {"inf", HUGE_VAL},
                                      {"nan", std::numeric_limits<double>::quiet_NaN()}}) {
        const std::string_view given = text.substr(end, name.size());
        const bool is_named = std::equal(given.begin(), given.end(), name.begin(), name.end(),
                                         [](char a, char b) { return (a | 0x20) == b; });
        if (!is_named) continue;
        number = end > 0 ? -value : value;
        return {text.data() + end + name.size(), std::errc{}};
    }
    std::size_t n_digits = n_digits_at(end);
    end += n_digits;
    if (end < text.size() && text[end] == '.') {
        const std::size_t n_decimals = n_digits_at(end + 1);
        if (n_digits + n_decimals > 0) end += 1 + n_decimals;
        n_digits += n_decimals;
    }
    if (n_digits == 0) return {text.data(), std::errc::invalid_argument};
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const std::size_t sign =
            end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+');
        const std::size_t n_power = n_digits_at(std::min(end + 1 + sign, text.size()));
        if (n_power > 0) end += 1 + sign + n_power;
    }
    const char* const last = text.data() + end;
    const double value = std::strtod(std::string(text.substr(0, end)).c_str(), nullptr);
    const std::string_view digits = text.substr(0, text.substr(0, end).find_first_of("eE"));
    const bool is_zero = digits.find_first_of("123456789") == std::string_view::npos;
    if (std::isinf(value) || (value == 0.0 && !is_zero))
        return {last, std::errc::result_out_of_range};
    number = value;
    return {last, std::errc{}};
}
#endif

}  // namespace

std::from_chars_result read_double(std::string_view text, double& number) {
    std::from_chars_result read = decimal_at_front(text, number);
    if (read.ec != std::errc::result_out_of_range) return read;
    const std::string_view decimal =
        text.substr(0, static_cast<std::size_t>(read.ptr - text.data()));
    number = std::copysign(is_too_small(decimal) ? 0.0 : HUGE_VAL,
                           decimal.starts_with('-') ? -1.0 : 1.0);
    if (number == 0.0) read.ec = std::errc{};
    return read;
}

std::string_view without_plus(std::string_view text) {
    return text.starts_with('+') && !text.starts_with("+-") ? text.substr(1) : text;
}

bool take_count(std::string_view& text, std::int64_t& number, char after) {
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc{} || end == last || *end != after || number < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    return true;
}

}  // namespace poinsot
