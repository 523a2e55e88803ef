// The names that labels may use: a table from command to Unicode.
#pragma once

#include <string_view>
#include <vector>

#include "typeset/label_tree.h"
#include "typeset/math_alphabet.h"

namespace poinsot {

// What follows a command's name.
enum class CommandKind {
    symbol,         // nothing: one character
    big,            // nothing: a large operator with limits
    integral,       // nothing: a large operator with scripts beside it
    function_name,  // nothing: upright letters, such as sin
    alphabet,       // an argument, in another alphabet
    text,           // an argument of running text
    accent,         // an argument
    overline,       // an argument
    radical,        // an argument, after an optional degree in brackets
    fraction,       // two arguments
    space,          // nothing
    left,           // a delimiter, a formula, \right and another delimiter
    right
};

struct LabelCommand {
    std::string_view name;  // without the backslash
    CommandKind kind = CommandKind::symbol;
    char32_t symbol = 0;
    AtomClass atom_class = AtomClass::ord;
    double space_mu = 0.0;
    MathAlphabet alphabet = MathAlphabet::normal;
    TextFace face = TextFace::regular;
    MathAtom::FractionStyle fraction_style = MathAtom::FractionStyle::automatic;
};

// All commands of mathematics, by name.
const std::vector<LabelCommand>& label_commands();

// The command of that name, or null.
const LabelCommand* find_label_command(std::string_view name);

// The class of a character that stands for itself in a formula, and the character that is drawn for
// it (- is drawn as a minus sign).
LabelCharacter drawn_symbol(LabelCharacter character);
AtomClass symbol_class(char32_t drawn);

}  // namespace poinsot
