#include "typeset/math_layout.h"

#include <algorithm>
#include <utility>

#include "typeset/math_style.h"

namespace poinsot {
namespace {

using Level = MathStyle::Level;

// An atom without its scripts, and the data needed to place scripts and accents.
struct Nucleus {
    TypeBox box;
    double italic = 0.0;        // italic correction: overhang of a slanted glyph beyond the width
    bool is_character = false;  // scripts use the font's shifts, independent of the height
    double attachment = 0.0;    // x of the middle of an accent above it
};

class FormulaSetter {
 public:
    FormulaSetter(double size_px, FontSet& fonts)
        : size_px_(size_px), fonts_(fonts), font_(fonts.math()) {}

    TypeBox list(const MathList& atoms, MathStyle style) {
        return std::move(parts(atoms, style, false).front().box);
    }

    // Typesets the list in one part, or cut after each of its relations.
    std::vector<FormulaPart> parts(const MathList& atoms, MathStyle style, bool cut) {
        std::vector<FormulaPart> made(1);
        const std::vector<AtomClass> classes = spacing_classes(atoms);
        const AtomClass* before = nullptr;
        for (std::size_t i = 0; i < atoms.size(); ++i) {
            const MathAtom& atom = atoms[i];
            if (atom.kind == MathAtom::Kind::space) {
                made.back().box.width += atom.space_mu * mu(style);
                continue;
            }
            const double space = before ? spacing_mu(*before, classes[i], style) * mu(style) : 0.0;
            if (cut && before && *before == AtomClass::rel && classes[i] != AtomClass::rel) {
                made.back().space_after = space;
                made.emplace_back();
            } else {
                made.back().box.width += space;
            }
            before = &classes[i];
            TypeBox set = with_scripts(atom, style);
            if (atom.tint != 0)
                for (PlacedGlyph& placed : set.glyphs) placed.tint = atom.tint;
            TypeBox& box = made.back().box;
            box.place(set, box.width, 0.0);
            box.width += set.width;
        }
        return made;
    }

 private:
    // Sizes -------------------------------------------------------------------------------------

    double size(MathStyle style) const {
        if (style.level == Level::script) {
            return size_px_ * font_.constant(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN) / 100.0;
        }
        if (style.level == Level::script_script) {
            return size_px_ * font_.constant(HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN) /
                   100.0;
        }
        return size_px_;
    }
    double scale(MathStyle style) const { return size(style) / font_.units_per_em(); }
    double mu(MathStyle style) const { return size(style) / 18.0; }
    double constant(hb_ot_math_constant_t which, MathStyle style) const {
        return font_.constant(which) * scale(style);
    }
    static bool is_display(MathStyle style) { return style.level == Level::display; }

    // Characters --------------------------------------------------------------------------------

    GlyphId glyph(char32_t character, int column, MathStyle style) {
        const int level = style.level == Level::script          ? 1
                          : style.level == Level::script_script ? 2
                                                                : 0;
        const std::optional<GlyphId> found = font_.script_glyph(character, level);
        if (!found) fail_missing_glyph(character, column);
        return *found;
    }

    Nucleus character(GlyphId id, MathStyle style) {
        const double px = scale(style);
        const GlyphMetrics& metrics = font_.metrics(id);
        Nucleus made;
        made.box.width = metrics.advance * px;
        made.box.height = metrics.height * px;
        made.box.depth = metrics.depth * px;
        made.box.glyphs.push_back({&font_, id, 0.0, 0.0, px});
        made.italic = metrics.italic_correction * px;
        made.attachment = metrics.accent_attachment * px;
        made.is_character = true;
        return made;
    }

    // A character that the math font lacks, upright like the text of a formula: from a fallback
    // font, or as a box.
    Nucleus lent(const MathAtom& atom, MathStyle style) {
        const TextRun run{TextFace::regular, {{atom.symbol, atom.column}}};
        return boxed(fonts_.set_text(run, TextFamily::formula, size(style)));
    }

