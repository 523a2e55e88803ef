// The styles of formulas, and the spaces between atoms.
#pragma once

#include <vector>

#include "typeset/label_tree.h"

namespace poinsot {

// The style of a formula: how large it is and how much room it may take (The TeXbook, p. 140).
struct MathStyle {
    enum class Level { display, text, script, script_script };
    Level level = Level::text;
    bool cramped = false;  // superscripts stay low
};

bool is_script(MathStyle style);

// The styles of the parts of a formula (The TeXbook, p. 141).
MathStyle cramped(MathStyle style);
MathStyle superscript_style(MathStyle style);
MathStyle subscript_style(MathStyle style);
MathStyle numerator_style(MathStyle style);
MathStyle denominator_style(MathStyle style);

// Space between two neighbours, in eighteenths of a quad.
int spacing_mu(AtomClass left, AtomClass right, MathStyle style);

// The classes of the atoms of a list as spacing sees them, one each: a binary operation needs
// something on both sides, otherwise it is a sign, an ordinary atom (The TeXbook, appendix G, rules
// 5 and 6).
std::vector<AtomClass> spacing_classes(const MathList& atoms);

}  // namespace poinsot
