// Writes a sheet of paper as SVG: paths, gradients, and text in embedded subsets of its fonts. The
// same sheet gives byte-identical files. The unit is 1/256 pt (1.4 µm), and coordinates are
// integers.
#pragma once

#include <string>
#include <string_view>

#include "vector/sheet_of_paper.h"

namespace poinsot::vector {

// Returns the text of the file. `title` is the document's title, `text` is stored as metadata; both
// may be empty. Throws EnvironmentError if a font cannot be read.
std::string svg_of(const SheetOfPaper& paper, std::string_view title, std::string_view text);

// The metadata text stored by svg_of; empty if there is none.
std::string svg_text(std::string_view svg);

}  // namespace poinsot::vector
