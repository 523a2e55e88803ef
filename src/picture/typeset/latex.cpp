#include "typeset/latex.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "text/utf8.h"
#include "typeset/label_parser.h"
#include "typeset/math_alphabet.h"
#include "typeset/symbols.h"

namespace poinsot {

namespace {

// The plain character, and the command that selects the alphabet, of a character in a mathematical
// alphabet.
struct PlainSymbol {
    char32_t plain = 0;
    std::string_view alphabet;
};

bool is_greek(char32_t c) { return c >= U'Α' && c <= U'ϵ'; }

const std::map<char32_t, PlainSymbol>& symbols_of_alphabets() {
    static const std::map<char32_t, PlainSymbol> known = [] {
        constexpr std::array<std::pair<MathAlphabet, std::string_view>, 6> alphabets{
            {{MathAlphabet::normal, ""},
             {MathAlphabet::italic, "mathit"},
             {MathAlphabet::bold, "mathbf"},
             {MathAlphabet::bold_symbol, "boldsymbol"},
             {MathAlphabet::calligraphic, "mathcal"},
             {MathAlphabet::double_struck, "mathbb"}}};
        std::u32string plain;
        for (char32_t c = U'0'; c <= U'9'; ++c) plain += c;
        for (char32_t c = U'A'; c <= U'Z'; ++c) plain += {c, c + U'a' - U'A'};
        for (char32_t c = U'Α'; c <= U'ω'; ++c) plain += c;
        plain += U"∂ϵϑϰϕϱϖ∇";
        std::map<char32_t, PlainSymbol> symbols;
        for (const auto& [alphabet, command] : alphabets)
            for (const char32_t c : plain)
                if (const char32_t drawn = in_alphabet(c, alphabet); drawn != c)
                    // LaTeX's \mathbf has no small Greek letters.
                    symbols.emplace(drawn,
                                    PlainSymbol{c, command == "mathbf" && is_greek(c) && c >= U'α'
                                                       ? "boldsymbol"
                                                       : command});
        return symbols;
    }();
    return known;
}

// The name of the command for a character; empty if there is none.
std::string_view command_for(char32_t c, CommandKind kind) {
    for (const LabelCommand& command : label_commands())
        if (command.kind == kind && command.symbol == c) return command.name;
    return {};
}

struct Range {
    char32_t first, last;
};

template <typename Ranges>
bool is_in(const Ranges& ranges, char32_t c) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [c](const Range& range) { return range.first <= c && c <= range.last; });
}

// Characters that pdflatex sets in an article without further packages: each character of U+00A0 to
// U+30FF and U+FB00 to U+FFFF tried separately (LaTeX2e <2022-11-01>; the test "latex_characters"
// repeats this).
constexpr std::array<Range, 78> set_by_any_latex{
    {{0xA0, 0xAA},     {0xAC, 0xBA},     {0xBC, 0xCF},     {0xD1, 0xDD},     {0xDF, 0xEF},
     {0xF1, 0xFD},     {0xFF, 0x103},    {0x106, 0x10F},   {0x112, 0x117},   {0x11A, 0x125},
     {0x128, 0x12D},   {0x130, 0x137},   {0x139, 0x13E},   {0x141, 0x148},   {0x14C, 0x165},
     {0x168, 0x171},   {0x174, 0x17E},   {0x192, 0x192},   {0x1C4, 0x1D4},   {0x1E2, 0x1E3},
     {0x1E6, 0x1E9},   {0x1F0, 0x1F0},   {0x1F4, 0x1F5},   {0x218, 0x21B},   {0x232, 0x233},
     {0x237, 0x237},   {0x2C6, 0x2C7},   {0x2D8, 0x2D9},   {0x2DC, 0x2DD},   {0xE3F, 0xE3F},
     {0x1E02, 0x1E03}, {0x1E0D, 0x1E0D}, {0x1E1E, 0x1E21}, {0x1E25, 0x1E25}, {0x1E30, 0x1E31},
     {0x1E37, 0x1E37}, {0x1E43, 0x1E43}, {0x1E45, 0x1E45}, {0x1E47, 0x1E47}, {0x1E5B, 0x1E5B},
     {0x1E63, 0x1E63}, {0x1E6D, 0x1E6D}, {0x1E8E, 0x1E91}, {0x1E9E, 0x1E9E}, {0x1EF2, 0x1EF3},
     {0x2010, 0x2016}, {0x2018, 0x2019}, {0x201C, 0x201D}, {0x2020, 0x2022}, {0x2026, 0x2026},
     {0x2030, 0x2031}, {0x203B, 0x203B}, {0x203D, 0x203D}, {0x2044, 0x2044}, {0x204E, 0x204E},
     {0x2052, 0x2052}, {0x20A1, 0x20A1}, {0x20A4, 0x20A4}, {0x20A6, 0x20A6}, {0x20A9, 0x20A9},
     {0x20AB, 0x20AC}, {0x20B1, 0x20B1}, {0x2103, 0x2103}, {0x2116, 0x2117}, {0x211E, 0x211E},
     {0x2120, 0x2120}, {0x2122, 0x2122}, {0x2126, 0x2127}, {0x212E, 0x212E}, {0x2190, 0x2193},
     {0x2329, 0x232A}, {0x2422, 0x2423}, {0x25E6, 0x25E6}, {0x25EF, 0x25EF}, {0x266A, 0x266A},
     {0x27E8, 0x27E9}, {0x3008, 0x3009}, {0xFB00, 0xFB06}}};

