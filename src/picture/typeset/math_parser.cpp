#include "typeset/math_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "text/nearest.h"

namespace poinsot {
namespace {

MathAtom make_atom(MathAtom::Kind kind, AtomClass atom_class, int column) {
    MathAtom atom;
    atom.kind = kind;
    atom.atom_class = atom_class;
    atom.column = column;
    return atom;
}

// Braces around one symbol without scripts give that symbol as an ordinary atom, so that scripts
// and accents treat it as a character (The TeXbook, p. 291).
MathAtom group(MathList body, int column) {
    if (body.size() == 1 && body[0].kind == MathAtom::Kind::symbol && !body[0].has_subscript &&
        !body[0].has_superscript) {
        MathAtom only = std::move(body[0]);
        only.atom_class = AtomClass::ord;
        return only;
    }
    MathAtom atom = make_atom(MathAtom::Kind::group, AtomClass::ord, column);
    atom.body = std::move(body);
    return atom;
}

bool is_accent_mark(char32_t c) {
    const bool combining = (c >= 0x300 && c < 0x370) || (c >= 0x20D0 && c < 0x2100);
    return combining && std::ranges::any_of(label_commands(), [c](const LabelCommand& command) {
               return command.kind == CommandKind::accent && command.symbol == c;
           });
}

}  // namespace

std::string unknown_command(const std::string& name) {
    constexpr std::size_t most_shown = 24;
    if (name.size() > most_shown)
        return fmt::format("unknown command \\{}…", name.substr(0, most_shown));
    // A single character that is not a letter could be anything, so the message does not repeat it.
    if (name.size() == 1 || static_cast<unsigned char>(name[0]) >= 0x80) {
        return "unknown command after the backslash; write \\backslash for a backslash";
    }
    // A name of one or two letters is similar to half of the table: no suggestion.
    if (name.size() < 3) return fmt::format("unknown command \\{}", name);
    return fmt::format("unknown command \\{}", name) +
           did_you_mean(name, names_of(label_commands()));
}

char32_t subscript_digit(char32_t c) { return c >= U'₀' && c <= U'₉' ? U'0' + c - U'₀' : 0; }

char32_t superscript_digit(char32_t c) {
    switch (c) {
        case U'⁰':
            return U'0';
        case U'¹':
            return U'1';
        case U'²':
            return U'2';
        case U'³':
            return U'3';
        default:
            return c >= U'⁴' && c <= U'⁹' ? U'4' + c - U'⁴' : 0;
    }
}

bool MathParser::at(End end) const {
    switch (end) {
        case End::label:
            return cursor_.at_end();
        case End::brace:
            return cursor_.peek() == U'}';
        case End::bracket:
            return cursor_.peek() == U']';
        case End::dollar:
            return cursor_.peek() == U'$';
        case End::right:
            return at_command(U"\\right");
        case End::cell:
            return cursor_.peek() == U'&' || at_command(U"\\end") ||
                   (cursor_.peek() == U'\\' && cursor_.peek(1) == U'\\');
    }
    return true;
}

bool MathParser::at_command(std::u32string_view command) const {
    for (std::size_t i = 0; i < command.size(); ++i) {
        if (cursor_.peek(i) != command[i]) return false;
    }
    const char32_t after = cursor_.peek(command.size());
    return !(after >= U'a' && after <= U'z') && !(after >= U'A' && after <= U'Z');
}

MathList MathParser::list(End end, int opened_at) {
    const LabelCursor::Nesting nesting(cursor_);
    MathList atoms;
    for (cursor_.skip_spaces(); !at(end); cursor_.skip_spaces()) {
        if (cursor_.at_end()) {
            const char* close = end == End::brace     ? "}"
                                : end == End::bracket ? "]"
                                : end == End::dollar  ? "$"
                                : end == End::cell    ? "\\end{pmatrix}"
                                                      : "\\right";
            cursor_.fail_expected(fmt::format("{} to close column {}", close, opened_at));
        }
        atoms.push_back(atom());
    }
    return atoms;
}

MathAtom MathParser::atom() {
    MathAtom made = nucleus();
    combining_marks(made);
    scripts(made);
    return made;
}

MathAtom MathParser::nucleus() {
    const int column = cursor_.column();
    const char32_t next = cursor_.peek();
    switch (next) {
        case U'{':
            return group(braced(), column);
        case U'\\':
            return command();
        case U'}':
            throw LabelError(column, "} closes nothing; remove it, or write \\} for a brace");
        case U'$':
            throw LabelError(
                column, "unexpected $: this is mathematics already; leave it out, or write \\$");
        case U'~': {
            cursor_.take();
            MathAtom space = make_atom(MathAtom::Kind::space, AtomClass::ord, column);
            space.space_mu = find_label_command(" ")->space_mu;
            return space;
        }
        case U'_':
        case U'^':
        case U'\'':
            // Scripts before any symbol belong to an empty atom.
            return make_atom(MathAtom::Kind::group, AtomClass::ord, column);
        default:
            break;
    }
    if (subscript_digit(next) || superscript_digit(next)) {
        return make_atom(MathAtom::Kind::group, AtomClass::ord, column);
    }
    const LabelCharacter drawn = drawn_symbol(cursor_.take());
    return symbol(drawn, symbol_class(drawn.code));
}

MathAtom MathParser::symbol(LabelCharacter character, AtomClass atom_class) const {
    MathAtom atom = make_atom(MathAtom::Kind::symbol, atom_class, character.column);
    atom.symbol = in_alphabet(character.code, alphabet_);
    return atom;
}

MathAtom MathParser::command() {
    const int column = cursor_.column();
    cursor_.take();
    const std::string name = cursor_.take_command_name();
    const LabelCommand* known = find_label_command(name);
    if (!known) throw LabelError(column, unknown_command(name));
    return run_command(*known, column);
}

MathAtom MathParser::run_command(const LabelCommand& command, int column) {
    MathAtom atom = make_atom(MathAtom::Kind::group, command.atom_class, column);
    const std::string after = fmt::format("an argument of \\{}", command.name);
    switch (command.kind) {
        case CommandKind::symbol:
            return symbol({command.symbol, column}, command.atom_class);
        case CommandKind::function_name:
            return function_name(command, column);
        case CommandKind::text:
            return text(command, column);
        case CommandKind::radical:
            return radical(column);
        case CommandKind::left:
            return fence(column);
        case CommandKind::right:
            throw LabelError(column, "\\right without \\left; write \\left before its delimiter");
        case CommandKind::begin:
            return matrix(column);
        case CommandKind::end:
            throw LabelError(column, "\\end without \\begin; write \\begin{pmatrix} before it");
        case CommandKind::big:
        case CommandKind::integral:
            atom.kind =
                command.kind == CommandKind::big ? MathAtom::Kind::big : MathAtom::Kind::integral;
            atom.symbol = command.symbol;
            return atom;
        case CommandKind::alphabet: {
            const MathAlphabet outer = std::exchange(alphabet_, command.alphabet);
            atom = group(argument(after), column);
            alphabet_ = outer;
            return atom;
        }
        case CommandKind::accent:
            atom.kind = MathAtom::Kind::accent;
            atom.symbol = command.symbol;
            atom.body = argument(after);
            return atom;
        case CommandKind::overline:
            atom.kind = MathAtom::Kind::overline;
            atom.body = argument(after);
            return atom;
        case CommandKind::fraction:
            atom.kind = MathAtom::Kind::fraction;
            atom.fraction_style = command.fraction_style;
            atom.body = argument(fmt::format("the numerator of \\{}", command.name));
            atom.second = argument(fmt::format("the denominator of \\{}", command.name));
            return atom;
        case CommandKind::space:
            atom.kind = MathAtom::Kind::space;
            atom.space_mu = command.space_mu;
            return atom;
    }
    return atom;
}

// The name of a function is upright text.
MathAtom MathParser::function_name(const LabelCommand& command, int column) {
    MathAtom atom = make_atom(MathAtom::Kind::text, AtomClass::op, column);
    for (const char letter : command.name) {
        atom.text.characters.push_back({static_cast<unsigned char>(letter), column});
    }
    return atom;
}

// \text{…} takes its characters literally; a backslash before a special character makes it literal.
MathAtom MathParser::text(const LabelCommand& command, int column) {
    if (cursor_.peek() != U'{') cursor_.fail_expected(fmt::format("{{ after \\{}", command.name));
    const int opened_at = cursor_.take().column;
    MathAtom atom = make_atom(MathAtom::Kind::text, AtomClass::ord, column);
    atom.text.face = command.face;
    while (cursor_.peek() != U'}') {
        if (cursor_.at_end())
            cursor_.fail_expected(fmt::format("}} to close column {}", opened_at));
        LabelCharacter taken = cursor_.take();
        if (taken.code == U'{' || taken.code == U'$') {
            throw LabelError(taken.column,
                             fmt::format("{} does not stand within \\{}; write \\{}",
                                         describe(taken.code), command.name, describe(taken.code)));
        }
        if (taken.code == U'\\') {
            const std::u32string_view special = U"$%&#_{} ";
            if (special.find(cursor_.peek()) == std::u32string_view::npos || cursor_.at_end()) {
                cursor_.fail_expected(fmt::format(
                    "one of $ % & # _ {{ }} after the backslash in \\{}", command.name));
            }
            taken.code = cursor_.take().code;
        }
        if (taken.code == U'\n' || taken.code == U'\t') taken.code = U' ';
        if (taken.code == U'~') taken.code = U'\u00A0';
        atom.text.characters.push_back(taken);
    }
    cursor_.take();
    return atom;
}

MathAtom MathParser::radical(int column) {
    MathAtom atom = make_atom(MathAtom::Kind::radical, AtomClass::ord, column);
    cursor_.skip_spaces();
    if (cursor_.peek() == U'[') {
        const int opened_at = cursor_.take().column;
        atom.second = list(End::bracket, opened_at);
        cursor_.take();
    }
    atom.body = argument("an argument of \\sqrt");
    return atom;
}

MathAtom MathParser::fence(int column) {
    MathAtom atom = make_atom(MathAtom::Kind::fence, AtomClass::inner, column);
    atom.open = delimiter();
    atom.body = list(End::right, column);
    cursor_.take();
    cursor_.take_command_name();
    atom.close = delimiter();
    return atom;
}

// \begin{pmatrix} has been read up to its name; the atom is a matrix between parentheses.
MathAtom MathParser::matrix(int column) {
    environment("\\begin");
    MathAtom cells = make_atom(MathAtom::Kind::matrix, AtomClass::ord, column);
    cells.rows.emplace_back();
    for (;;) {
        cells.rows.back().push_back(list(End::cell, column));
        if (cursor_.peek() == U'&') {
            cursor_.take();
        } else if (at_command(U"\\end")) {
            break;
        } else {
            cursor_.take();
            cursor_.take();
            cells.rows.emplace_back();
        }
    }
    cursor_.take();
    cursor_.take_command_name();
    environment("\\end");
    // \\ after the last row does not begin another one.
    if (cells.rows.size() > 1 && cells.rows.back().size() == 1 && cells.rows.back()[0].empty())
        cells.rows.pop_back();
    MathAtom atom = make_atom(MathAtom::Kind::fence, AtomClass::inner, column);
    atom.open = U'(';
    atom.close = U')';
    atom.body.push_back(std::move(cells));
    return atom;
}

// The only environment.
void MathParser::environment(const std::string& after) {
    cursor_.skip_spaces();
    constexpr std::u32string_view name = U"{pmatrix}";
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (cursor_.peek(i) != name[i])
            cursor_.fail_expected(fmt::format("{{pmatrix}} after {}", after));
    }
    for (std::size_t i = 0; i < name.size(); ++i) cursor_.take();
}

