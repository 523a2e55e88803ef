// Labels and captions as LaTeX sets them: for figures whose type is the author's own.
#pragma once

#include <string>
#include <string_view>

#include "typeset/typesetter.h"

namespace poinsot {

// What a document of LaTeX says for a label or caption (grammar: label_parser.h), its own fonts and
// sizes left to it: a label is one formula between dollar signs, in display style. Beyond the
// kernel it may name \boldsymbol, \mathbb, \dddot; what is no letter of mathematics stays UTF-8.
// throws: LabelError for what the string says.
std::string latex_of(std::string_view text, TypeMode mode);

}  // namespace poinsot
