// Captions with numbers that change: "t = {time_s:.2f} s".
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// A number that a caption may refer to.
struct LiveValue {
    std::string name;  // "omega_3"
    double value = 0.0;
    std::string unit{};         // of the value: "deg/s"
    bool brings_unit = false;   // whether the unit is printed; it is not where the name says it
    std::string format = "g";   // used where the text gives none
    std::vector<double> row{};  // three numbers, printed instead of `value` as a formula
    bool is_constant = false;   // whether it is the same at every instant
};

// Replaces every {name} or {name:FORMAT} outside $formulas$ by its number; FORMAT is as in C++20's
// <format> for a double ("." digits and one of e, f, g). "{{" and "}}" produce braces. A number
// that brings its unit is printed with it, unless the text has a unit of the same kind beside it:
// then the number is in that unit. A row is printed as $(4,\, 3,\, 1.5)$, with a common power of
// ten if its numbers are very large or small. Throws InputError with the column for an unknown name
// (with the list), an invalid format or an unclosed brace.
std::string expand_live_text(std::string_view text, std::span<const LiveValue> values,
                             std::string_view decimal_mark = ".");

// Names the units that the text has beside a number and that are not the number's: one line each.
// Throws as expand_live_text does.
std::vector<std::string> unit_notes(std::string_view text, std::span<const LiveValue> values);

// The names of the numbers that a text refers to. Throws as expand_live_text does.
std::vector<std::string_view> numbers_in(std::string_view text, std::span<const LiveValue> values);

// Whether a caption contains numbers of the program.
bool is_live(std::string_view text);

}  // namespace poinsot