char32_t MathParser::delimiter() {
    cursor_.skip_spaces();
    const int column = cursor_.column();
    char32_t code = cursor_.take().code;
    if (code == U'.') return 0;
    if (code == U'\\' && !cursor_.at_end()) {
        const LabelCommand* command = find_label_command(cursor_.take_command_name());
        code = command && command->kind == CommandKind::symbol ? command->symbol : 0;
    }
    const std::u32string_view delimiters = U"()[]{}|‖⟨⟩/";
    if (code == 0 || delimiters.find(code) == std::u32string_view::npos) {
        throw LabelError(column,
                         "expected a delimiter, one of ( ) [ ] \\{ \\} | \\| \\langle \\rangle / "
                         "or . for none");
    }
    return code;
}

MathList MathParser::braced() {
    const int opened_at = cursor_.take().column;
    MathList body = list(End::brace, opened_at);
    cursor_.take();
    return body;
}

// An argument: a group, or the next symbol or command.
MathList MathParser::argument(const std::string& what) {
    cursor_.skip_spaces();
    const char32_t next = cursor_.peek();
    if (next == U'{') return braced();
    const LabelCursor::Nesting nesting(cursor_);
    if (next == 0 || next == U'}' || next == U'$' || next == U'_' || next == U'^' ||
        next == U'\'') {
        cursor_.fail_expected(what);
    }
    MathList one;
    one.push_back(nucleus());
    return one;
}