// The additional characters that it sets with \usepackage[T1]{fontenc}.
constexpr std::array<Range, 17> set_with_t1{{{0xAB, 0xAB},
                                             {0xBB, 0xBB},
                                             {0xD0, 0xD0},
                                             {0xDE, 0xDE},
                                             {0xF0, 0xF0},
                                             {0xFE, 0xFE},
                                             {0x104, 0x105},
                                             {0x110, 0x111},
                                             {0x118, 0x119},
                                             {0x12E, 0x12F},
                                             {0x14A, 0x14B},
                                             {0x172, 0x173},
                                             {0x1EA, 0x1EB},
                                             {0x2DB, 0x2DB},
                                             {0x201A, 0x201A},
                                             {0x201E, 0x201E},
                                             {0x2039, 0x203A}}};

std::string in_face(TextFace face, std::string text) {
    if (face == TextFace::bold) return fmt::format("\\textbf{{{}}}", text);
    if (face == TextFace::italic) return fmt::format("\\textit{{{}}}", text);
    return text;
}

// Writes pieces, and collects the characters that not every LaTeX document can set.
class LatexWriter {
 public:
    explicit LatexWriter(LatexGaps& gaps) : gaps_(gaps) {}

    std::string formula(const MathList& list) {
        std::string text;
        for (const MathAtom& atom : list) {
            text += nucleus(atom);
            if (atom.has_subscript) text += fmt::format("_{{{}}}", formula(atom.subscript));
            if (atom.has_superscript) text += fmt::format("^{{{}}}", formula(atom.superscript));
        }
        return text;
    }

    std::string piece_of(const CaptionPiece& piece) {
        switch (piece.kind) {
            case CaptionPiece::Kind::space:
                return " ";
            case CaptionPiece::Kind::line_break:
                // A bracket that follows would be its argument.
                return "\\\\{} ";
            case CaptionPiece::Kind::formula:
                return fmt::format("${}$", formula(piece.formula));
            case CaptionPiece::Kind::text:
                break;
        }
        if (piece.script == CaptionPiece::Script::none) return run(piece.text);
        return fmt::format("${}{{{}}}$", piece.script == CaptionPiece::Script::sub ? '_' : '^',
                           run(piece.text));
    }

 private:
    static void keep(char32_t c, std::vector<char32_t>& of) {
        if (std::find(of.begin(), of.end(), c) == of.end()) of.push_back(c);
    }

    // One that is left to the document's font, or to nothing where that font has it not.
    std::string character_of_font(char32_t c) {
        if (is_hidden(c)) {
            keep(c, gaps_.hidden);
            return {};
        }
        if (is_in(set_by_any_latex, c)) return utf8_of(c);
        const bool by_t1 = is_in(set_with_t1, c);
        keep(c, by_t1 ? gaps_.need_t1 : gaps_.need_unicode);
        return fmt::format("\\poinsotonly{{{}}}{{{}}}", by_t1 ? "T1" : "TU", utf8_of(c));
    }

    // A plain character in a formula.
    std::string plain_symbol(char32_t c) {
        switch (c) {
            case U'−':
                return "-";
            case U'∗':
                return "*";
            case U'°':
                return "{}^{\\circ}";
            case U'{':
            case U'}':
            case U'%':
            case U'$':
            case U'#':
            case U'&':
            case U'_':
                return fmt::format("\\{}", static_cast<char>(c));
            case U'\\':
                return "\\backslash ";
            case U'‖':
                return "\\|";
            default:
                break;
        }
        if (c < 0x80) return std::string(1, static_cast<char>(c));
        const std::string_view name = command_for(c, CommandKind::symbol);
        if (!name.empty()) return fmt::format("\\{} ", name);
        return fmt::format("\\mbox{{{}}}", character_of_font(c));
    }

