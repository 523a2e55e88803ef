// Text that is no markup, such as a file's name, as a caption that shows just that.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

// What is markup in a caption ("$", "{", "\", "~", "--", …) stands for itself; bytes that are no
// UTF-8 and hidden characters become U+FFFD.
std::string as_caption(std::string_view text);

}  // namespace poinsot
