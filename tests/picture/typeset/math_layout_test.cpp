// Positions of glyphs, compared with the font's tables as read by HarfBuzz.
#include "typeset/math_layout.h"

#include <gtest/gtest.h>
#include <hb-ot.h>

#include <memory>
#include <string>

#include "typeset/files/font_search.h"
#include "typeset/files/installed_fonts.h"
#include "typeset/label_parser.h"

namespace poinsot {
namespace {

constexpr double em_px = 1000.0;  // px per em: 1 px is one font unit

// Reads the math font with HarfBuzz alone.
class MathTable : public testing::Test {
 protected:
    MathTable() : fonts_(installed_fonts()) {
        const std::string file = find_font("latinmodern-math.otf").string();
        hb_blob_t* blob = hb_blob_create_from_file(file.c_str());
        hb_face_t* face = hb_face_create(blob, 0);
        font_.reset(hb_font_create(face));
        hb_face_destroy(face);
        hb_blob_destroy(blob);
        hb_font_set_scale(font_.get(), 1000, 1000);
    }

    double constant(hb_ot_math_constant_t which) const {
        return hb_ot_math_get_constant(font_.get(), which);
    }
    hb_codepoint_t glyph(char32_t code) const {
        hb_codepoint_t found = 0;
        hb_font_get_nominal_glyph(font_.get(), code, &found);
        return found;
    }
    double advance(char32_t code) const {
        return hb_font_get_glyph_h_advance(font_.get(), glyph(code));
    }
    double italic(char32_t code) const {
        return hb_ot_math_get_glyph_italics_correction(font_.get(), glyph(code));
    }
    hb_glyph_extents_t ink(hb_codepoint_t id) const {
        hb_glyph_extents_t extents{};
        hb_font_get_glyph_extents(font_.get(), id, &extents);
        return extents;
    }
    TypeBox set(const char* label, MathStyle::Level level = MathStyle::Level::text) {
        return set_formula(parse_math(label), {level, false}, em_px, fonts_);
    }

    struct Destroy {
        void operator()(hb_font_t* font) const { hb_font_destroy(font); }
    };
    std::unique_ptr<hb_font_t, Destroy> font_;
    FontSet fonts_;
};

constexpr char32_t italic_omega = 0x1D714, italic_x = 0x1D465, italic_l = 0x1D43F;

TEST_F(MathTable, SubscriptUsesTheFontsShift) {
    const TypeBox box = set("\\omega_1");
    ASSERT_EQ(box.glyphs.size(), 2u);
    EXPECT_EQ(box.glyphs[0].y, 0.0);
    EXPECT_DOUBLE_EQ(box.glyphs[1].y, -constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN));
    EXPECT_DOUBLE_EQ(box.glyphs[1].x, advance(italic_omega));
    EXPECT_DOUBLE_EQ(box.glyphs[1].px_per_unit,
                     constant(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN) / 100.0);
}

TEST_F(MathTable, SuperscriptUsesTheFontsShiftAndItalicCorrection) {
    const TypeBox box = set("\\omega^2");
    ASSERT_EQ(box.glyphs.size(), 2u);
    EXPECT_DOUBLE_EQ(box.glyphs[1].y, constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP));
    EXPECT_DOUBLE_EQ(box.glyphs[1].x, advance(italic_omega) + italic(italic_omega));
    // Inside a root the style is cramped.
    const TypeBox under = set("\\sqrt{\\omega^2}");
    double top = 0.0;
    for (const PlacedGlyph& each : under.glyphs) {
        if (each.px_per_unit < 1.0) top = each.y;
    }
    EXPECT_DOUBLE_EQ(top, constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED));
}

TEST_F(MathTable, AccentDoesNotMoveScripts) {
    const TypeBox plain = set("\\omega_1^2"), dotted = set("\\dot\\omega_1^2");
    ASSERT_EQ(plain.glyphs.size(), 3u);
    ASSERT_EQ(dotted.glyphs.size(), 4u);
    EXPECT_DOUBLE_EQ(plain.glyphs[1].y, dotted.glyphs[2].y);
    EXPECT_DOUBLE_EQ(plain.glyphs[2].y, dotted.glyphs[3].y);
}

