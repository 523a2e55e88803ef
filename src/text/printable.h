// Text from anywhere, as people and programs see it: nothing in it can steer a terminal, hide, turn
// the direction of what stands around it, or fill the screen.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// What a name or a value may take within a message, and a whole message, in characters.
inline constexpr std::size_t most_of_a_name = 400;
inline constexpr std::size_t most_of_a_message = 4000;
inline constexpr std::size_t any_length = std::numeric_limits<std::size_t>::max();

// For a terminal: hidden characters are written "\u202e", bytes that are no UTF-8 "\xff", and what
// is longer than `most` characters loses its middle to "…".
std::string printable(std::string_view text, std::size_t most = most_of_a_name);

// Characters of a note: "é (U+00E9), U+200B, …", the hidden ones by their codes alone and at most
// eight.
std::string listed(std::span<const char32_t> characters);

// For a reader of JSON: a string with its quotes (RFC 8259 §7), hidden characters escaped, so that
// it gives the text back and is as safe to look at, bytes that are no UTF-8 as U+FFFD.
std::string json_string(std::string_view text);

}  // namespace poinsot