    // Centres a glyph of at least min_height px on the math axis.
    TypeBox tall(char32_t code, int column, double min_height, MathStyle style) {
        const double px = scale(style);
        const TallGlyph tall = font_.tall_glyph(glyph(code, column, style), min_height / px);
        const double axis = constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT, style);
        TypeBox box;
        const double bottom = axis - 0.5 * tall.extent * px;
        for (const ShapedGlyph& piece : tall.pieces) {
            box.glyphs.push_back({&font_, piece.glyph, 0.0, bottom + piece.y * px, px});
            box.width = std::max(box.width, font_.metrics(piece.glyph).advance * px);
        }
        box.height = bottom + tall.extent * px;
        box.depth = -bottom;
        return box;
    }

    // Nuclei ------------------------------------------------------------------------------------

    Nucleus nucleus(const MathAtom& atom, MathStyle style) {
        switch (atom.kind) {
            case MathAtom::Kind::symbol:
                if (!font_.glyph(atom.symbol)) return lent(atom, style);
                return character(glyph(atom.symbol, atom.column, style), style);
            case MathAtom::Kind::group:
                return boxed(list(atom.body, style));
            case MathAtom::Kind::text:
                return boxed(fonts_.set_text(atom.text, TextFamily::formula, size(style)));
            case MathAtom::Kind::big:
            case MathAtom::Kind::integral:
                return large_operator(atom, style);
            case MathAtom::Kind::radical:
                return boxed(radical(atom, style));
            case MathAtom::Kind::fraction:
                return boxed(fraction(atom, style));
            case MathAtom::Kind::accent:
                return accent(atom, style);
            case MathAtom::Kind::overline:
                return boxed(overline(atom, style));
            case MathAtom::Kind::fence:
                return boxed(fence(atom, style));
            case MathAtom::Kind::matrix:
                return boxed(matrix(atom, style));
            case MathAtom::Kind::space:
                break;
        }
        return {};
    }

    static Nucleus boxed(TypeBox box) {
        Nucleus made;
        made.attachment = 0.5 * box.width;
        made.box = std::move(box);
        return made;
    }

    // A body of one character without scripts keeps the properties of the character.
    Nucleus body(const MathList& atoms, MathStyle style) {
        if (atoms.size() == 1 && !atoms[0].has_subscript && !atoms[0].has_superscript) {
            return nucleus(atoms[0], style);
        }
        return boxed(list(atoms, style));
    }

    Nucleus large_operator(const MathAtom& atom, MathStyle style) {
        const double least = is_display(style)
                                 ? constant(HB_OT_MATH_CONSTANT_DISPLAY_OPERATOR_MIN_HEIGHT, style)
                                 : 0.0;
        Nucleus made = boxed(tall(atom.symbol, atom.column, least, style));
        made.italic = font_.metrics(made.box.glyphs.front().glyph).italic_correction * scale(style);
        // Subscripts of an integral are moved left, below its slant.
        if (atom.kind == MathAtom::Kind::integral) made.box.width -= made.italic;
        return made;
    }

