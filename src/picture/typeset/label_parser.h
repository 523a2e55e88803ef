// Parses the TeX-like string of a label or caption to its tree.
#pragma once

#include <string_view>

#include "typeset/label_tree.h"

namespace poinsot {

// Parses a label: one formula, in math mode throughout: \mathbf{L}, \omega_1, \sqrt{2T}/L. throws:
// LabelError with the column and the expected input.
MathList parse_math(std::string_view label);

// Parses a caption: running text with formulas between dollar signs: "Contact point at $t = 1.25$
// s". Consecutive spaces count as one; a line feed or \\ ends a line; ~ is a non-breaking space; --
// and --- are dashes; \textbf, \textit and \emph select a face; \$ \% \& \# \_ \{ \} are literal
// characters. throws: LabelError with the column and the expected input.
Caption parse_caption(std::string_view caption);

}  // namespace poinsot
