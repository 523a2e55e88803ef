// Messages for the user, on stderr. Data goes to stdout by fmt::print.
#pragma once

#include <string_view>

namespace poinsot {

// Prints a message of one or more lines, each as printable() shows it; prints nothing for an empty
// message. Ignores write errors on stderr: the results are not affected.
void say(std::string_view message) noexcept;

// Overwrites the current line of a terminal, as a progress bar does. The text is not escaped: pass
// only constant or printable() text.
void say_over_line(std::string_view text) noexcept;

}  // namespace poinsot