// Unicode combining marks, as in a pasted ω̇, are accents of the preceding symbol.
void MathParser::combining_marks(MathAtom& atom) {
    for (int n_marks = 0; is_accent_mark(cursor_.peek()); ++n_marks) {
        if (n_marks == label_nesting_limit) {
            throw LabelError(cursor_.column(), "too many accents on one symbol; remove some");
        }
        const LabelCharacter mark = cursor_.take();
        MathAtom accent = make_atom(MathAtom::Kind::accent, AtomClass::ord, mark.column);
        accent.symbol = mark.code;
        accent.body.push_back(std::move(atom));
        atom = std::move(accent);
    }
}

void MathParser::scripts(MathAtom& atom) {
    for (cursor_.skip_spaces(); !cursor_.at_end(); cursor_.skip_spaces()) {
        const char32_t next = cursor_.peek();
        const int column = cursor_.column();
        if (next == U'\'') {
            primes(atom);
        } else if (subscript_digit(next) || superscript_digit(next)) {
            script_digits(atom);
        } else if (next == U'_') {
            if (atom.has_subscript) {
                throw LabelError(column, "a second subscript; put both in braces: _{…}");
            }
            cursor_.take();
            atom.subscript = argument("a subscript after _");
            atom.has_subscript = true;
        } else if (next == U'^') {
            // Primes come first in a superscript: f'^2.
            const bool only_primes = atom.has_superscript && !atom.superscript.empty() &&
                                     atom.superscript.back().symbol == U'′';
            if (atom.has_superscript && !only_primes) {
                throw LabelError(column, "a second superscript; put both in braces: ^{…}");
            }
            cursor_.take();
            MathList raised = argument("a superscript after ^");
            for (MathAtom& each : raised) atom.superscript.push_back(std::move(each));
            atom.has_superscript = true;
        } else {
            return;
        }
    }
}

