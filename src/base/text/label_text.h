// Converts text without markup, such as a file name, to a caption that shows this text.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

// Escapes the markup of captions ("$", "{", "\", "~", "--", …); invalid UTF-8 and hidden characters
// become U+FFFD.
std::string as_caption(std::string_view text);

}  // namespace poinsot