    TypeBox radical(const MathAtom& atom, MathStyle style) {
        const TypeBox inside = list(atom.body, cramped(style));
        const double rule = constant(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS, style);
        double gap =
            constant(is_display(style) ? HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP
                                       : HB_OT_MATH_CONSTANT_RADICAL_VERTICAL_GAP,
                     style);
        const double px = scale(style);
        const double needed = inside.height + inside.depth + gap + rule;
        const TallGlyph sign = font_.tall_glyph(glyph(U'√', atom.column, style), needed / px);
        // The excess height of the sign is distributed equally above and below.
        const double excess = std::max(0.0, sign.extent * px - needed);
        gap += 0.5 * excess;
        const double top = inside.height + gap + rule;

        TypeBox box;
        double sign_width = 0.0;
        for (const ShapedGlyph& piece : sign.pieces) {
            box.glyphs.push_back(
                {&font_, piece.glyph, 0.0, top + (piece.y - sign.extent) * px, px});
            sign_width = std::max(sign_width, font_.metrics(piece.glyph).advance * px);
        }
        const double sign_x = degree_width(atom, style, sign.extent * px, top, box);
        for (std::size_t i = 0; i < sign.pieces.size(); ++i) box.glyphs[i].x += sign_x;
        box.rules.push_back(
            {sign_x + sign_width, top - rule, inside.width, rule, 0, sign.pieces.size()});
        box.place(inside, sign_x + sign_width, 0.0);
        box.width = sign_x + sign_width + inside.width;
        box.height =
            std::max(box.height, top + constant(HB_OT_MATH_CONSTANT_RADICAL_EXTRA_ASCENDER, style));
        box.depth = std::max(box.depth, sign.extent * px - top);
        return box;
    }

