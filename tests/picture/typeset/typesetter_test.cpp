// Masks of labels and captions.
#include "typeset/typesetter.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <hb-ot.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>

#include "system/files/file_contents.h"
#include "typeset/files/installed_fonts.h"
#include "typeset/label_cursor.h"
#include "typeset/symbols.h"

namespace poinsot {
namespace {

double ink(const TypesetMask& mask) {
    return std::accumulate(mask.coverage.begin(), mask.coverage.end(), 0.0) / 255.0;
}

TypeStyle caption(double size_px, double max_width_px = 0.0) {
    TypeStyle style;
    style.size_px = size_px;
    style.mode = TypeMode::text;
    style.max_width_px = max_width_px;
    return style;
}

TypeStyle label(double size_px) {
    TypeStyle style;
    style.size_px = size_px;
    return style;
}

// The first and last row and column of the mask contain ink: the box is the smallest.
void expect_tight(const TypesetMask& mask) {
    ASSERT_EQ(mask.coverage.size(),
              static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height));
    ASSERT_GT(mask.width, 0);
    ASSERT_GT(mask.height, 0);
}

class FieldSymbols : public testing::TestWithParam<const char*> {};
TEST_P(FieldSymbols, HaveInkAtEverySize) {
    const Typesetter typesetter(installed_fonts());
    for (const double size : {8.0, 12.0, 24.0, 48.0, 200.0}) {
        const TypesetMask mask = typesetter.set(GetParam(), label(size));
        expect_tight(mask);
        // Thin strokes: a letter's ink is at least a twentieth of an em squared.
        EXPECT_GT(ink(mask), 0.05 * size * size) << GetParam();
        EXPECT_LT(ink(mask), mask.width * mask.height);
    }
}
INSTANTIATE_TEST_SUITE_P(Labels, FieldSymbols,
                         testing::Values("\\omega", "\\mathbf{L}", "e_1", "e_2", "e_3",
                                         "\\mathbf{e}_1", "I_1 > I_2 > I_3", "\\sqrt{2T}/L",
                                         "\\theta", "\\varphi", "\\phi", "\\psi", "\\dot\\omega",
                                         "\\boldsymbol\\omega", "\\dot{\\mathbf{L}}", "\\Omega",
                                         "\\Omega = (I_3-I_1)\\omega_3/I_1",
                                         "\\frac{d\\mathbf{L}}{dt} = 0", "F(\\rho) = 1",
                                         "\\boldsymbol\\rho = \\mathbf{n}/\\sqrt{I}", "ω", "ω₁",
                                         "ω\u0307", "√2", "\\lambda \\propto \\infty"));

TEST(Labels, EveryCommandOfTheTableIsInTheFonts) {
    const Typesetter typesetter(installed_fonts());
    for (const LabelCommand& command : label_commands()) {
        const std::string name(command.name);
        std::string text;
        switch (command.kind) {
            case CommandKind::space:
            case CommandKind::right:
            case CommandKind::end:
                continue;
            case CommandKind::begin:
                text = "\\begin{pmatrix}x\\end{pmatrix}";
                break;
            case CommandKind::left:
                text = "\\left(x\\right)";
                break;
            case CommandKind::fraction:
                text = "\\" + name + "{x}{x}";
                break;
            case CommandKind::symbol:
            case CommandKind::big:
            case CommandKind::integral:
            case CommandKind::function_name:
                text = "\\" + name;
                break;
            default:
                text = "\\" + name + "{X}";
                break;
        }
        EXPECT_GT(ink(typesetter.set(text, label(40.0))), 0.0) << text;
    }
}

TEST(Labels, EveryAlphabetHasAllItsLettersInTheFonts) {
    const Typesetter typesetter(installed_fonts());
    for (const char* alphabet : {"mathbf", "boldsymbol", "mathrm", "mathit", "mathcal", "mathbb"}) {
        for (char letter = 'A'; letter <= 'Z'; ++letter) {
            EXPECT_NO_THROW(typesetter.set(fmt::format("\\{}{{{}}}", alphabet, letter)));
        }
    }
    for (const char* alphabet : {"mathbf", "boldsymbol", "mathrm", "mathit"}) {
        for (const LabelCommand& command : label_commands()) {
            const bool greek = command.symbol >= 0x391 && command.symbol <= 0x3F5;
            if (command.kind != CommandKind::symbol || !greek) continue;
            EXPECT_NO_THROW(typesetter.set(fmt::format("\\{}{{\\{}}}", alphabet, command.name)));
        }
    }
}

TEST(Labels, SameStringGivesTheSameBytes) {
    const Typesetter one(installed_fonts()), other(installed_fonts());
    const char* text = "\\sqrt{2T}/L = \\dot\\omega_1^2";
    const TypesetMask a = one.set(text), b = one.set(text);
    other.set("\\frac{a}{b}");  // used and new typesetters agree
    const TypesetMask c = other.set(text);
    EXPECT_EQ(a.coverage, b.coverage);
    EXPECT_EQ(a.coverage, c.coverage);
    EXPECT_EQ(a.left_px, c.left_px);
}

TEST(Labels, MeasureEqualsTheMasksExtent) {
    const Typesetter typesetter(installed_fonts());
    for (const char* text : {"\\omega_1", "\\frac{a}{b}", "", "\\quad"}) {
        const TypesetMask mask = typesetter.set(text, label(30.0));
        const TypeExtent extent = typesetter.measure(text, label(30.0));
        EXPECT_EQ(extent.width, mask.width);
        EXPECT_EQ(extent.height, mask.height);
        EXPECT_EQ(extent.left_px, mask.left_px);
        EXPECT_EQ(extent.baseline_px, mask.baseline_px);
        EXPECT_EQ(extent.advance_px, mask.advance_px);
    }
}

TEST(Labels, EmptyLabelsGiveAnEmptyMask) {
    const Typesetter typesetter(installed_fonts());
    for (const TypeStyle& style : {label(20.0), caption(20.0)}) {
        const TypesetMask mask = typesetter.set("", style);
        EXPECT_EQ(mask.width, 0);
        EXPECT_EQ(mask.height, 0);
        EXPECT_TRUE(mask.coverage.empty());
        EXPECT_EQ(mask.n_lines, 0);
    }
}

TEST(Labels, BarsHaveASharpUpperEdge) {
    // The rows at and above a fraction's bar: the bar's first row is full if it is at least a pixel
    // thick, and the row above it is empty.
    const Typesetter typesetter(installed_fonts());
    for (const double size : {30.0, 41.7, 64.3}) {
        const TypesetMask mask = typesetter.set("\\frac{\\quad\\quad x}{x}", label(size));
        // A column to the left of the numerator's only letter crosses only the bar.
        const int column = mask.width / 8;
        int first = 0;
        while (mask.coverage[static_cast<std::size_t>(first * mask.width + column)] == 0) ++first;
        EXPECT_EQ(mask.coverage[static_cast<std::size_t>(first * mask.width + column)], 255)
            << size;
    }
}

TEST(Captions, WidthEqualsHarfBuzzsAdvance) {
    const std::string file = find_font("lmsans10-regular.otf").string();
    hb_blob_t* blob = hb_blob_create_from_file(file.c_str());
    hb_face_t* face = hb_face_create(blob, 0);
    hb_font_t* font = hb_font_create(face);
    hb_buffer_t* buffer = hb_buffer_create();
    const std::string word = "AVoffice";  // kerned, with a ligature
    hb_buffer_add_utf8(buffer, word.c_str(), -1, 0, -1);
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(font, buffer, nullptr, 0);
    unsigned n = 0;
    const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer, &n);
    double advance = 0.0;
    for (unsigned i = 0; i < n; ++i) advance += positions[i].x_advance;
    EXPECT_LT(n, word.size());
    const Typesetter typesetter(installed_fonts());
    EXPECT_NEAR(typesetter.measure(word, caption(50.0)).advance_px,
                50.0 * advance / hb_face_get_upem(face), 1e-9);
    hb_buffer_destroy(buffer);
    hb_font_destroy(font);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
}

