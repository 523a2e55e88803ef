// Values on a command line: each is read whole, or refused with the option's name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace poinsot {

// Text that says something: an empty one is most often a variable of a script that was not set.
// Throws InputError.
std::string parse_text(std::string_view option, const std::string& text);

// A finite number in decimal notation. `wanted` says what is meant by it, as "an instant in
// seconds". Throws InputError.
double parse_number(std::string_view option, std::string_view text, std::string_view wanted);

// A whole number in decimal notation. Throws InputError.
int parse_whole(std::string_view option, std::string_view text, std::string_view wanted);

// "A-B" with 0 <= A <= B, or "A" for that frame alone. Throws InputError.
std::pair<std::int64_t, std::int64_t> parse_frames(std::string_view text);

// "K/N" with 1 <= K <= N. Throws InputError.
std::pair<std::int64_t, std::int64_t> parse_part(std::string_view text);

}  // namespace poinsot
