// Suggestions for mistyped names, and text that is safe to echo on a terminal.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// "; did you mean "render"?", or empty when nothing is near.
std::string did_you_mean(std::string_view given, std::span<const std::string_view> known);

// Control characters and escapes replaced, so that no input can steer the terminal.
std::string printable(std::string_view text);

}  // namespace poinsot
