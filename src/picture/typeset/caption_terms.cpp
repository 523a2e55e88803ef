// Terms of a caption, such as "herpolhode" or ω, which are set in colours of their own.
#include <algorithm>
#include <cstddef>
#include <string_view>

#include "text/utf8.h"
#include "typeset/caption_layout.h"
#include "typeset/label_parser.h"

namespace poinsot {

namespace {

// Letters of alphabets whose words are separated by spaces.
bool is_letter(char32_t c) {
    return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || (c >= 0xC0 && c < 0x250);
}

// A caption's running text as one row of characters. Spaces and formulas are characters without a
// place in the tree.
struct TextPlace {
    char32_t code = 0;
    LabelCharacter* character = nullptr;
};
std::vector<TextPlace> running_text(Caption& caption) {
    std::vector<TextPlace> row;
    for (CaptionPiece& piece : caption) {
        if (piece.kind != CaptionPiece::Kind::text) {
            row.push_back({piece.kind == CaptionPiece::Kind::space ? U' ' : U'\uFFFC'});
            continue;
        }
        for (LabelCharacter& character : piece.text.characters)
            row.push_back({character.code == U'\u00A0' ? U' ' : character.code, &character});
    }
    return row;
}

// The number of places that a term takes from here; 0: it does not stand here.
std::size_t length_of(const std::u32string& term, const std::vector<TextPlace>& row,
                      std::size_t at) {
    if (term.empty() || at + term.size() > row.size()) return 0;
    if (at > 0 && is_letter(row[at - 1].code) && is_letter(term.front())) return 0;
    for (std::size_t k = 0; k < term.size(); ++k)
        if (row[at + k].code != term[k]) return 0;
    const auto ends_at = [&](std::size_t end) {
        return end == row.size() || !is_letter(row[end].code) || !is_letter(term.back());
    };
    const std::size_t end = at + term.size();
    if (ends_at(end)) return term.size();
    return row[end].code == U's' && ends_at(end + 1) ? term.size() + 1 : 0;
}

bool is_equal(const MathList& a, const MathList& b);

bool is_equal(const MathAtom& a, const MathAtom& b) {
    const auto is_same_text = [](const TextRun& one, const TextRun& other) {
        return std::equal(
            one.characters.begin(), one.characters.end(), other.characters.begin(),
            other.characters.end(),
            [](const LabelCharacter& c, const LabelCharacter& d) { return c.code == d.code; });
    };
    return a.kind == b.kind && a.symbol == b.symbol && is_same_text(a.text, b.text) &&
           a.rows.empty() && b.rows.empty() && is_equal(a.body, b.body) &&
           is_equal(a.second, b.second) && is_equal(a.subscript, b.subscript) &&
           is_equal(a.superscript, b.superscript);
}

bool is_equal(const MathList& a, const MathList& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const MathAtom& one, const MathAtom& other) { return is_equal(one, other); });
}

struct Formula {
    MathList atoms;
    int tint = 0;
};

void tint_formula(const std::vector<Formula>& terms, MathList& atoms) {
    for (std::size_t at = 0; at < atoms.size();) {
        const Formula* found = nullptr;
        for (const Formula& term : terms) {
            const std::size_t n = term.atoms.size();
            if (n == 0 || at + n > atoms.size() || (found && found->atoms.size() >= n)) continue;
            if (std::equal(term.atoms.begin(), term.atoms.end(),
                           atoms.begin() + static_cast<std::ptrdiff_t>(at),
                           [](const MathAtom& one, const MathAtom& other) {
                               return is_equal(one, other);
                           }))
                found = &term;
        }
        if (found != nullptr) {
            for (std::size_t k = 0; k < found->atoms.size(); ++k) atoms[at++].tint = found->tint;
            continue;
        }
        MathAtom& atom = atoms[at++];
        for (MathList* part : {&atom.body, &atom.second, &atom.subscript, &atom.superscript})
            tint_formula(terms, *part);
        for (std::vector<MathList>& row : atom.rows)
            for (MathList& cell : row) tint_formula(terms, cell);
    }
}

}  // namespace

void tint_terms(const std::vector<CaptionTerm>& terms, Caption& caption) {
    std::vector<Formula> formulas;
    std::vector<std::u32string> words;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        words.emplace_back();
        if (terms[i].is_formula)
            formulas.push_back({parse_math(terms[i].text), static_cast<int>(i) + 1});
        else
            for (std::string_view rest = terms[i].text; !rest.empty();) {
                const Utf8Character first = first_character(rest);
                words.back() += first.code;
                rest.remove_prefix(first.size);
            }
    }
    for (CaptionPiece& piece : caption)
        if (piece.kind == CaptionPiece::Kind::formula) tint_formula(formulas, piece.formula);

    std::vector<TextPlace> row = running_text(caption);
    for (std::size_t at = 0; at < row.size();) {
        std::size_t longest = 0;
        int tint = 0;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::size_t length = length_of(words[i], row, at);
            if (length <= longest) continue;
            longest = length;
            tint = static_cast<int>(i) + 1;
        }
        for (std::size_t k = at; k < at + longest; ++k)
            if (row[k].character != nullptr) row[k].character->tint = tint;
        at += std::max<std::size_t>(1, longest);
    }
}

}  // namespace poinsot
