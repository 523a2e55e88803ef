// Parses values on a command line: a value is used entirely, or refused with the option's name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace poinsot {

// Returns a text that is not empty: an empty one is usually an unset variable of a script. Throws
// InputError.
std::string parse_text(std::string_view option, const std::string& text);

// Parses a finite number in decimal notation. `wanted` is its meaning in messages, such as "an
// instant in seconds". Throws InputError.
double parse_number(std::string_view option, std::string_view text, std::string_view wanted);

// Parses an integer in decimal notation. Throws InputError.
int parse_whole(std::string_view option, std::string_view text, std::string_view wanted);

// Parses "A-B" with 0 <= A <= B, or "A" for a single frame. Throws InputError.
std::pair<std::int64_t, std::int64_t> parse_frames(std::string_view text);

// Parses "K/N" with 1 <= K <= N. Throws InputError.
std::pair<std::int64_t, std::int64_t> parse_part(std::string_view text);

}  // namespace poinsot