TEST_F(MathTable, ScriptsKeepTheFontsMinimumGap) {
    // A deep superscript over a tall subscript: the gap between their inks is at least the font's
    // minimum.
    const TypeBox box = set("x_l^y");
    ASSERT_EQ(box.glyphs.size(), 3u);
    const PlacedGlyph &above = box.glyphs[1], &below = box.glyphs[2];
    const hb_glyph_extents_t up = ink(above.glyph), down = ink(below.glyph);
    const double bottom = above.y + (up.y_bearing + up.height) * above.px_per_unit;
    const double top = below.y + down.y_bearing * below.px_per_unit;
    EXPECT_GE(bottom - top, constant(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN) - 1e-9);
}

TEST_F(MathTable, WidthIsTheSumOfAdvancesAndSpaces) {
    const double thick = 5.0 / 18.0 * em_px, medium = 4.0 / 18.0 * em_px, thin = em_px / 6.0;
    const double x = advance(italic_x) + italic(italic_x);
    EXPECT_DOUBLE_EQ(set("xx").width, 2.0 * x);
    EXPECT_DOUBLE_EQ(set("x=x").width, 2.0 * x + advance(U'=') + 2.0 * thick);
    EXPECT_DOUBLE_EQ(set("x-x").width, 2.0 * x + advance(0x2212) + 2.0 * medium);
    EXPECT_DOUBLE_EQ(set("-x").width, x + advance(0x2212));
    EXPECT_DOUBLE_EQ(set("x=-x").width, 2.0 * x + advance(U'=') + advance(0x2212) + 2.0 * thick);
    EXPECT_DOUBLE_EQ(set("(x,x)").width,
                     2.0 * x + advance(U'(') + advance(U')') + advance(U',') + thin);
    EXPECT_DOUBLE_EQ(set("x\\,x\\;x\\quad x").width, 4.0 * x + thin + thick + em_px);
    // A function's name is a word followed by a thin space.
    EXPECT_DOUBLE_EQ(set("\\sin x").width, set("\\text{sin}x").width + thin);
    EXPECT_DOUBLE_EQ(set("\\sin(x)").width, set("\\text{sin}(x)").width);
    EXPECT_DOUBLE_EQ(set("2.5").width, 2.0 * advance(U'2') + advance(U'.'));
    // Scripts have no space around relations: i=1 is three adjacent glyphs.
    const TypeBox script = set("x_{2=2}");
    ASSERT_EQ(script.glyphs.size(), 4u);
    const double small = script.glyphs[1].px_per_unit;
    EXPECT_DOUBLE_EQ(script.glyphs[2].x - script.glyphs[1].x,
                     small * hb_font_get_glyph_h_advance(font_.get(), script.glyphs[1].glyph));
}

TEST_F(MathTable, SmallDigitsAreTheFontsScriptForms) {
    const TypeBox box = set("x_1^{a_1}");
    hb_buffer_t* buffer = hb_buffer_create();
    for (const unsigned level : {1u, 2u}) {
        hb_buffer_clear_contents(buffer);
        hb_buffer_add_utf8(buffer, "1", 1, 0, 1);
        hb_buffer_guess_segment_properties(buffer);
        hb_buffer_set_script(buffer, HB_SCRIPT_MATH);
        const hb_feature_t ssty{HB_TAG('s', 's', 't', 'y'), level, 0, ~0u};
        hb_shape(font_.get(), buffer, &ssty, 1);
        const hb_codepoint_t expected = hb_buffer_get_glyph_infos(buffer, nullptr)[0].codepoint;
        EXPECT_NE(expected, glyph(U'1'));
        const double scale =
            constant(level == 1 ? HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN
                                : HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN) /
            100.0;
        bool found = false;
        for (const PlacedGlyph& each : box.glyphs) {
            found = found || (each.glyph == expected && each.px_per_unit == scale);
        }
        EXPECT_TRUE(found) << level;
    }
    hb_buffer_destroy(buffer);
}

