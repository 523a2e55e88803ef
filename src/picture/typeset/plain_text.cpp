#include "typeset/plain_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include "text/utf8.h"
#include "typeset/label_parser.h"

namespace poinsot {

namespace {

std::string plain(const MathList& list);

// Converts mathematical alphanumeric symbols (U+1D400 …) to plain letters: 52 Latin letters per
// style, then 58 Greek ones per style, then digits.
char32_t plain_letter(char32_t code) {
    if (code >= 0x1D400 && code < 0x1D6A4) {
        const char32_t letter = (code - 0x1D400) % 52;
        return letter < 26 ? U'A' + letter : U'a' + (letter - 26);
    }
    if (code >= 0x1D6A8 && code < 0x1D7CA) {
        const char32_t letter = (code - 0x1D6A8) % 58;
        constexpr std::array<char32_t, 8> others{0x2207, 0x2202, 0x3F5, 0x3D1,
                                                 0x3F0,  0x3D5,  0x3F1, 0x3D6};
        if (letter < 25) return letter == 17 ? U'\u03F4' : 0x391 + letter;
        if (letter == 25) return others[0];
        if (letter < 51) return 0x3B1 + (letter - 26);
        return others[letter - 50];
    }
    if (code >= 0x1D7CE && code < 0x1D800) return U'0' + (code - 0x1D7CE) % 10;
    return code == 0x210E ? U'h' : code;
}

std::string plain(const TextRun& run) {
    std::string text;
    constexpr char32_t joining_space = 0xA0;
    for (const LabelCharacter& character : run.characters)
        text += character.code == joining_space ? " " : utf8_of(character.code);
    return text;
}

// Writes a script with Unicode's script characters if all exist, else after _ or ^.
std::string script(std::string text, bool above) {
    std::erase(text, ' ');
    constexpr std::array<std::pair<char, std::pair<char32_t, char32_t>>, 12> known{{
        {'0', {0x2080, 0x2070}},
        {'1', {0x2081, 0xB9}},
        {'2', {0x2082, 0xB2}},
        {'3', {0x2083, 0xB3}},
        {'4', {0x2084, 0x2074}},
        {'5', {0x2085, 0x2075}},
        {'6', {0x2086, 0x2076}},
        {'7', {0x2087, 0x2077}},
        {'8', {0x2088, 0x2078}},
        {'9', {0x2089, 0x2079}},
        {'+', {0x208A, 0x207A}},
        {'-', {0x208B, 0x207B}},
    }};
    std::string scripts;
    std::string_view rest = text;
    while (!rest.empty()) {
        const Utf8Character character = first_character(rest);
        const char32_t code = character.code == 0x2212 ? U'-' : character.code;
        const auto found = std::find_if(known.begin(), known.end(), [code](const auto& row) {
            return static_cast<char32_t>(row.first) == code;
        });
        if (found == known.end()) return (above ? "^" : "_") + text;
        scripts += utf8_of(above ? found->second.second : found->second.first);
        rest.remove_prefix(character.size);
    }
    return scripts;
}

// An operand of a fraction or root, in brackets if it consists of several parts.
std::string operand(const MathList& list) {
    const std::string text = plain(list);
    return list.size() > 1 ? "(" + text + ")" : text;
}

std::string plain(const MathAtom& atom) {
    using Kind = MathAtom::Kind;
    std::string text;
    switch (atom.kind) {
        case Kind::symbol:
        case Kind::big:
        case Kind::integral:
            text = utf8_of(plain_letter(atom.symbol));
            break;
        case Kind::text:
            text = plain(atom.text);
            break;
        case Kind::radical:
            text = "\u221A" + operand(atom.body);
            break;
        case Kind::fraction:
            text = operand(atom.body) + "/" + operand(atom.second);
            break;
        case Kind::accent:
            text = plain(atom.body) + utf8_of(atom.symbol);
            break;
        case Kind::fence:
            text = (atom.open != 0 ? utf8_of(atom.open) : "") + plain(atom.body) +
                   (atom.close != 0 ? utf8_of(atom.close) : "");
            break;
        case Kind::matrix:
            for (std::size_t k = 0; k < atom.rows.size(); ++k) {
                text += k > 0 ? "; " : "";
                for (std::size_t i = 0; i < atom.rows[k].size(); ++i)
                    text += (i > 0 ? ", " : "") + plain(atom.rows[k][i]);
            }
            break;
        case Kind::space:
            text = atom.space_mu > 0.0 ? " " : "";
            break;
        case Kind::group:
        case Kind::overline:
            text = plain(atom.body);
            break;
    }
    // Relations and binary operators get spaces.
    const bool apart = atom.atom_class == AtomClass::rel || atom.atom_class == AtomClass::bin;
    if (apart && atom.kind == Kind::symbol) text = " " + text + " ";
    if (atom.has_subscript) text += script(plain(atom.subscript), false);
    if (atom.has_superscript) text += script(plain(atom.superscript), true);
    return text;
}

std::string plain(const MathList& list) {
    std::string text;
    for (const MathAtom& atom : list) text += plain(atom);
    return text;
}

}  // namespace

std::string plain_text(std::string_view caption) {
    std::string text;
    for (const CaptionPiece& piece : parse_caption(caption)) {
        switch (piece.kind) {
            case CaptionPiece::Kind::text:
                text +=
                    piece.script == CaptionPiece::Script::none
                        ? plain(piece.text)
                        : script(plain(piece.text), piece.script == CaptionPiece::Script::super);
                break;
            case CaptionPiece::Kind::formula:
                text += plain(piece.formula);
                break;
            case CaptionPiece::Kind::space:
                text += ' ';
                break;
            case CaptionPiece::Kind::line_break:
                text += '\n';
                break;
        }
    }
    return text;
}

}  // namespace poinsot
