// What a label says, before it has any size: a tree of mathematical atoms (Knuth, The TeXbook,
// chapter 17) and, for captions, the pieces of running text between them.
#pragma once

#include <string>
#include <vector>

namespace poinsot {

// A character and where it stood in the label (columns count characters from 1).
struct LabelCharacter {
    char32_t code = 0;
    int column = 1;
};

// The faces of running text.
enum class TextFace { regular, bold, italic };

struct TextRun {
    TextFace face = TextFace::regular;
    std::vector<LabelCharacter> characters;
};

// The classes that decide the space between two atoms (The TeXbook, p. 158).
enum class AtomClass { ord, op, bin, rel, open, close, punct, inner };

struct MathAtom;
using MathList = std::vector<MathAtom>;

struct MathAtom {
    enum class Kind {
        symbol,    // `symbol`, a Unicode character in its final alphabet
        group,     // `body`
        text,      // `text`, upright running text within mathematics
        big,       // `symbol`, larger in display style, its scripts above and below
        integral,  // `symbol`, larger in display style, its scripts beside it
        radical,   // root of `body`, of degree `second` if that is not empty
        fraction,  // `body` over `second`
        accent,    // combining character `symbol` over `body`
        overline,  // a rule over `body`
        fence,     // `body` between delimiters `open` and `close` of its height (0: none)
        space      // `space_mu`
    };
    // The size at which a fraction is set.
    enum class FractionStyle { automatic, display, text };

    Kind kind = Kind::group;
    AtomClass atom_class = AtomClass::ord;
    int column = 1;
    char32_t symbol = 0;
    char32_t open = 0, close = 0;
    double space_mu = 0.0;  // eighteenths of the quad
    FractionStyle fraction_style = FractionStyle::automatic;
    TextRun text;
    MathList body, second;
    bool has_subscript = false, has_superscript = false;
    MathList subscript, superscript;
};

// A caption: words and formulas stand together until a space or the end of a line.
struct CaptionPiece {
    enum class Kind { text, formula, space, line_break };
    // Digits written as ₁ or ² are set as scripts of the text.
    enum class Script { none, sub, super };

    Kind kind = Kind::text;
    Script script = Script::none;
    TextRun text;
    MathList formula;
};
using Caption = std::vector<CaptionPiece>;

}  // namespace poinsot
