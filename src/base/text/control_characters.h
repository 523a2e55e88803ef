// Names that scripts and lists cannot hold.
#pragma once

#include <string_view>

namespace poinsot {

// Whether a text has a character for which is_control() is true.
bool has_control_characters(std::string_view text);

}  // namespace poinsot
