// The syntax tree of a label, independent of size: mathematical atoms (Knuth, The TeXbook, chapter
// 17) and, for captions, the pieces of running text between formulas.
#pragma once

#include <string>
#include <vector>

namespace poinsot {

// A character and its column in the label (in characters, counted from 1).
struct LabelCharacter {
    char32_t code = 0;
    int column = 1;
    int tint = 0;  // of a term (CaptionTerm); 0: none
};

// The faces of running text.
enum class TextFace { regular, bold, italic };

struct TextRun {
    TextFace face = TextFace::regular;
    std::vector<LabelCharacter> characters;
};

// The classes that determine the space between two atoms (The TeXbook, p. 158).
enum class AtomClass { ord, op, bin, rel, open, close, punct, inner };

struct MathAtom;
using MathList = std::vector<MathAtom>;

struct MathAtom {
    enum class Kind {
        symbol,    // `symbol`, a Unicode character, already in its mathematical alphabet
        group,     // `body`
        text,      // `text`, upright running text inside mathematics
        big,       // `symbol`, larger in display style, with scripts above and below
        integral,  // `symbol`, larger in display style, with scripts to the right
        radical,   // root of `body`, with degree `second` unless that is empty
        fraction,  // `body` over `second`
        accent,    // combining character `symbol` over `body`
        overline,  // a rule over `body`
        fence,     // `body` between delimiters `open` and `close` of its height (0: no delimiter)
        matrix,    // `rows` of cells
        space      // `space_mu`
    };
    // The style in which a fraction is set.
    enum class FractionStyle { automatic, display, text };

    Kind kind = Kind::group;
    AtomClass atom_class = AtomClass::ord;
    int column = 1;
    int tint = 0;  // of a term, with its scripts; 0: none
    char32_t symbol = 0;
    char32_t open = 0, close = 0;
    double space_mu = 0.0;  // in 1/18 em
    FractionStyle fraction_style = FractionStyle::automatic;
    TextRun text;
    MathList body, second;
    std::vector<std::vector<MathList>> rows;
    bool has_subscript = false, has_superscript = false;
    MathList subscript, superscript;
};

// A piece of a caption. Words and formulas without a space between them form one word.
struct CaptionPiece {
    enum class Kind { text, formula, space, line_break };
    // Digits written as ₁ or ² become sub- or superscripts of the text.
    enum class Script { none, sub, super };

    Kind kind = Kind::text;
    Script script = Script::none;
    TextRun text;
    MathList formula;
};
using Caption = std::vector<CaptionPiece>;

}  // namespace poinsot
