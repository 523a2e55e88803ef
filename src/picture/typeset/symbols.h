// The commands of labels: a table from command name to Unicode.
#pragma once

#include <string_view>
#include <vector>

#include "typeset/label_tree.h"
#include "typeset/math_alphabet.h"

namespace poinsot {

// The kind of a command, with its arguments in comments.
enum class CommandKind {
    symbol,         // no argument: one character
    big,            // no argument: a large operator with limits
    integral,       // no argument: a large operator with scripts to the right
    function_name,  // no argument: upright letters, such as sin
    alphabet,       // one argument, set in another alphabet
    text,           // one argument of running text
    accent,         // one argument
    overline,       // one argument
    radical,        // one argument, after an optional degree in brackets
    fraction,       // two arguments
    space,          // no argument
    left,           // a delimiter, a formula, \right and another delimiter
    right,
    begin,  // {pmatrix}, cells between & and \\, \end{pmatrix}
    end
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

// All commands for mathematics, sorted by name.
const std::vector<LabelCommand>& label_commands();

// The command of this name, or null.
const LabelCommand* find_label_command(std::string_view name);

// Returns the character that is drawn for an input character of a formula (- is drawn as a minus
// sign); symbol_class returns the class of a drawn character.
LabelCharacter drawn_symbol(LabelCharacter character);
AtomClass symbol_class(char32_t drawn);

}  // namespace poinsot
