// Parser of formulas, for labels and for the formulas inside captions.
#pragma once

#include <string>
#include <string_view>

#include "typeset/label_cursor.h"
#include "typeset/label_tree.h"
#include "typeset/symbols.h"

namespace poinsot {

class MathParser {
 public:
    // The delimiter at which a list ends; it is not consumed.
    enum class End { label, brace, bracket, dollar, right, cell };

    explicit MathParser(LabelCursor& cursor) : cursor_(cursor) {}

    // opened_at: the column of the opening delimiter, for the error if the closing one is missing.
    // throws: LabelError.
    MathList list(End end, int opened_at);

 private:
    bool at(End end) const;
    bool at_command(std::u32string_view command) const;
    MathAtom atom();
    MathAtom nucleus();
    MathAtom command();
    MathAtom run_command(const LabelCommand& command, int column);
    static MathAtom function_name(const LabelCommand& command, int column);
    MathAtom text(const LabelCommand& command, int column);
    MathAtom radical(int column);
    MathAtom fence(int column);
    MathAtom matrix(int column);
    void environment(const std::string& after);
    char32_t delimiter();
    MathAtom symbol(LabelCharacter character, AtomClass atom_class) const;
    MathList braced();
    MathList argument(const std::string& what);
    void combining_marks(MathAtom& atom);
    void scripts(MathAtom& atom);
    void script_digits(MathAtom& atom);
    void primes(MathAtom& atom);

    LabelCursor& cursor_;
    MathAlphabet alphabet_ = MathAlphabet::normal;
};

// The error message for an unknown command.
std::string unknown_command(const std::string& name);

// The digit of a script character such as ₁ or ²; 0 if it is not one.
char32_t subscript_digit(char32_t character);
char32_t superscript_digit(char32_t character);

}  // namespace poinsot
