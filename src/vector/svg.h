// A page as SVG: paths, gradients and text in embedded subsets of its fonts. The same page gives
// the same bytes. Its unit is 1/256 pt (1.4 µm), and coordinates are whole.
#pragma once

#include <string>
#include <string_view>

#include "vector/page.h"

namespace poinsot::vector {

// The text of the file. title: of the document, text: carried as metadata; both may be empty.
// Throws EnvironmentError where a font cannot be read.
std::string svg_of(const Page& page, std::string_view title, std::string_view text);

// The metadata that svg_of has put in; empty if there is none.
std::string svg_text(std::string_view svg);

}  // namespace poinsot::vector
