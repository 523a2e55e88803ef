#include "typeset/math_style.h"

#include <array>
#include <cstddef>

namespace poinsot {
namespace {

using Level = MathStyle::Level;

// Space between two atoms in 1/18 em; negative values apply only outside scripts (The TeXbook, p.
// 170: thin 3, medium 4, thick 5). Rows: left atom; columns: right atom; both in the order of
// AtomClass.
constexpr std::array<std::array<int, 8>, 8> spacing_table_mu{{
    // ord op bin rel open close punct inner
    {0, 3, -4, -5, 0, 0, 0, -3},      // ord
    {3, 3, 0, -5, 0, 0, 0, -3},       // op
    {-4, -4, 0, 0, -4, 0, 0, -4},     // bin
    {-5, -5, 0, 0, -5, 0, 0, -5},     // rel
    {0, 0, 0, 0, 0, 0, 0, 0},         // open
    {0, 3, -4, -5, 0, 0, 0, -3},      // close
    {-3, -3, 0, -3, -3, -3, -3, -3},  // punct
    {-3, 3, -4, -5, -3, 0, -3, -3}    // inner
}};

}  // namespace

bool is_script(MathStyle style) { return style.level >= Level::script; }

MathStyle cramped(MathStyle style) { return {style.level, true}; }
MathStyle superscript_style(MathStyle style) {
    return {is_script(style) ? Level::script_script : Level::script, style.cramped};
}
MathStyle subscript_style(MathStyle style) { return cramped(superscript_style(style)); }
MathStyle numerator_style(MathStyle style) {
    if (style.level == Level::display) return {Level::text, style.cramped};
    return superscript_style(style);
}
MathStyle denominator_style(MathStyle style) { return cramped(numerator_style(style)); }

int spacing_mu(AtomClass left, AtomClass right, MathStyle style) {
    const int mu =
        spacing_table_mu.at(static_cast<std::size_t>(left)).at(static_cast<std::size_t>(right));
    if (mu >= 0) return mu;
    return is_script(style) ? 0 : -mu;
}

std::vector<AtomClass> spacing_classes(const MathList& atoms) {
    std::vector<AtomClass> classes;
    classes.reserve(atoms.size());
    std::ptrdiff_t last = -1;
    const auto no_left_operand = [](AtomClass c) {
        return c == AtomClass::bin || c == AtomClass::op || c == AtomClass::rel ||
               c == AtomClass::open || c == AtomClass::punct;
    };
    const auto no_right_operand = [](AtomClass c) {
        return c == AtomClass::rel || c == AtomClass::close || c == AtomClass::punct;
    };
    for (const MathAtom& atom : atoms) {
        AtomClass now = atom.atom_class;
        classes.push_back(now);
        if (atom.kind == MathAtom::Kind::space) continue;
        AtomClass* before = last >= 0 ? &classes[static_cast<std::size_t>(last)] : nullptr;
        if (now == AtomClass::bin && (!before || no_left_operand(*before))) now = AtomClass::ord;
        if (before && *before == AtomClass::bin && no_right_operand(now)) *before = AtomClass::ord;
        classes.back() = now;
        last = static_cast<std::ptrdiff_t>(classes.size()) - 1;
    }
    if (last >= 0 && classes[static_cast<std::size_t>(last)] == AtomClass::bin) {
        classes[static_cast<std::size_t>(last)] = AtomClass::ord;
    }
    return classes;
}

}  // namespace poinsot