TEST_F(MathTable, FractionRuleLiesOnTheAxisAndClearsBothParts) {
    for (const auto level : {MathStyle::Level::display, MathStyle::Level::text}) {
        const TypeBox box = set("\\frac{g_y}{\\dot{l}}", level);
        ASSERT_EQ(box.rules.size(), 1u);
        const PlacedRule& rule = box.rules[0];
        EXPECT_DOUBLE_EQ(rule.thickness, constant(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS));
        EXPECT_DOUBLE_EQ(rule.y + 0.5 * rule.thickness, constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT));
        const double gap = constant(level == MathStyle::Level::display
                                        ? HB_OT_MATH_CONSTANT_FRACTION_NUM_DISPLAY_STYLE_GAP_MIN
                                        : HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_GAP_MIN);
        for (const PlacedGlyph& each : box.glyphs) {
            const hb_glyph_extents_t extents = ink(each.glyph);
            const double top = each.y + extents.y_bearing * each.px_per_unit;
            const double bottom = top + extents.height * each.px_per_unit;
            EXPECT_TRUE(bottom >= rule.y + rule.thickness + gap - 1e-9 ||
                        top <= rule.y - gap + 1e-9);
        }
    }
}

TEST_F(MathTable, RootCoversItsBodyAndJoinsItsBar) {
    for (const char* label : {"\\sqrt{x}", "\\sqrt{2T}", "\\sqrt{\\frac{a}{b}}",
                              "\\sqrt{\\frac{\\frac{a}{b}}{\\frac{a}{b}}}"}) {
        const TypeBox box = set(label, MathStyle::Level::display);
        const PlacedRule bar = box.rules.front();
        const PlacedGlyph sign = box.glyphs.front();
        const hb_glyph_extents_t extents = ink(sign.glyph);
        EXPECT_DOUBLE_EQ(bar.thickness, constant(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS));
        // The sign's top is at the bar's top, and its ink reaches the bar.
        EXPECT_NEAR(sign.y + extents.y_bearing, bar.y + bar.thickness, 1e-9) << label;
        EXPECT_GE(sign.x + extents.x_bearing + extents.width, bar.x) << label;
        // The body is below the bar by the gap, and above the bottom of the sign.
        const double gap = constant(HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP);
        for (std::size_t i = 1; i < box.glyphs.size(); ++i) {
            const PlacedGlyph& each = box.glyphs[i];
            const hb_glyph_extents_t body = ink(each.glyph);
            const double top = each.y + body.y_bearing * each.px_per_unit;
            EXPECT_LE(top, bar.y - gap + 1e-9) << label;
            EXPECT_GE(top + body.height * each.px_per_unit,
                      sign.y + extents.y_bearing + extents.height - 1e-9)
                << label;
        }
    }
}

TEST_F(MathTable, RootTallerThanAnyVariantIsAssembledWithoutGaps) {
    std::string label = "x";
    for (int i = 0; i < 4; ++i) label = "\\dfrac{" + label + "}{" + label + "}";
    const TypeBox box = set(("\\sqrt{" + label + "}").c_str(), MathStyle::Level::display);
    const PlacedRule& bar = box.rules.front();
    const std::size_t pieces = bar.last_glyph - bar.first_glyph;
    ASSERT_GE(pieces, 3u);
    const double overlap = hb_ot_math_get_min_connector_overlap(font_.get(), HB_DIRECTION_TTB);
    for (std::size_t i = 0; i + 1 < pieces; ++i) {
        const hb_glyph_extents_t lower = ink(box.glyphs[i].glyph);
        const hb_glyph_extents_t upper = ink(box.glyphs[i + 1].glyph);
        EXPECT_GE(box.glyphs[i].y + lower.y_bearing,
                  box.glyphs[i + 1].y + upper.y_bearing + upper.height + overlap - 1.0);
    }
    const hb_glyph_extents_t top = ink(box.glyphs[pieces - 1].glyph);
    EXPECT_NEAR(box.glyphs[pieces - 1].y + top.y_bearing, bar.y + bar.thickness, 1.0);
}

