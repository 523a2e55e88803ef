// Captions with numbers that change: "t = {time_s:.2f} s".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// A number that a caption may name.
struct LiveValue {
    std::string_view name;  // "time_s"
    double value = 0.0;
};

// Replaces every {name} or {name:FORMAT} outside $formulas$ by its number, FORMAT as of C++20's
// <format> for a double
// ("." digits and one of e, f, g). "{{" and "}}" stand for braces.
// Throws InputError with the column for an unknown name (with the list), a bad format or a brace
// that is not closed.
std::string expand_live_text(std::string_view text, std::span<const LiveValue> values);

// Whether a caption changes with the instant.
bool is_live(std::string_view text);

}  // namespace poinsot
