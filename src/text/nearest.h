// Suggestions for mistyped names.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "text/printable.h"

namespace poinsot {

// "; did you mean "render"?", or empty when nothing is near.
std::string did_you_mean(std::string_view given, std::span<const std::string_view> known);

}  // namespace poinsot
