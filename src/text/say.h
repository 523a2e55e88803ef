// What the program tells a person, on stderr. Data goes to stdout by fmt::print.
#pragma once

#include <string_view>

namespace poinsot {

// A message of one line or more, each as printable() shows it; nothing for an empty one.
// It is lost where stderr cannot be written: what has been made is there all the same.
void say(std::string_view message) noexcept;

// Writes over the line of a terminal, as a bar of progress does; with controls, so only for texts
// that are our own or printable().
void say_over_line(std::string_view text) noexcept;

}  // namespace poinsot
