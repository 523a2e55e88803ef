#include "typeset/symbols.h"

#include <algorithm>

namespace poinsot {
namespace {

using Kind = CommandKind;

LabelCommand symbol(std::string_view name, char32_t code, AtomClass atom_class = AtomClass::ord) {
    return {.name = name, .kind = Kind::symbol, .symbol = code, .atom_class = atom_class};
}
LabelCommand rel(std::string_view name, char32_t code) {
    return symbol(name, code, AtomClass::rel);
}
LabelCommand bin(std::string_view name, char32_t code) {
    return symbol(name, code, AtomClass::bin);
}
LabelCommand function(std::string_view name) {
    return {.name = name, .kind = Kind::function_name, .atom_class = AtomClass::op};
}
LabelCommand accent(std::string_view name, char32_t code) {
    return {.name = name, .kind = Kind::accent, .symbol = code};
}
LabelCommand space(std::string_view name, double mu) {
    return {.name = name, .kind = Kind::space, .space_mu = mu};
}
LabelCommand alphabet(std::string_view name, MathAlphabet which) {
    return {.name = name, .kind = Kind::alphabet, .alphabet = which};
}
LabelCommand text(std::string_view name, TextFace face) {
    return {.name = name, .kind = Kind::text, .face = face};
}
LabelCommand fraction(std::string_view name, MathAtom::FractionStyle style) {
    return {.name = name,
            .kind = Kind::fraction,
            .atom_class = AtomClass::inner,
            .fraction_style = style};
}

std::vector<LabelCommand> make_commands() {
    std::vector<LabelCommand> commands{
        // Greek; \phi and \epsilon are the closed and lunate forms, as in TeX.
        symbol("alpha", U'α'),
        symbol("beta", U'β'),
        symbol("gamma", U'γ'),
        symbol("delta", U'δ'),
        symbol("epsilon", U'ϵ'),
        symbol("varepsilon", U'ε'),
        symbol("zeta", U'ζ'),
        symbol("eta", U'η'),
        symbol("theta", U'θ'),
        symbol("vartheta", U'ϑ'),
        symbol("iota", U'ι'),
        symbol("kappa", U'κ'),
        symbol("lambda", U'λ'),
        symbol("mu", U'μ'),
        symbol("nu", U'ν'),
        symbol("xi", U'ξ'),
        symbol("pi", U'π'),
        symbol("varpi", U'ϖ'),
        symbol("rho", U'ρ'),
        symbol("varrho", U'ϱ'),
        symbol("sigma", U'σ'),
        symbol("varsigma", U'ς'),
        symbol("tau", U'τ'),
        symbol("upsilon", U'υ'),
        symbol("phi", U'ϕ'),
        symbol("varphi", U'φ'),
        symbol("chi", U'χ'),
        symbol("psi", U'ψ'),
        symbol("omega", U'ω'),
        symbol("Gamma", U'Γ'),
        symbol("Delta", U'Δ'),
        symbol("Theta", U'Θ'),
        symbol("Lambda", U'Λ'),
        symbol("Xi", U'Ξ'),
        symbol("Pi", U'Π'),
        symbol("Sigma", U'Σ'),
        symbol("Upsilon", U'Υ'),
        symbol("Phi", U'Φ'),
        symbol("Psi", U'Ψ'),
        symbol("Omega", U'Ω'),
        // Relations.
        rel("le", U'≤'),
        rel("leq", U'≤'),
        rel("ge", U'≥'),
        rel("geq", U'≥'),
        rel("ne", U'≠'),
        rel("neq", U'≠'),
        rel("approx", U'≈'),
        rel("equiv", U'≡'),
        rel("sim", U'∼'),
        rel("simeq", U'≃'),
        rel("propto", U'∝'),
        rel("ll", U'≪'),
        rel("gg", U'≫'),
        rel("to", U'→'),
        rel("rightarrow", U'→'),
        rel("leftarrow", U'←'),
        rel("leftrightarrow", U'↔'),
        rel("Rightarrow", U'⇒'),
        rel("Leftrightarrow", U'⇔'),
        rel("mapsto", U'↦'),
        rel("parallel", U'∥'),
        rel("perp", U'⟂'),
        rel("in", U'∈'),
        rel("mid", U'∣'),
        symbol("colon", U':', AtomClass::punct),
        // Binary operations.
        bin("pm", U'±'),
        bin("mp", U'∓'),
        bin("times", U'×'),
        bin("cdot", U'⋅'),
        bin("ast", U'∗'),
        bin("circ", U'∘'),
        bin("bullet", U'∙'),
        bin("div", U'÷'),
        bin("otimes", U'⊗'),
        bin("oplus", U'⊕'),
        bin("wedge", U'∧'),
        // Other symbols.
        symbol("infty", U'∞'),
        symbol("partial", U'∂'),
        symbol("nabla", U'∇'),
        symbol("hbar", U'ℏ'),
        symbol("ell", U'ℓ'),
        symbol("prime", U'′'),
        symbol("degree", U'°'),
        symbol("angle", U'∠'),
        symbol("forall", U'∀'),
        symbol("exists", U'∃'),
        symbol("vert", U'|'),
        symbol("|", U'‖'),
        symbol("Vert", U'‖'),
        symbol("lvert", U'|', AtomClass::open),
        symbol("rvert", U'|', AtomClass::close),
        symbol("lVert", U'‖', AtomClass::open),
        symbol("rVert", U'‖', AtomClass::close),
        symbol("backslash", U'\\'),
        symbol("{", U'{', AtomClass::open),
        symbol("}", U'}', AtomClass::close),
        symbol("lbrace", U'{', AtomClass::open),
        symbol("rbrace", U'}', AtomClass::close),
        symbol("langle", U'⟨', AtomClass::open),
        symbol("rangle", U'⟩', AtomClass::close),
        symbol("%", U'%'),
        symbol("$", U'$'),
        symbol("#", U'#'),
        symbol("&", U'&'),
        symbol("_", U'_'),
        symbol("dots", U'…', AtomClass::inner),
        symbol("ldots", U'…', AtomClass::inner),
        symbol("cdots", U'⋯', AtomClass::inner),
        // Large operators and functions.
        {.name = "sum", .kind = Kind::big, .symbol = U'∑', .atom_class = AtomClass::op},
        {.name = "prod", .kind = Kind::big, .symbol = U'∏', .atom_class = AtomClass::op},
        {.name = "int", .kind = Kind::integral, .symbol = U'∫', .atom_class = AtomClass::op},
        {.name = "oint", .kind = Kind::integral, .symbol = U'∮', .atom_class = AtomClass::op},
        function("sin"),
        function("cos"),
        function("tan"),
        function("arcsin"),
        function("arccos"),
        function("arctan"),
        function("sinh"),
        function("cosh"),
        function("tanh"),
        function("ln"),
        function("log"),
        function("exp"),
        function("max"),
        function("min"),
        function("det"),
        function("sn"),
        function("cn"),
        function("dn"),
        function("am"),
        function("tr"),
        function("diag"),
        // Alphabets and text.
        alphabet("mathbf", MathAlphabet::bold),
        alphabet("boldsymbol", MathAlphabet::bold_symbol),
        alphabet("bm", MathAlphabet::bold_symbol),
        alphabet("mathrm", MathAlphabet::upright),
        alphabet("mathit", MathAlphabet::italic),
        alphabet("mathcal", MathAlphabet::calligraphic),
        alphabet("mathbb", MathAlphabet::double_struck),
        text("text", TextFace::regular),
        text("textrm", TextFace::regular),
        text("textbf", TextFace::bold),
        text("textit", TextFace::italic),
        text("emph", TextFace::italic),
        // Structures.
        accent("dot", U'\u0307'),
        accent("ddot", U'\u0308'),
        accent("dddot", U'\u20DB'),
        accent("hat", U'\u0302'),
        accent("check", U'\u030C'),
        accent("tilde", U'\u0303'),
        accent("bar", U'\u0304'),
        accent("vec", U'\u20D7'),
        accent("acute", U'\u0301'),
        accent("grave", U'\u0300'),
        accent("breve", U'\u0306'),
        {.name = "overline", .kind = Kind::overline},
        {.name = "sqrt", .kind = Kind::radical},
        fraction("frac", MathAtom::FractionStyle::automatic),
        fraction("dfrac", MathAtom::FractionStyle::display),
        fraction("tfrac", MathAtom::FractionStyle::text),
        {.name = "left", .kind = Kind::left, .atom_class = AtomClass::inner},
        {.name = "right", .kind = Kind::right},
        {.name = "begin", .kind = Kind::begin, .atom_class = AtomClass::inner},
        {.name = "end", .kind = Kind::end},
        // Spaces in 1/18 em (The TeXbook, p. 167); "\ " is an interword space.
        space(",", 3),
        space(":", 4),
        space(">", 4),
        space(";", 5),
        space("!", -3),
        space(" ", 6),
        space("quad", 18),
        space("qquad", 36)};
    std::ranges::sort(commands, {}, &LabelCommand::name);
    return commands;
}

}  // namespace

const std::vector<LabelCommand>& label_commands() {
    static const std::vector<LabelCommand> commands = make_commands();
    return commands;
}

const LabelCommand* find_label_command(std::string_view name) {
    const auto& commands = label_commands();
    const auto found = std::ranges::lower_bound(commands, name, {}, &LabelCommand::name);
    return found != commands.end() && found->name == name ? &*found : nullptr;
}

LabelCharacter drawn_symbol(LabelCharacter character) {
    switch (character.code) {
        case U'-':
            character.code = U'\u2212';
            break;  // minus sign
        case U'*':
            character.code = U'\u2217';
            break;  // asterisk operator
        case U'\u00B7':
            character.code = U'\u22C5';
            break;  // middle dot: dot operator
        case U'\u00B5':
            character.code = U'μ';
            break;  // micro sign
        case U'\u2126':
            character.code = U'Ω';
            break;  // ohm sign
        default:
            break;
    }
    return character;
}

AtomClass symbol_class(char32_t drawn) {
    switch (drawn) {
        case U'(':
        case U'[':
        case U'{':
        case U'⟨':
            return AtomClass::open;
        case U')':
        case U']':
        case U'}':
        case U'⟩':
        case U'!':
        case U'?':
            return AtomClass::close;
        case U',':
        case U';':
            return AtomClass::punct;
        case U'…':
        case U'⋯':
            return AtomClass::inner;
        case U'=':
        case U'<':
        case U'>':
        case U':':
            return AtomClass::rel;
        case U'|':
        case U'‖':
            return AtomClass::ord;
        case U'+':
        case U'−':
            return AtomClass::bin;
        default:
            break;
    }
    for (const LabelCommand& command : label_commands()) {
        if (command.kind == CommandKind::symbol && command.symbol == drawn) {
            return command.atom_class;
        }
    }
    return AtomClass::ord;
}

}  // namespace poinsot