TEST(Captions, WrapToTheirWidth) {
    const Typesetter typesetter(installed_fonts());
    const char* text =
        "The inertia ellipsoid rolls without slipping on the invariable plane at distance "
        "$\\sqrt{2T}/L$ from its centre, and the contact point traces polhode and herpolhode.";
    const TypeExtent one = typesetter.measure(text, caption(24.0));
    EXPECT_EQ(one.n_lines, 1);
    int lines_before = 1;
    for (const double width : {800.0, 500.0, 300.0, 200.0}) {
        const TypeExtent extent = typesetter.measure(text, caption(24.0, width));
        EXPECT_LE(extent.advance_px, width);
        EXPECT_GE(extent.n_lines, static_cast<int>(std::ceil(one.advance_px / width)));
        EXPECT_GT(extent.n_lines, lines_before);
        lines_before = extent.n_lines;
        EXPECT_EQ(extent.baseline_px, std::floor(extent.baseline_px));
    }
}

TEST(Captions, WordWiderThanTheLineHasItsOwnLine) {
    const Typesetter typesetter(installed_fonts());
    const TypeExtent extent = typesetter.measure("a Herpolhodenkegel b", caption(24.0, 50.0));
    EXPECT_EQ(extent.n_lines, 3);
    EXPECT_GT(extent.advance_px, 50.0);
}

