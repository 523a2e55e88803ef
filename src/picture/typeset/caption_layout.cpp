#include "typeset/caption_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "typeset/math_layout.h"

namespace poinsot {
namespace {

// Digits such as ₁ in running text are set like scripts of a formula.
TypeBox set_script(const CaptionPiece& piece, double size_px, FontSet& fonts) {
    FontFile& math = fonts.math();
    const double px = size_px / math.units_per_em();
    const double part = math.constant(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN) / 100.0;
    const double shift = piece.script == CaptionPiece::Script::sub
                             ? -math.constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN)
                             : math.constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP);
    const TypeBox digits = fonts.set_text(piece.text, TextFamily::caption, part * size_px);
    TypeBox box;
    box.width = digits.width;
    box.place(digits, 0.0, shift * px);
    return box;
}

// Typesets a piece as parts between which a line may break; text is one part.
std::vector<FormulaPart> set_piece(const CaptionPiece& piece, double size_px, FontSet& fonts) {
    if (piece.kind == CaptionPiece::Kind::formula) {
        return set_formula_parts(piece.formula, {MathStyle::Level::text, false}, size_px, fonts);
    }
    std::vector<FormulaPart> one(1);
    one[0].box = piece.script != CaptionPiece::Script::none
                     ? set_script(piece, size_px, fonts)
                     : fonts.set_text(piece.text, TextFamily::caption, size_px);
    return one;
}

double space_width(TextFace face, double size_px, FontSet& fonts) {
    FontFile& font = fonts.text(TextFamily::caption, face);
    const std::optional<GlyphId> space = font.glyph(U' ');
    const double units = space ? font.metrics(*space).advance : font.units_per_em() / 3.0;
    return units * size_px / font.units_per_em();
}

class LineBreaker {
 public:
    LineBreaker(const TypeStyle& style, FontSet& fonts) : style_(style), fonts_(fonts) {}

    std::vector<TypeBox> lines(const Caption& caption) {
        for (const CaptionPiece& piece : caption) {
            if (piece.kind == CaptionPiece::Kind::space) {
                end_word();
                space_ = space_width(piece.text.face, style_.size_px, fonts_);
            } else if (piece.kind == CaptionPiece::Kind::line_break) {
                end_word();
                end_line();
            } else {
                join(set_piece(piece, style_.size_px, fonts_));
            }
        }
        end_word();
        // A line feed at the very end does not start a new line.
        if (has_line_) end_line();
        return std::move(lines_);
    }

 private:
    // Pieces without a space between them belong to one word.
    void join(std::vector<FormulaPart> parts) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (i > 0 || word_.empty()) {
                word_.push_back(std::move(parts[i]));
                continue;
            }
            FormulaPart& last = word_.back();
            last.box.place(parts[i].box, last.box.width, 0.0);
            last.box.width += parts[i].box.width;
            last.space_after = parts[i].space_after;
        }
    }

    // A word moves to the next line as a whole; a word wider than a line is broken between its
    // parts.
    void end_word() {
        if (word_.empty()) return;
        const double limit = style_.max_width_px;
        double whole = 0.0;
        for (std::size_t i = 0; i < word_.size(); ++i) {
            whole += word_[i].box.width + (i + 1 < word_.size() ? word_[i].space_after : 0.0);
        }
        const bool cut = limit > 0.0 && whole > limit;
        if (!cut) wrap_before(whole);
        for (const FormulaPart& part : word_) {
            if (cut) wrap_before(part.box.width);
            if (has_line_) line_.width += space_;
            line_.place(part.box, line_.width, 0.0);
            line_.width += part.box.width;
            has_line_ = true;
            space_ = part.space_after;
        }
        word_.clear();
        space_ = 0.0;
    }

    void wrap_before(double width) {
        const double limit = style_.max_width_px;
        if (has_line_ && limit > 0.0 && line_.width + space_ + width > limit) end_line();
    }

    void end_line() {
        lines_.push_back(std::exchange(line_, {}));
        has_line_ = false;
    }

    const TypeStyle& style_;
    FontSet& fonts_;
    std::vector<TypeBox> lines_;
    TypeBox line_;
    std::vector<FormulaPart> word_;
    bool has_line_ = false;
    double space_ = 0.0;
};

}  // namespace

SetCaption set_caption(const Caption& caption, const TypeStyle& style, FontSet& fonts) {
    const std::vector<TypeBox> lines = LineBreaker(style, fonts).lines(caption);
    SetCaption set;
    set.n_lines = static_cast<int>(lines.size());
    double width = 0.0;
    for (const TypeBox& line : lines) width = std::max(width, line.width);
    const double part = style.alignment == TypeAlignment::left     ? 0.0
                        : style.alignment == TypeAlignment::centre ? 0.5
                                                                   : 1.0;
    // Lines closer than a tenth of an em are moved apart.
    const double apart = 0.1 * style.size_px;
    double y = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0) {
            const double regular = style.line_spacing * style.size_px;
            const double needed = lines[i - 1].depth + lines[i].height + apart;
            y -= std::round(std::max(regular, needed));
        }
        set.box.place(lines[i], part * (width - lines[i].width), y);
    }
    set.box.width = width;
    return set;
}

}  // namespace poinsot
