// Kept tables of fonts against the fonts that they were made of, read by FreeType and HarfBuzz.
#include "typeset/kept_font.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "error/error.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

std::vector<char32_t> letters() {
    std::vector<char32_t> all;
    for (char32_t c = U' '; c <= U'~'; ++c) all.push_back(c);
    for (char32_t c = U'\u00A1'; c <= U'\u017F'; ++c)
        if (c != U'\u00AD') all.push_back(c);  // HarfBuzz hides the soft hyphen
    for (const char32_t c : {U'ω', U'√', U'(', U')', U'∫', U'√', U'⟨', U'{', U'‘', U'’'})
        all.push_back(c);
    return all;
}

struct Fonts {
    std::vector<char32_t> characters = letters();
    FontFile font;
    std::string table;
    KeptFont kept;
    explicit Fonts(std::string_view name)
        : font(installed_fonts().open(name)),
          table(keep_font(font, {characters, characters, characters, characters})),
          kept(table) {}
};

bool same(const GlyphOutline& a, const GlyphOutline& b) {
    if (a.steps.size() != b.steps.size()) return false;
    for (std::size_t k = 0; k < a.steps.size(); ++k) {
        const OutlineStep &p = a.steps[k], &q = b.steps[k];
        const auto is_equal = [](OutlinePoint s, OutlinePoint t) {
            return s.x == t.x && s.y == t.y;
        };
        if (p.kind != q.kind || !is_equal(p.to, q.to)) return false;
        if (p.kind == OutlineStep::Kind::cubic &&
            !(is_equal(p.control_1, q.control_1) && is_equal(p.control_2, q.control_2)))
            return false;
    }
    return true;
}

std::string text_of(const std::u32string& text) {
    std::string codes;
    for (const char32_t c : text) codes += fmt::format("U+{:04X} ", static_cast<unsigned>(c));
    return codes;
}

// Every pair, and words with ligatures of two and three letters.
TEST(KeptFont, SetsTextToTheSamePositions) {
    for (const std::string_view name : font_names()) {
        Fonts fonts(name);
        const auto check = [&](const std::u32string& text) {
            for (const char32_t c : text)
                if (!fonts.font.glyph(c)) return;
            const ShapedRun expected = fonts.font.shape(text), run = fonts.kept.shape(text);
            SCOPED_TRACE(text_of(text));
            ASSERT_EQ(run.glyphs.size(), expected.glyphs.size()) << name;
            EXPECT_EQ(run.advance, expected.advance) << name;
            for (std::size_t k = 0; k < run.glyphs.size(); ++k) {
                EXPECT_EQ(run.glyphs[k].glyph, expected.glyphs[k].glyph) << name;
                EXPECT_EQ(run.glyphs[k].x, expected.glyphs[k].x) << name;
                EXPECT_EQ(run.glyphs[k].y, expected.glyphs[k].y) << name;
            }
        };
        for (const char32_t a : letters())
            for (const char32_t b : letters()) check({a, b});
        for (const char32_t* text :
             {U"The polhode rolls without slipping", U"offizielle Auffassung, fjord, fflfi",
              U"AVATAR Type Wort. L’élan; ‘f’", U"officiel efficace affleurer", U"f f i fi ffi"})
            check(text);
    }
}

TEST(KeptFont, HasTheSameGlyphs) {
    for (const std::string_view name : font_names()) {
        Fonts fonts(name);
        EXPECT_EQ(fonts.kept.units_per_em(), fonts.font.units_per_em());
        EXPECT_EQ(fonts.kept.has_math(), fonts.font.has_math());
        for (const char32_t c : letters()) {
            EXPECT_EQ(fonts.kept.script_glyph(c, 0), fonts.font.glyph(c)) << name;
            const auto glyph = fonts.font.glyph(c);
            if (!glyph) continue;
            const GlyphMetrics a = fonts.kept.metrics(*glyph), b = fonts.font.metrics(*glyph);
            EXPECT_EQ(a.advance, b.advance);
            EXPECT_EQ(a.height, b.height);
            EXPECT_EQ(a.depth, b.depth);
            EXPECT_EQ(a.left, b.left);
            EXPECT_EQ(a.right, b.right);
            EXPECT_EQ(a.italic_correction, b.italic_correction);
            EXPECT_EQ(a.accent_attachment, b.accent_attachment);
            EXPECT_TRUE(same(fonts.kept.outline(*glyph), fonts.font.outline(*glyph)))
                << name << ' ' << *glyph;
        }
    }
}

TEST(KeptFont, HasWhatFormulasNeed) {
    Fonts fonts("latinmodern-math.otf");
    for (std::size_t k = 0; k < KeptFont::n_constants; ++k)
        EXPECT_EQ(fonts.kept.constant(k),
                  fonts.font.constant(static_cast<hb_ot_math_constant_t>(k)));
    for (const char32_t c : letters())
        for (const int level : {1, 2})
            EXPECT_EQ(fonts.kept.script_glyph(c, level), fonts.font.script_glyph(c, level));
    for (const char32_t c : {U'√', U'(', U'{', U'∫'}) {
        const GlyphId glyph = *fonts.font.glyph(c);
        const TallForms kept = fonts.kept.tall_forms(glyph), own = fonts.font.tall_forms(glyph);
        EXPECT_EQ(kept.variants, own.variants);
        EXPECT_EQ(kept.least_overlap, own.least_overlap);
        ASSERT_EQ(kept.pieces.size(), own.pieces.size());
        for (std::size_t k = 0; k < own.pieces.size(); ++k) {
            EXPECT_EQ(kept.pieces[k].glyph, own.pieces[k].glyph);
            EXPECT_EQ(kept.pieces[k].advance, own.pieces[k].advance);
            EXPECT_EQ(kept.pieces[k].repeats, own.pieces[k].repeats);
        }
        for (const GlyphId variant : own.variants)
            EXPECT_TRUE(same(fonts.kept.outline(variant), fonts.font.outline(variant)));
    }
}

TEST(KeptFont, RefusesWhatIsNoTable) {
    EXPECT_THROW(KeptFont("OTTO"), EnvironmentError);
    const Fonts fonts("lmsans10-regular.otf");
    EXPECT_THROW(KeptFont(std::string_view(fonts.table).substr(0, 2000)), EnvironmentError);
}

}  // namespace
}  // namespace poinsot