TEST(Captions, TooWideFormulaBreaksAfterARelation) {
    const Typesetter typesetter(installed_fonts());
    const char* text = "$I_1 = I_2 = I_3 = I_4 = I_5$";
    const double whole = typesetter.measure(text, caption(24.0)).advance_px;
    EXPECT_EQ(typesetter.measure(text, caption(24.0, 1.01 * whole)).n_lines, 1);
    EXPECT_EQ(typesetter.measure(text, caption(24.0, 0.7 * whole)).n_lines, 2);
}

TEST(Captions, LineSpacingAndBreaksFollowTheStyle) {
    const Typesetter typesetter(installed_fonts());
    TypeStyle style = caption(20.0);
    const TypeExtent one = typesetter.measure("x", style);
    for (const double spacing : {1.2, 1.5, 2.0}) {
        style.line_spacing = spacing;
        const TypeExtent three = typesetter.measure("x\nx\\\\x", style);
        EXPECT_EQ(three.n_lines, 3);
        EXPECT_EQ(three.height - one.height, 2 * std::round(spacing * 20.0));
    }
    // Tall formulas increase the line distance.
    style.line_spacing = 1.0;
    const TypeExtent tall = typesetter.measure("$\\dfrac{a}{b}$\n$\\dfrac{a}{b}$", style);
    EXPECT_GT(tall.height, 2 * typesetter.measure("$\\dfrac{a}{b}$", style).height);
    // A line feed at the end does not start a new line.
    EXPECT_EQ(typesetter.measure("x\n", style).n_lines, 1);
}

TEST(Captions, AlignmentMovesTheShortLine) {
    const Typesetter typesetter(installed_fonts());
    TypeStyle style = caption(24.0);
    double before = -1.0;
    for (const TypeAlignment alignment :
         {TypeAlignment::left, TypeAlignment::centre, TypeAlignment::right}) {
        style.alignment = alignment;
        const TypesetMask mask = typesetter.set("mmmmmmmm\nm", style);
        // The first column of the last row with ink: the left foot of the short line.
        const std::size_t row =
            static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height - 2);
        int column = 0;
        while (mask.coverage[row + static_cast<std::size_t>(column)] < 128) ++column;
        EXPECT_GT(column, before);
        before = column;
        if (alignment == TypeAlignment::left) {
            EXPECT_LE(column, 3);
        }
        if (alignment == TypeAlignment::right) {
            EXPECT_GT(column, mask.width * 3 / 4);
        }
    }
}

TEST(Captions, ChangingNumbersDoNotMoveTheirNeighbours) {
    const Typesetter typesetter(installed_fonts());
    const TypeExtent first = typesetter.measure("t = 0.00 s", caption(24.0));
    for (int i = 1; i < 100; ++i) {
        const TypeExtent now =
            typesetter.measure(fmt::format("t = {:.2f} s", 0.0731 * i), caption(24.0));
        EXPECT_NEAR(now.advance_px, first.advance_px, 1e-9);
        EXPECT_EQ(now.left_px, first.left_px);
    }
}

// In running text it is drawn as a box and recorded once.
TEST(MissingCharacters, AreBoxesIfNoFontHasThem) {
    FontSearch search;
    search.fallback_folders.clear();
    const Typesetter typesetter(installed_fonts(search));
    const TypesetMask with = typesetter.set("ab字字", caption(40.0));
    EXPECT_EQ(typesetter.missing(), std::vector<char32_t>{U'字'});
    EXPECT_TRUE(typesetter.fallbacks_used().empty());
    const TypesetMask without = typesetter.set("ab", caption(40.0));
    EXPECT_NEAR(with.advance_px - without.advance_px, 2.0 * 0.6 * 40.0, 1e-9);
    // Its left side is filled from top to bottom, its middle is empty.
    const auto ink = [&with](double x_px, double y_px) {
        const int column = static_cast<int>(x_px) - with.left_px;
        const int row = static_cast<int>(with.baseline_px - y_px);
        return with.coverage[static_cast<std::size_t>(row * with.width + column)];
    };
    const double left = without.advance_px + 0.05 * 40.0;
    EXPECT_GT(ink(left + 1.5, 14.0), 200);
    EXPECT_EQ(ink(left + 10.0, 14.0), 0);
    EXPECT_GT(ink(left + 10.0, 1.0), 100);
}

