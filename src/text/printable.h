// Text that is safe to echo on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

// Control characters and escapes replaced, so that no input can steer the terminal.
std::string printable(std::string_view text);

}  // namespace poinsot