void MathParser::primes(MathAtom& atom) {
    if (atom.has_superscript) {
        throw LabelError(cursor_.column(), "a prime after a superscript; write it before the ^");
    }
    while (cursor_.peek() == U'\'') {
        const int column = cursor_.take().column;
        MathAtom& prime = atom.superscript.emplace_back(
            make_atom(MathAtom::Kind::symbol, AtomClass::ord, column));
        prime.symbol = U'′';
    }
    atom.has_superscript = true;
}

// Unicode script digits such as ₁₂ and ², often pasted.
void MathParser::script_digits(MathAtom& atom) {
    const bool below = subscript_digit(cursor_.peek()) != 0;
    if (below ? atom.has_subscript : atom.has_superscript) {
        throw LabelError(cursor_.column(), below
                                               ? "a second subscript; put both in braces: _{…}"
                                               : "a second superscript; put both in braces: ^{…}");
    }
    (below ? atom.has_subscript : atom.has_superscript) = true;
    MathList& digits = below ? atom.subscript : atom.superscript;
    const auto digit = [below](char32_t c) {
        return below ? subscript_digit(c) : superscript_digit(c);
    };
    while (digit(cursor_.peek())) {
        const LabelCharacter taken = cursor_.take();
        digits.push_back(symbol({digit(taken.code), taken.column}, AtomClass::ord));
    }
}

}  // namespace poinsot
