// Terms of captions that get tints.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "typeset/caption_layout.h"
#include "typeset/files/installed_fonts.h"
#include "typeset/label_parser.h"
#include "typeset/typesetter.h"

namespace poinsot {
namespace {

const std::vector<CaptionTerm> terms{{"\\boldsymbol{\\omega}", true},
                                     {"\\mathbf{e}_1", true},
                                     {"\\nabla F", true},
                                     {"polhode", false},
                                     {"herpolhode", false},
                                     {"body cone", false}};

// The tinted characters of running text, each word with its tint: "polhode4".
std::string tinted_words(const std::string& text) {
    Caption caption = parse_caption(text);
    tint_terms(terms, caption);
    std::string words;
    int before = 0;
    const auto end = [&](int tint) {
        if (before != 0 && tint != before) words += std::to_string(before) + " ";
        before = tint;
    };
    for (const CaptionPiece& piece : caption) {
        for (const LabelCharacter& character : piece.text.characters) {
            end(character.tint);
            if (character.tint != 0)
                words += character.code == U'\u00A0' ? ' ' : static_cast<char>(character.code);
        }
        if (piece.kind == CaptionPiece::Kind::formula) end(0);
    }
    end(0);
    return words;
}

// The number of glyphs of each tint.
std::map<int, int> n_glyphs(const std::string& text) {
    const Typesetter typesetter(installed_fonts());
    TypeStyle style{.size_px = 30.0, .mode = TypeMode::text};
    style.terms = &terms;
    std::map<int, int> n;
    for (const SetGlyph& glyph : typesetter.set(text, style).glyphs) ++n[glyph.tint];
    n.erase(0);
    return n;
}

TEST(CaptionTerms, AreWholeWords) {
    EXPECT_EQ(tinted_words("The polhode closes; the herpolhode, in general, does not."),
              "polhode4 herpolhode5 ");
    EXPECT_EQ(tinted_words("polhodes and (herpolhodes)"), "polhodes4 herpolhodes5 ");
    EXPECT_EQ(tinted_words("Herpolhode, polhodeless, unpolhode, 2polhode"), "polhode4 ");
    EXPECT_EQ(tinted_words("a body cone, one cone of a body"), "bodycone6 ");
    EXPECT_EQ(tinted_words("body\ncone, body~cone, polhode $t$ polhode"),
              "body cone6 polhode4 polhode4 ");
}

TEST(CaptionTerms, AreAtomsOfFormulasWithTheirScripts) {
    EXPECT_EQ(n_glyphs("$\\boldsymbol\\omega(0) = -\\boldsymbol{\\omega}\\times\\mathbf{L}$"),
              (std::map<int, int>{{1, 2}}));
    EXPECT_EQ(n_glyphs("about $\\mathbf{e}_1$, not $\\mathbf{e}_2$ or $e_1$"),
              (std::map<int, int>{{2, 2}}));
    EXPECT_EQ(n_glyphs("$\\nabla F = \\sqrt{2/T}\\,\\mathbf{L}$, $F$"),
              (std::map<int, int>{{3, 2}}));
    // ω as a scalar and with an index is another quantity.
    EXPECT_EQ(n_glyphs("$\\omega$, $\\omega_1$, $\\boldsymbol\\omega_1$"), (std::map<int, int>{}));
    EXPECT_EQ(n_glyphs("$\\frac{\\boldsymbol\\omega}{\\sqrt{2T}}$"), (std::map<int, int>{{1, 1}}));
}

// Words in colours stand where they stand without.
TEST(CaptionTerms, ChangeNoPixelOfTheMask) {
    const Typesetter typesetter(installed_fonts());
    const std::string text = "The polhode, $\\boldsymbol\\omega/\\sqrt{2T}$: a herpolhode's ring.";
    TypeStyle style{.size_px = 26.0, .mode = TypeMode::text, .max_width_px = 200.0};
    const TypesetMask plain = typesetter.set(text, style);
    style.terms = &terms;
    const TypesetMask tinted = typesetter.set(text, style);
    EXPECT_EQ(plain.coverage, tinted.coverage);
    EXPECT_TRUE(plain.tints.empty());
    ASSERT_EQ(tinted.tints.size(), tinted.coverage.size());
    // The middle of each tinted glyph's stem is somewhere in the mask.
    for (const std::uint8_t tint : {1, 4, 5})
        EXPECT_NE(std::find(tinted.tints.begin(), tinted.tints.end(), tint), tinted.tints.end());
}

}  // namespace
}  // namespace poinsot
