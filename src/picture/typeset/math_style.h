// The styles of formulas, and the spaces between atoms.
#pragma once

#include <vector>

#include "typeset/label_tree.h"

namespace poinsot {

// The style of a formula, which determines size and spacing (The TeXbook, p. 140).
struct MathStyle {
    enum class Level { display, text, script, script_script };
    Level level = Level::text;
    bool cramped = false;  // superscripts are raised less
};

bool is_script(MathStyle style);

// The styles of the parts of a formula (The TeXbook, p. 141).
MathStyle cramped(MathStyle style);
MathStyle superscript_style(MathStyle style);
MathStyle subscript_style(MathStyle style);
MathStyle numerator_style(MathStyle style);
MathStyle denominator_style(MathStyle style);

// Space between two neighbouring atoms, in 1/18 em.
int spacing_mu(AtomClass left, AtomClass right, MathStyle style);

// The class of each atom of a list for spacing: a binary operator without an operand on both sides
// is a sign, an ordinary atom (The TeXbook, appendix G, rules 5 and 6).
std::vector<AtomClass> spacing_classes(const MathList& atoms);

}  // namespace poinsot
