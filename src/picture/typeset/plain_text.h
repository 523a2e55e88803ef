// Captions as plain text, for subtitles and screen readers.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

// Returns "I = ½ m r²" for "$I = \frac12 m r^2$": scripts as Unicode characters if they exist, else
// after _ or ^; a fraction as a/b, a root after √; letters of mathematical alphabets as plain
// letters. Throws LabelError as parse_caption does.
std::string plain_text(std::string_view caption);

}  // namespace poinsot
