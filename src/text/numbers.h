// Numbers written in decimals.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace poinsot {

// A number that is all of the text; nothing where there is more, or it is out of the type's range.
// std::from_chars knows no locale, no hexadecimal, no spaces and no plus sign.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
    Number number{};
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc{} || end != last) return std::nullopt;
    return number;
}

// "+1.5" without its sign, for those who type one.
std::string_view without_plus(std::string_view text);

// Cuts a number that is not negative, and the character after it, off the front of the text; false
// for what is none.
bool take_count(std::string_view& text, std::int64_t& number, char after);

}  // namespace poinsot