    std::string symbol(char32_t c) {
        const auto& known = symbols_of_alphabets();
        if (const auto found = known.find(c); found != known.end()) {
            const auto& [plain, alphabet] = found->second;
            return alphabet.empty() ? plain_symbol(plain)
                                    : fmt::format("\\{}{{{}}}", alphabet, plain_symbol(plain));
        }
        // Letters outside of these alphabets are upright.
        const bool is_letter = (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z');
        return is_letter ? fmt::format("\\mathrm{{{}}}", static_cast<char>(c)) : plain_symbol(c);
    }

    std::string delimiter(char32_t c) { return c == 0 ? "." : plain_symbol(c); }

    std::string character_of_text(char32_t c) {
        constexpr std::array<std::pair<char32_t, std::string_view>, 12> known{
            {{U'\u00A0', "~"},
             {U'“', "``"},
             {U'”', "''"},
             {U'‘', "`"},
             {U'’', "'"},
             {U'–', "--"},
             {U'—', "---"},
             {U'~', "\\textasciitilde{}"},
             {U'^', "\\textasciicircum{}"},
             {U'\\', "\\textbackslash{}"},
             {U'…', "\\dots{}"},
             {U'"', "\\char34{}"}}};
        for (const auto& [code, latex] : known)
            if (code == c) return std::string(latex);
        if (c == U'{' || c == U'}' || c == U'%' || c == U'$' || c == U'#' || c == U'&' || c == U'_')
            return fmt::format("\\{}", static_cast<char>(c));
        if (c == U'<' || c == U'>' || c == U'|' || c == U'−' || c == U'°')
            return fmt::format("${}$", plain_symbol(c));
        if (c < 0x80) return std::string(1, static_cast<char>(c));
        if (const auto found = symbols_of_alphabets().find(c);
            found != symbols_of_alphabets().end())
            return fmt::format("${}$", symbol(c));
        if (const std::string_view name = command_for(c, CommandKind::symbol); !name.empty())
            return fmt::format("$\\{}$", name);
        return character_of_font(c);
    }

    std::string run(const TextRun& text) {
        std::string letters;
        for (const LabelCharacter& character : text.characters)
            letters += character_of_text(character.code);
        return in_face(text.face, std::move(letters));
    }

    std::string nucleus(const MathAtom& atom) {
        switch (atom.kind) {
            case MathAtom::Kind::symbol:
                if (atom.symbol == U'|' && atom.atom_class == AtomClass::open)
                    return "\\mathopen{|}";
                if (atom.symbol == U'|' && atom.atom_class == AtomClass::close)
                    return "\\mathclose{|}";
                return symbol(atom.symbol);
            case MathAtom::Kind::group:
                return fmt::format("{{{}}}", formula(atom.body));
            case MathAtom::Kind::text: {
                const std::string words = run(atom.text);
                return atom.atom_class == AtomClass::op
                           ? fmt::format("\\mathop{{\\mathrm{{{}}}}}\\nolimits ", words)
                           : fmt::format("\\mbox{{{}}}", words);
            }
            case MathAtom::Kind::big:
                return fmt::format("\\{} ", command_for(atom.symbol, CommandKind::big));
            case MathAtom::Kind::integral:
                return fmt::format("\\{} ", command_for(atom.symbol, CommandKind::integral));
            case MathAtom::Kind::radical:
                return atom.second.empty() ? fmt::format("\\sqrt{{{}}}", formula(atom.body))
                                           : fmt::format("\\sqrt[{}]{{{}}}", formula(atom.second),
                                                         formula(atom.body));
            case MathAtom::Kind::fraction: {
                std::string fraction =
                    fmt::format("\\frac{{{}}}{{{}}}", formula(atom.body), formula(atom.second));
                if (atom.fraction_style == MathAtom::FractionStyle::display)
                    return fmt::format("{{\\displaystyle{}}}", fraction);
                if (atom.fraction_style == MathAtom::FractionStyle::text)
                    return fmt::format("{{\\textstyle{}}}", fraction);
                return fraction;
            }
            case MathAtom::Kind::accent:
                return fmt::format("\\{}{{{}}}", command_for(atom.symbol, CommandKind::accent),
                                   formula(atom.body));
            case MathAtom::Kind::overline:
                return fmt::format("\\overline{{{}}}", formula(atom.body));
            case MathAtom::Kind::fence:
                return fmt::format("\\left{} {}\\right{} ", delimiter(atom.open),
                                   formula(atom.body), delimiter(atom.close));
            case MathAtom::Kind::matrix:
                return matrix(atom);
            case MathAtom::Kind::space:
                return fmt::format("\\mskip{:g}mu ", atom.space_mu);
        }
        return {};
    }
    // The array of the LaTeX kernel: pmatrix would need a package.
    std::string matrix(const MathAtom& atom) {
        std::size_t n_columns = 0;
        std::string rows;
        for (const std::vector<MathList>& row : atom.rows) {
            n_columns = std::max(n_columns, row.size());
            if (!rows.empty()) rows += "\\\\{} ";  // a row may begin with [ or *
            for (std::size_t i = 0; i < row.size(); ++i)
                rows += (i > 0 ? " & " : "") + formula(row[i]);
        }
        return fmt::format("\\begin{{array}}{{{}}}{}\\end{{array}}", std::string(n_columns, 'c'),
                           rows);
    }

    LatexGaps& gaps_;
};

}  // namespace

std::string latex_of(std::string_view text, TypeMode mode, LatexGaps& gaps) {
    LatexWriter writer(gaps);
    if (mode == TypeMode::math)
        return fmt::format("$\\displaystyle {}$", writer.formula(parse_math(text)));
    std::string latex;
    for (const CaptionPiece& piece : parse_caption(text)) latex += writer.piece_of(piece);
    return latex;
}

}  // namespace poinsot
