// A caption as text without layout, for subtitles and whoever reads aloud.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

// "I = ½ m r²" of "$I = \frac12 m r^2$": scripts as Unicode has them where it does, else behind _
// or ^; a fraction as a/b, a root behind √; letters of mathematical alphabets as plain ones. Throws
// LabelError as parse_caption.
std::string plain_text(std::string_view caption);

}  // namespace poinsot
