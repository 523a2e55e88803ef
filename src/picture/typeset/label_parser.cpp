#include "typeset/label_parser.h"

#include <fmt/format.h>

#include <utility>

#include "typeset/math_parser.h"

namespace poinsot {
namespace {

bool is_relation(char32_t c) {
    return c == U'=' || c == U'<' || c == U'>' || c == U'≈' || c == U'≤' || c == U'≥';
}

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }

class CaptionParser {
 public:
    explicit CaptionParser(std::string_view caption) : cursor_(caption) {}

    Caption parse() {
        pieces(0);
        while (!caption_.empty() && caption_.back().kind == CaptionPiece::Kind::space) {
            caption_.pop_back();
        }
        return std::move(caption_);
    }

 private:
    // Reads up to the brace that closes the one at opened_at, or to the end if opened_at is 0.
    void pieces(int opened_at) {
        const LabelCursor::Nesting nesting(cursor_);
        while (!cursor_.at_end()) {
            switch (cursor_.peek()) {
                case U'}':
                    if (opened_at) return;
                    throw LabelError(cursor_.column(),
                                     "} closes nothing; remove it, or write \\} for a brace");
                case U'{':
                    group();
                    break;
                case U'$':
                    formula();
                    break;
                case U'\\':
                    command();
                    break;
                default:
                    character();
                    break;
            }
        }
        if (opened_at) cursor_.fail_expected(fmt::format("}} to close column {}", opened_at));
    }

    void group() {
        const int opened_at = cursor_.take().column;
        pieces(opened_at);
        cursor_.take();
    }

    void formula() {
        const int opened_at = cursor_.take().column;
        CaptionPiece& piece = add(CaptionPiece::Kind::formula);
        piece.formula = MathParser(cursor_).list(MathParser::End::dollar, opened_at);
        cursor_.take();
    }

    void command() {
        const int column = cursor_.take().column;
        if (cursor_.peek() == U'\\') {
            cursor_.take();
            line_break();
            return;
        }
        const std::string name = cursor_.take_command_name();
        constexpr std::string_view special_characters = "$%&#_{}";
        if (name.size() == 1 && special_characters.find(name[0]) != std::string_view::npos) {
            append({static_cast<unsigned char>(name[0]), column});
            return;
        }
        const LabelCommand* known = find_label_command(name);
        if (name == " ") {
            append({U'\u00A0', column});
        } else if (known && known->kind == CommandKind::space) {
            // A command for a space is mathematics, even between words.
            CaptionPiece& piece = add(CaptionPiece::Kind::formula);
            MathAtom& space = piece.formula.emplace_back();
            space.kind = MathAtom::Kind::space;
            space.space_mu = known->space_mu;
            space.column = column;
        } else if (known && known->kind == CommandKind::text) {
            if (cursor_.peek() != U'{') cursor_.fail_expected(fmt::format("{{ after \\{}", name));
            const TextFace outer = std::exchange(face_, known->face);
            group();
            face_ = outer;
        } else if (known) {
            throw LabelError(column, fmt::format("\\{0} is mathematics; write it within dollar "
                                                 "signs: $\\{0}$",
                                                 name));
        } else {
            throw LabelError(column, unknown_command(name));
        }
    }

    void character() {
        const char32_t before = cursor_.previous();
        const LabelCharacter taken = cursor_.take();
        switch (taken.code) {
            case U' ':
            case U'\t':
                space();
                return;
            case U'\n':
                line_break();
                return;
            case U'~':
                append({U'\u00A0', taken.column});
                return;
            case U'-':
                append({dash(before), taken.column});
                return;
            case U'`':
                append({doubled(U'`') ? U'“' : U'‘', taken.column});
                return;
            case U'\'':
                append({doubled(U'\'') ? U'”' : U'’', taken.column});
                return;
            default:
                break;
        }
        if (const char32_t below = subscript_digit(taken.code)) {
            append({below, taken.column}, CaptionPiece::Script::sub);
        } else if (const char32_t above = superscript_digit(taken.code)) {
            append({above, taken.column}, CaptionPiece::Script::super);
        } else {
            append(taken);
        }
    }

    // -- and --- are dashes; a hyphen at the beginning of a number is a minus sign, for numbers
    // inserted into captions.
    char32_t dash(char32_t before) {
        if (doubled(U'-')) return doubled(U'-') ? U'—' : U'–';
        const bool begins = before == 0 || before == U' ' || before == U'\n' || before == U'\t' ||
                            before == U'(' || before == U'[' || before == U'=' || before == U'~';
        const bool number =
            is_digit(cursor_.peek()) || (cursor_.peek() == U'.' && is_digit(cursor_.peek(1)));
        return begins && number ? U'\u2212' : U'-';
    }

    bool doubled(char32_t c) {
        if (cursor_.peek() != c) return false;
        cursor_.take();
        return true;
    }

    // Whether the space just read is next to a relation: t = 1.25 is not broken over two lines.
    bool beside_relation() const {
        const bool after_word =
            !caption_.empty() && (caption_.back().kind == CaptionPiece::Kind::text ||
                                  caption_.back().kind == CaptionPiece::Kind::formula);
        if (!after_word) return false;
        const char32_t before = cursor_.previous(2), after = cursor_.peek();
        const bool follows = is_relation(before) && caption_.back().text.characters.size() > 1 &&
                             cursor_.previous(3) == U' ' && after != U' ';
        return follows || (is_relation(after) && cursor_.peek(1) == U' ' && before != U' ');
    }

    void space() {
        if (beside_relation()) {
            append({U'\u00A0', cursor_.column() - 1});
            return;
        }
        if (caption_.empty() || caption_.back().kind == CaptionPiece::Kind::space ||
            caption_.back().kind == CaptionPiece::Kind::line_break) {
            return;
        }
        add(CaptionPiece::Kind::space);
    }

    void line_break() {
        if (!caption_.empty() && caption_.back().kind == CaptionPiece::Kind::space) {
            caption_.pop_back();
        }
        add(CaptionPiece::Kind::line_break);
    }

    CaptionPiece& add(CaptionPiece::Kind kind) {
        CaptionPiece& piece = caption_.emplace_back();
        piece.kind = kind;
        piece.text.face = face_;
        return piece;
    }

    void append(LabelCharacter character,
                CaptionPiece::Script script = CaptionPiece::Script::none) {
        const bool extends = !caption_.empty() && caption_.back().script == script &&
                             caption_.back().kind == CaptionPiece::Kind::text &&
                             caption_.back().text.face == face_;
        if (!extends) {
            add(CaptionPiece::Kind::text).script = script;
        }
        caption_.back().text.characters.push_back(character);
    }

    LabelCursor cursor_;
    Caption caption_;
    TextFace face_ = TextFace::regular;
};

}  // namespace

MathList parse_math(std::string_view label) {
    LabelCursor cursor(label);
    return MathParser(cursor).list(MathParser::End::label, 1);
}

Caption parse_caption(std::string_view caption) { return CaptionParser(caption).parse(); }

}  // namespace poinsot
