// Captions with numbers that change: "t = {time_s:.2f} s".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// A number that a caption may refer to.
struct LiveValue {
    std::string_view name;  // "time_s"
    double value = 0.0;
};

// Replaces every {name} or {name:FORMAT} outside $formulas$ by its number; FORMAT is as in C++20's
// <format> for a double ("." digits and one of e, f, g). "{{" and "}}" produce braces. Throws
// InputError with the column for an unknown name (with the list), an invalid format or an unclosed
// brace.
std::string expand_live_text(std::string_view text, std::span<const LiveValue> values);

// Whether a caption contains numbers that change.
bool is_live(std::string_view text);

}  // namespace poinsot