// In formulas, missing characters are set like text: a title may be a file's name in any script.
TEST(MissingCharacters, AreBoxesInFormulas) {
    FontSearch search;
    search.fallback_folders.clear();
    const Typesetter typesetter(installed_fonts(search));
    const double box = 0.6 * 40.0;
    const TypesetMask with = typesetter.set("ab字", label(40.0));
    EXPECT_EQ(typesetter.missing(), std::vector<char32_t>{U'字'});
    EXPECT_NEAR(with.advance_px - typesetter.set("ab", label(40.0)).advance_px, box, 1e-9);
    // The box carries scripts, works in fractions and under accents, and is smaller in a script.
    const double script = typesetter.set("x_字", label(40.0)).advance_px -
                          typesetter.set("x_{}", label(40.0)).advance_px;
    EXPECT_GT(script, 0.5 * box);
    EXPECT_LT(script, 0.9 * box);
    for (const char* text : {"字_1^2", "\\frac{字}{Ж}", "\\dot{字}", "\\vec{Ж}", "\\mathbf{字}"})
        EXPECT_GT(typesetter.set(text, label(40.0)).width, 0) << text;
    EXPECT_GT(typesetter.set("a caption of $字_1$", caption(40.0)).width, 0);
}

TEST(MissingCharacters, InFormulasComeFromASystemFont) {
    const std::string file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no fonts-dejavu here";
    const Typesetter typesetter(installed_fonts());
    EXPECT_GT(typesetter.set("Ж_1", label(40.0)).width, 20);
    EXPECT_TRUE(typesetter.missing().empty());
    ASSERT_EQ(typesetter.fallbacks_used().size(), 1u);
    EXPECT_EQ(typesetter.fallbacks_used()[0].string(), file);
}

TEST(MissingCharacters, ComeFromASystemFont) {
    const std::string file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no fonts-dejavu here";
    const Typesetter typesetter(installed_fonts());
    const TypesetMask mask = typesetter.set("Волчок", caption(40.0));
    EXPECT_TRUE(typesetter.missing().empty());
    ASSERT_EQ(typesetter.fallbacks_used().size(), 1u);
    EXPECT_EQ(typesetter.fallbacks_used()[0].string(), file);
    EXPECT_GT(mask.width, 100);
    // The other letters of the caption do not change.
    EXPECT_EQ(typesetter.set("ab", caption(40.0)).coverage,
              Typesetter(installed_fonts()).set("ab", caption(40.0)).coverage);
}

TEST(MissingCharacters, AreSearchedInAFixedOrder) {
    const auto files = fonts_below(system_font_folders());
    EXPECT_EQ(files, fonts_below(system_font_folders()));
    EXPECT_TRUE(fonts_below({"/nonexistent"}).empty());
}

TEST(Mistakes, MissingFontNamesItsPackage) {
    const Typesetter typesetter(installed_fonts(FontSearch{{"/nonexistent"}}));
    try {
        typesetter.set("x");
        FAIL();
    } catch (const EnvironmentError& error) {
        EXPECT_NE(std::string(error.what()).find("fonts-lmodern"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("latinmodern-math.otf"), std::string::npos);
    }
    EXPECT_THROW(find_font("latinmodern-math.otf", FontSearch{{}}), EnvironmentError);
}

TEST(Mistakes, InvalidStylesAreRejected) {
    const Typesetter typesetter(installed_fonts());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double size : {0.0, -1.0, 0.5, 5000.0, nan}) {
        EXPECT_THROW(typesetter.set("x", label(size)), InputError) << size;
    }
    for (const double width : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(typesetter.set("x", caption(20.0, width)), InputError) << width;
    }
    TypeStyle style = caption(20.0);
    style.line_spacing = nan;
    EXPECT_THROW(typesetter.set("x", style), InputError);
}

