// Parses decimal numbers.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace poinsot {

// Reads a decimal at the front of the text as std::from_chars does: the nearest double, in every
// locale, without hexadecimal, spaces or a plus sign. A decimal below the smallest double is 0, one
// beyond the largest infinite, as they round. The only place where decimals become doubles.
std::from_chars_result read_double(std::string_view text, double& number);

// A number that is all of the text; nothing where there is more, or it is out of the type's range.
// Doubles are read by read_double.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
    Number number{};
    const char* const last = text.data() + text.size();
    std::from_chars_result read{};
    if constexpr (std::is_same_v<Number, double>) {
        read = read_double(text, number);
    } else {
        static_assert(std::is_integral_v<Number>, "a number is a double or a whole number");
        read = std::from_chars(text.data(), last, number);
    }
    if (read.ec != std::errc{} || read.ptr != last) return std::nullopt;
    return number;
}

// Removes a leading plus sign: "+1.5" becomes "1.5".
std::string_view without_plus(std::string_view text);

// Removes a non-negative number and the character `after` from the front of the text; returns false
// if they are not there.
bool take_count(std::string_view& text, std::int64_t& number, char after);

}  // namespace poinsot
