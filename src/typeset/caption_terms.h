// Terms of a caption, such as "herpolhode" or ω, which are set in colours of their own.
#pragma once

#include <string>
#include <vector>

#include "typeset/label_tree.h"

namespace poinsot {

// A word or some words of running text, or a formula without dollar signs.
struct CaptionTerm {
    std::string text;
    bool is_formula = false;
    bool operator==(const CaptionTerm&) const = default;
};

// Marks where the terms occur: words as whole words, also with a plural s; formulas as consecutive
// atoms of a formula, whose scripts agree. What belongs to term i of the list gets tint i + 1, of
// two terms that begin at the same place the longer.
void tint_terms(const std::vector<CaptionTerm>& terms, Caption& caption);

}  // namespace poinsot