TEST_F(MathTable, AccentIsAtTheLettersAttachmentPoint) {
    for (const char32_t letter : {italic_omega, italic_l}) {
        const TypeBox box = set(letter == italic_l ? "\\dot L" : "\\dot\\omega");
        ASSERT_EQ(box.glyphs.size(), 2u);
        const double base = hb_ot_math_get_glyph_top_accent_attachment(font_.get(), glyph(letter));
        const double mark =
            hb_ot_math_get_glyph_top_accent_attachment(font_.get(), glyph(U'\u0307'));
        EXPECT_DOUBLE_EQ(box.glyphs[1].x + mark, base);
        const double height = ink(glyph(letter)).y_bearing;
        const double raise =
            std::max(0.0, height - constant(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT));
        EXPECT_DOUBLE_EQ(box.glyphs[1].y, raise);
    }
}

TEST_F(MathTable, PrimeIsAsHighAsTheFontsPrime) {
    // The glyph of U+2032 is already raised; its script form, raised as a superscript, must agree
    // with it.
    const TypeBox box = set("L'");
    ASSERT_EQ(box.glyphs.size(), 2u);
    const hb_glyph_extents_t script = ink(box.glyphs[1].glyph), plain = ink(glyph(U'′'));
    const double top = box.glyphs[1].y + script.y_bearing * box.glyphs[1].px_per_unit;
    EXPECT_NEAR(top, plain.y_bearing, 2.0);  // measured 0.7
}

TEST_F(MathTable, FencesGrowAndStayOnTheAxis) {
    const TypeBox small = set("\\left(x\\right)"), large = set("\\left(\\dfrac{a}{b}\\right)");
    const auto height = [this](const PlacedGlyph& g) { return -ink(g.glyph).height; };
    EXPECT_GT(height(large.glyphs.front()), 1.5 * height(small.glyphs.front()));
    for (const TypeBox* box : {&small, &large}) {
        const PlacedGlyph& open = box->glyphs.front();
        const hb_glyph_extents_t extents = ink(open.glyph);
        EXPECT_NEAR(open.y + extents.y_bearing + 0.5 * extents.height,
                    constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT), 1e-9);
    }
}

TEST_F(MathTable, MatrixHasColumnsOnCommonMiddlesAndEvenLinesAboutTheAxis) {
    const TypeBox box = set("\\begin{pmatrix} 1 & 22 \\\\ 333 & 4 \\\\ 5 & 6 \\end{pmatrix}");
    // The nine digits are between the two delimiters, which have as many parts.
    const std::size_t first = (box.glyphs.size() - 9) / 2;
    const auto at = [&box, first](std::size_t i) { return box.glyphs[first + i]; };
    const auto middle = [&](std::size_t i, std::size_t last) {
        return 0.5 * (at(i).x + at(last).x);
    };
    EXPECT_NEAR(middle(0, 0), middle(3, 5), 1e-9);
    EXPECT_NEAR(middle(0, 0), middle(7, 7), 1e-9);
    EXPECT_NEAR(middle(1, 2), middle(6, 6), 1e-9);
    EXPECT_GT(at(1).x, at(5).x);
    // Three lines of equal height, from the first to the last.
    EXPECT_GT(at(0).y, at(3).y);
    EXPECT_NEAR(at(0).y - at(3).y, at(3).y - at(7).y, 1e-9);
    EXPECT_EQ(at(0).y, at(1).y);
    const double axis = constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT);
    EXPECT_NEAR(box.height - axis, box.depth + axis, 1e-9);
}

TEST_F(MathTable, LayoutIsLinearInTheSize) {
    const MathList atoms = parse_math("\\frac{d\\mathbf{L}}{dt} = \\sqrt{\\dot\\omega_1^2}");
    const MathStyle style{MathStyle::Level::display, false};
    const TypeBox one = set_formula(atoms, style, 10.0, fonts_);
    const TypeBox seven = set_formula(atoms, style, 70.0, fonts_);
    ASSERT_EQ(one.glyphs.size(), seven.glyphs.size());
    for (std::size_t i = 0; i < one.glyphs.size(); ++i) {
        EXPECT_NEAR(7.0 * one.glyphs[i].x, seven.glyphs[i].x, 1e-12 * 700.0);
        EXPECT_NEAR(7.0 * one.glyphs[i].y, seven.glyphs[i].y, 1e-12 * 700.0);
    }
}

}  // namespace
}  // namespace poinsot
