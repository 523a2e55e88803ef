// From the TeX-like string of a label or caption to its tree.
#pragma once

#include <string_view>

#include "typeset/label_tree.h"

namespace poinsot {

// A label is one formula, in math mode throughout: \mathbf{L}, \omega_1, \sqrt{2T}/L.
// throws: LabelError with the column and what was expected there.
MathList parse_math(std::string_view label);

// A caption is running text with formulas between dollar signs: "Contact point at $t = 1.25$ s".
// Spaces run together, a line feed or \\ ends a line, ~ joins words, -- and --- are dashes,
// \textbf, \textit and \emph choose a face, and \$ \% \& \# \_ \{ \} stand for themselves. throws:
// LabelError with the column and what was expected there.
Caption parse_caption(std::string_view caption);

}  // namespace poinsot