    // Places a root's degree into the box and returns how far it moves the sign to the right.
    double degree_width(const MathAtom& atom, MathStyle style, double sign_extent, double top,
                        TypeBox& box) {
        if (atom.second.empty()) return 0.0;
        const TypeBox degree = list(atom.second, {Level::script_script, true});
        const double before = constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_BEFORE_DEGREE, style);
        const double after = constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_AFTER_DEGREE, style);
        const double raise =
            font_.constant(HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT) / 100.0;
        const double x = std::max(before, -(degree.width + after));
        box.place(degree, x, top - sign_extent + raise * sign_extent + degree.depth);
        return x + degree.width + after;
    }

    TypeBox fraction(const MathAtom& atom, MathStyle outer) {
        MathStyle style = outer;
        if (atom.fraction_style == MathAtom::FractionStyle::display) style.level = Level::display;
        if (atom.fraction_style == MathAtom::FractionStyle::text) style.level = Level::text;
        const bool display = is_display(style);
        const TypeBox above = list(atom.body, numerator_style(style));
        const TypeBox below = list(atom.second, denominator_style(style));
        const double axis = constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT, style);
        const double rule = constant(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS, style);
        double up = constant(display ? HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP
                                     : HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_SHIFT_UP,
                             style);
        double down =
            constant(display ? HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_DISPLAY_STYLE_SHIFT_DOWN
                             : HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_SHIFT_DOWN,
                     style);
        const double gap_above =
            constant(display ? HB_OT_MATH_CONSTANT_FRACTION_NUM_DISPLAY_STYLE_GAP_MIN
                             : HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_GAP_MIN,
                     style);
        const double gap_below =
            constant(display ? HB_OT_MATH_CONSTANT_FRACTION_DENOM_DISPLAY_STYLE_GAP_MIN
                             : HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_GAP_MIN,
                     style);
        // Minimum clearance of both parts from the rule (appendix G, rule 15d).
        up = std::max(up, axis + 0.5 * rule + gap_above + above.depth);
        down = std::max(down, below.height + gap_below + 0.5 * rule - axis);

        // TeX's \nulldelimiterspace separates fractions from their neighbours.
        const double side = 0.12 * size(style);
        const double width = std::max(above.width, below.width);
        TypeBox box;
        box.place(above, side + 0.5 * (width - above.width), up);
        box.place(below, side + 0.5 * (width - below.width), -down);
        box.rules.push_back({side, axis - 0.5 * rule, width, rule, 0, 0});
        box.width = width + 2.0 * side;
        return box;
    }

    // Appendix G, rule 12, with OpenType's attachment points instead of kerns.
    Nucleus accent(const MathAtom& atom, MathStyle style) {
        Nucleus base = body(atom.body, cramped(style));
        const GlyphId mark = glyph(atom.symbol, atom.column, style);
        const GlyphMetrics& metrics = font_.metrics(mark);
        const double px = scale(style);
        const double raise = std::max(
            0.0, base.box.height - constant(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT, style));
        const double x = base.attachment - metrics.accent_attachment * px;
        base.box.glyphs.push_back({&font_, mark, x, raise, px});
        // Accents do not raise scripts; only the box grows.
        base.box.height = std::max(base.box.height, raise + metrics.height * px);
        return base;
    }

    TypeBox overline(const MathAtom& atom, MathStyle style) {
        TypeBox box = list(atom.body, cramped(style));
        const double rule = constant(HB_OT_MATH_CONSTANT_OVERBAR_RULE_THICKNESS, style);
        const double y = box.height + constant(HB_OT_MATH_CONSTANT_OVERBAR_VERTICAL_GAP, style);
        box.rules.push_back({0.0, y, box.width, rule, 0, 0});
        box.height = y + rule + constant(HB_OT_MATH_CONSTANT_OVERBAR_EXTRA_ASCENDER, style);
        return box;
    }

    // Delimiters cover nine tenths of their content, or all but half an em of it (The TeXbook, p.
    // 152: \delimiterfactor and \delimitershortfall).
    TypeBox fence(const MathAtom& atom, MathStyle style) {
        const TypeBox inside = list(atom.body, style);
        const double axis = constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT, style);
        const double whole = 2.0 * std::max(inside.height - axis, inside.depth + axis);
        const double wanted = std::max(0.901 * whole, whole - 0.5 * size(style));
        TypeBox box;
        const auto delimiter = [&](char32_t code) {
            if (!code) return;
            const TypeBox set = tall(code, atom.column, wanted, style);
            box.place(set, box.width, 0.0);
            box.width += set.width;
        };
        delimiter(atom.open);
        box.place(inside, box.width, 0.0);
        box.width += inside.width;
        delimiter(atom.close);
        return box;
    }

    // Centred columns, as TeX's \matrix sets them: an em apart, lines of at least 1.2 em, centred
    // on the math axis (The TeXbook, p. 361).
    TypeBox matrix(const MathAtom& atom, MathStyle outer) {
        MathStyle style = outer;
        if (is_display(style)) style.level = Level::text;
        const double em = size(style);
        std::vector<std::vector<TypeBox>> cells;
        std::vector<double> widths, heights, depths;
        for (const std::vector<MathList>& row : atom.rows) {
            cells.emplace_back();
            heights.push_back(0.84 * em);
            depths.push_back(0.36 * em);
            widths.resize(std::max(widths.size(), row.size()), 0.0);
            for (std::size_t i = 0; i < row.size(); ++i) {
                const TypeBox& cell = cells.back().emplace_back(list(row[i], style));
                widths[i] = std::max(widths[i], cell.width);
                heights.back() = std::max(heights.back(), cell.height);
                depths.back() = std::max(depths.back(), cell.depth);
            }
        }
        double extent = 0.0;
        for (std::size_t k = 0; k < cells.size(); ++k) extent += heights[k] + depths[k];

        const double axis = constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT, style);
        TypeBox box;
        double y = axis + 0.5 * extent;
        box.height = y;
        box.depth = 0.5 * extent - axis;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            y -= heights[k];
            double x = 0.0;
            for (std::size_t i = 0; i < cells[k].size(); ++i) {
                box.place(cells[k][i], x + 0.5 * (widths[i] - cells[k][i].width), y);
                x += widths[i] + em;
            }
            y -= depths[k];
        }
        for (std::size_t i = 0; i < widths.size(); ++i) box.width += widths[i] + (i > 0 ? em : 0.0);
        return box;
    }

    // Scripts -----------------------------------------------------------------------------------

    TypeBox with_scripts(const MathAtom& atom, MathStyle style) {
        Nucleus base = nucleus(atom, style);
        if (!atom.has_subscript && !atom.has_superscript) {
            // Adds the italic correction, so that a slanted letter does not touch its neighbour
            // (appendix G, rule 17).
            base.box.width += base.italic;
            return std::move(base.box);
        }
        if (atom.kind == MathAtom::Kind::big && is_display(style)) return limits(atom, base, style);

        const TypeBox above = list(atom.superscript, superscript_style(style));
        const TypeBox below = list(atom.subscript, subscript_style(style));
        double up = atom.has_superscript ? superscript_shift(base, above, style) : 0.0;
        double down = atom.has_subscript ? subscript_shift(base, below, style) : 0.0;
        if (atom.has_superscript && atom.has_subscript) {
            part_scripts(up, down, above, below, style);
        } else if (atom.has_subscript) {
            const double top = constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_TOP_MAX, style);
            down = std::max(down, below.height - top);
        }
        TypeBox box = std::move(base.box);
        const double width = box.width;
        double end = width;
        if (atom.has_superscript) {
            box.place(above, width + base.italic, up);
            end = std::max(end, width + base.italic + above.width);
        }
        if (atom.has_subscript) {
            box.place(below, width, -down);
            end = std::max(end, width + below.width);
        }
        box.width = end + constant(HB_OT_MATH_CONSTANT_SPACE_AFTER_SCRIPT, style);
        return box;
    }

    double superscript_shift(const Nucleus& base, const TypeBox& above, MathStyle style) const {
        double up = constant(style.cramped ? HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED
                                           : HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP,
                             style);
        if (!base.is_character) {
            const double drop = constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BASELINE_DROP_MAX, style);
            up = std::max(up, base.box.height - drop);
        }
        const double bottom = constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MIN, style);
        return std::max(up, above.depth + bottom);
    }

    double subscript_shift(const Nucleus& base, const TypeBox&, MathStyle style) const {
        double down = constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN, style);
        if (!base.is_character) {
            const double drop = constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_BASELINE_DROP_MIN, style);
            down = std::max(down, base.box.depth + drop);
        }
        return down;
    }

    // Ensures a gap between superscript and subscript (appendix G, rule 18e).
    void part_scripts(double& up, double& down, const TypeBox& above, const TypeBox& below,
                      MathStyle style) const {
        const double least = constant(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN, style);
        const double gap = (up - above.depth) - (below.height - down);
        if (gap >= least) return;
        down += least - gap;
        const double bottom =
            constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MAX_WITH_SUBSCRIPT, style);
        const double lift = bottom - (up - above.depth);
        if (lift > 0.0) {
            up += lift;
            down -= lift;
        }
    }

    // Places the scripts above and below a large operator (appendix G, rule 13a).
    TypeBox limits(const MathAtom& atom, const Nucleus& base, MathStyle style) {
        const TypeBox above = list(atom.superscript, superscript_style(style));
        const TypeBox below = list(atom.subscript, subscript_style(style));
        const double width = std::max({base.box.width, above.width, below.width});
        TypeBox box;
        box.width = width;
        box.place(base.box, 0.5 * (width - base.box.width), 0.0);
        if (atom.has_superscript) {
            const double gap =
                std::max(constant(HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN, style) + above.depth,
                         constant(HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN, style));
            box.place(above, 0.5 * (width - above.width + base.italic), base.box.height + gap);
        }
        if (atom.has_subscript) {
            const double gap =
                std::max(constant(HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN, style) + below.height,
                         constant(HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN, style));
            box.place(below, 0.5 * (width - below.width - base.italic), -base.box.depth - gap);
        }
        return box;
    }

    double size_px_;
    FontSet& fonts_;
    FontFile& font_;
};

}  // namespace

TypeBox set_formula(const MathList& atoms, MathStyle style, double size_px, FontSet& fonts) {
    return FormulaSetter(size_px, fonts).list(atoms, style);
}

std::vector<FormulaPart> set_formula_parts(const MathList& atoms, MathStyle style, double size_px,
                                           FontSet& fonts) {
    return FormulaSetter(size_px, fonts).parts(atoms, style, true);
}

}  // namespace poinsot
