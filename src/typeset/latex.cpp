#include "typeset/latex.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <utility>

#include "text/utf8.h"
#include "typeset/label_parser.h"
#include "typeset/math_alphabet.h"
#include "typeset/symbols.h"

namespace poinsot {

namespace {

// A character of an alphabet's own, by the plain one and the command that chooses the alphabet.
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
                    // LaTeX's \mathbf has no small Greek.
                    symbols.emplace(drawn,
                                    PlainSymbol{c, command == "mathbf" && is_greek(c) && c >= U'α'
                                                       ? "boldsymbol"
                                                       : command});
        return symbols;
    }();
    return known;
}

// The name of a command that stands for a character; empty if there is none.
std::string_view command_for(char32_t c, CommandKind kind) {
    for (const LabelCommand& command : label_commands())
        if (command.kind == kind && command.symbol == c) return command.name;
    return {};
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
    return name.empty() ? fmt::format("\\mbox{{{}}}", utf8_of(c)) : fmt::format("\\{} ", name);
}

std::string symbol(char32_t c) {
    const auto& known = symbols_of_alphabets();
    if (const auto found = known.find(c); found != known.end()) {
        const auto& [plain, alphabet] = found->second;
        return alphabet.empty() ? plain_symbol(plain)
                                : fmt::format("\\{}{{{}}}", alphabet, plain_symbol(plain));
    }
    // Letters that stay as they are stand upright.
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
    if (const auto found = symbols_of_alphabets().find(c); found != symbols_of_alphabets().end())
        return fmt::format("${}$", symbol(c));
    if (const std::string_view name = command_for(c, CommandKind::symbol); !name.empty())
        return fmt::format("$\\{}$", name);
    return utf8_of(c);
}

std::string in_face(TextFace face, std::string text) {
    if (face == TextFace::bold) return fmt::format("\\textbf{{{}}}", text);
    if (face == TextFace::italic) return fmt::format("\\textit{{{}}}", text);
    return text;
}

std::string run(const TextRun& text) {
    std::string letters;
    for (const LabelCharacter& character : text.characters)
        letters += character_of_text(character.code);
    return in_face(text.face, std::move(letters));
}

std::string formula(const MathList& list);

std::string nucleus(const MathAtom& atom) {
    switch (atom.kind) {
        case MathAtom::Kind::symbol:
            if (atom.symbol == U'|' && atom.atom_class == AtomClass::open) return "\\mathopen{|}";
            if (atom.symbol == U'|' && atom.atom_class == AtomClass::close) return "\\mathclose{|}";
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
            return atom.second.empty()
                       ? fmt::format("\\sqrt{{{}}}", formula(atom.body))
                       : fmt::format("\\sqrt[{}]{{{}}}", formula(atom.second), formula(atom.body));
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
            return fmt::format("\\left{} {}\\right{} ", delimiter(atom.open), formula(atom.body),
                               delimiter(atom.close));
        case MathAtom::Kind::space:
            return fmt::format("\\mskip{:g}mu ", atom.space_mu);
    }
    return {};
}

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
            return "\\\\ ";
        case CaptionPiece::Kind::formula:
            return fmt::format("${}$", formula(piece.formula));
        case CaptionPiece::Kind::text:
            break;
    }
    if (piece.script == CaptionPiece::Script::none) return run(piece.text);
    return fmt::format("${}{{{}}}$", piece.script == CaptionPiece::Script::sub ? '_' : '^',
                       run(piece.text));
}

}  // namespace

std::string latex_of(std::string_view text, TypeMode mode) {
    if (mode == TypeMode::math)
        return fmt::format("$\\displaystyle {}$", formula(parse_math(text)));
    std::string latex;
    for (const CaptionPiece& piece : parse_caption(text)) latex += piece_of(piece);
    return latex;
}

}  // namespace poinsot
