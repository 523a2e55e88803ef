// Typesets formulas: from the tree of atoms to placed glyphs.
#pragma once

#include <vector>

#include "typeset/font_set.h"
#include "typeset/label_tree.h"
#include "typeset/math_style.h"
#include "typeset/type_box.h"

namespace poinsot {

// Typesets a list of atoms at size_px (px per em in text style), with the baseline at y = 0.
// Follows appendix G of The TeXbook with the parameters of the font's OpenType MATH table (OpenType
// specification 1.9, "MATH"). throws: LabelError for a character that the fonts lack.
TypeBox set_formula(const MathList& atoms, MathStyle style, double size_px, FontSet& fonts);

// A part of a formula cut after a relation, where a line of text may break.
struct FormulaPart {
    TypeBox box;
    double space_after = 0.0;  // px, if the next part is on the same line
};
std::vector<FormulaPart> set_formula_parts(const MathList& atoms, MathStyle style, double size_px,
                                           FontSet& fonts);

}  // namespace poinsot
