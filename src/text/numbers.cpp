#include "text/numbers.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::from_chars_result read_double(std::string_view text, double& number) {
    const char* const last = text.data() + text.size();
    std::from_chars_result read = std::from_chars(text.data(), last, number);
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
