// Labels and captions as LaTeX source, for figures that use the fonts of the author's document.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "typeset/typesetter.h"

namespace poinsot {

// Characters that not every document sets, each once.
struct LatexGaps {
    std::vector<char32_t> hidden;        // have no picture of their own; left out
    std::vector<char32_t> need_t1;       // set where the document has \usepackage[T1]{fontenc}
    std::vector<char32_t> need_unicode;  // set by XeLaTeX and LuaLaTeX alone
};

// Returns a label or caption (grammar: label_parser.h) as LaTeX, without fonts and sizes: a label
// is one formula between dollar signs, in display style. Beyond the kernel it may name \boldsymbol,
// \mathbb, \dddot and \poinsotonly{ENCODING}{…}, which sets its second argument if the document has
// fonts of that encoding (T1, TU), and otherwise nothing. Adds to the gaps. Throws LabelError for a
// string that cannot be parsed.
std::string latex_of(std::string_view text, TypeMode mode, LatexGaps& gaps);

}  // namespace poinsot
