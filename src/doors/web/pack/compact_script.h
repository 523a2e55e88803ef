// Scripts and styles as a page carries them.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

// The script or style without comments, indents and empty lines. Precondition: no string goes over
// several lines, or holds the beginning of a comment: two asterisks or an asterisk and a space
// after a slash.
std::string compact_script(std::string_view script);

}  // namespace poinsot