TEST(Mistakes, TooLargeMasksAreRejected) {
    const Typesetter typesetter(installed_fonts());
    EXPECT_THROW(typesetter.set(std::string(1000, 'x'), label(80.0)), InputError);
    EXPECT_THROW(typesetter.set("x\\quad\\quad\\quad\\quad x", caption(4096.0)), Error);
    // Space without ink needs no mask.
    EXPECT_NO_THROW(typesetter.set("\\quad\\quad\\quad", label(4096.0)));
    const TypesetMask large = typesetter.set("\\omega", label(4096.0));
    EXPECT_GT(large.width, 2000);
}

// RapidCheck reads its seed from the environment once.
const bool is_seeded = ::setenv("RC_PARAMS", "seed=4179 max_success=3000 max_size=60", 1) == 0;

// Pieces of labels in random order: mostly mistakes, sometimes deep or strange formulas.
rc::Gen<std::string> random_label() {
    return rc::gen::map(
        rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{
            "\\omega", "\\mathbf",   "\\sqrt", "\\frac", "\\dot",    "\\vec", "\\left", "\\right",
            "\\text",  "\\overline", "\\sum",  "\\int",  "\\sin",    "{",     "}",      "{",
            "}",       "[",          "]",      "_",      "^",        "'",     "$",      "(",
            ")",       "|",          " ",      "x",      "L",        "1",     "2",      "=",
            "+",       "-",          "\\",     "\\,",    "~",        "\n",    "₁",      "²",
            "ω",       "\u0307",     "字",     "\\quad", "\\textbf", "\\\\",  "--",     "\x1b",
            "\xff",    "&",          "%"})),
        [](const std::vector<std::string>& pieces) {
            std::string joined;
            for (const std::string& piece : pieces) joined += piece;
            return joined;
        });
}

TEST(RandomLabels, AreSetOrRejected) {
    ASSERT_TRUE(is_seeded);
    const Typesetter typesetter(installed_fonts());
    int n_set = 0, n_refused = 0;
    const bool holds = rc::check("a label is set, or refused with a column within it", [&] {
        const std::string text = *random_label();
        for (const TypeStyle& style : {label(12.0), caption(12.0, 80.0)}) {
            try {
                const TypesetMask mask = typesetter.set(text, style);
                RC_ASSERT(mask.coverage.size() == static_cast<std::size_t>(mask.width) *
                                                      static_cast<std::size_t>(mask.height));
                ++n_set;
            } catch (const LabelError& error) {
                RC_ASSERT(error.column() >= 1);
                RC_ASSERT(error.column() <= static_cast<int>(text.size()) + 1);
                ++n_refused;
            }
        }
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(n_set, 100);
    EXPECT_GT(n_refused, 100);
}

TEST(RandomLabels, BytesAreSetOrRejected) {
    const Typesetter typesetter(installed_fonts());
    EXPECT_TRUE(rc::check("any bytes", [&](const std::string& bytes) {
        for (const TypeStyle& style : {label(12.0), caption(12.0, 80.0)}) {
            try {
                typesetter.set(bytes, style);
            } catch (const LabelError& error) {
                RC_ASSERT(error.column() >= 1);
            }
        }
    }));
}

// A program without files, such as a page in a browser, hands the bytes of its fonts over.
TEST(Typesetter, FontsInMemoryGiveTheSameMasks) {
    std::vector<std::string> bytes;
    std::vector<FontBytes> fonts;
    for (const std::string_view name : font_names()) bytes.push_back(read_text(find_font(name)));
    for (std::size_t i = 0; i < bytes.size(); ++i) fonts.push_back({font_names()[i], bytes[i]});
    const Typesetter typesetter(fonts_in_memory(fonts)), of_files(installed_fonts());
    for (const TypeMode mode : {TypeMode::math, TypeMode::text}) {
        const std::string text =
            mode == TypeMode::math ? "\\frac{\\boldsymbol\\omega}{\\sqrt{2T}}" : "a $L$ efficient";
        const TypesetMask given = typesetter.set(text, {.size_px = 40.0, .mode = mode});
        const TypesetMask read = of_files.set(text, {.size_px = 40.0, .mode = mode});
        EXPECT_GT(given.width, 20);
        EXPECT_EQ(given.coverage, read.coverage);
    }
    // Without fallbacks, a character that they lack is a box.
    typesetter.set("\u4e00", {.mode = TypeMode::text});
    EXPECT_EQ(typesetter.missing(), std::vector<char32_t>{U'\u4e00'});
    EXPECT_TRUE(typesetter.fallbacks_used().empty());
    EXPECT_THROW(Typesetter(FontSource{}).set("a"), EnvironmentError);
}

}  // namespace
}  // namespace poinsot
