// Makes text from any source safe to show: it cannot control a terminal, hide, change the writing
// direction of its surroundings, or fill the screen.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// The largest lengths, in characters, of a name or value inside a message, and of a whole message.
inline constexpr std::size_t most_of_a_name = 400;
inline constexpr std::size_t most_of_a_message = 4000;
inline constexpr std::size_t any_length = std::numeric_limits<std::size_t>::max();

// For a terminal: hidden characters become "\u202e", invalid UTF-8 bytes "\xff", and the middle of
// a text longer than `most` characters becomes "…".
std::string printable(std::string_view text, std::size_t most = most_of_a_name);

// Characters of a note: "é (U+00E9), U+200B, …", the hidden ones by their codes alone and at most
// eight.
std::string listed(std::span<const char32_t> characters);

// For a reader of JSON: a string with its quotes (RFC 8259 §7), hidden characters escaped, so that
// it gives the text back and is as safe to look at, bytes that are no UTF-8 as U+FFFD.
std::string json_string(std::string_view text);

}  // namespace poinsot
