// The meaning of labels and captions, and error messages with their columns.
#include "typeset/label_parser.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "typeset/label_cursor.h"
#include "typeset/label_error.h"
#include "typeset/symbols.h"

namespace poinsot {
namespace {

using Kind = MathAtom::Kind;

struct Mistake {
    std::string label;
    int column;
    std::string says;  // expected part of the message
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.label; }

template <typename Parse>
void expect_mistake(const Mistake& mistake, Parse parse) {
    try {
        parse(mistake.label);
        FAIL() << mistake.label << " was accepted";
    } catch (const LabelError& error) {
        EXPECT_EQ(error.column(), mistake.column) << mistake.label << ": " << error.what();
        EXPECT_NE(std::string(error.what()).find(mistake.says), std::string::npos)
            << mistake.label << ": " << error.what();
        EXPECT_EQ(std::string(error.what()).rfind("label column ", 0), 0u);
    }
}

class LabelMistakes : public testing::TestWithParam<Mistake> {};
TEST_P(LabelMistakes, AreNamedWithTheirColumn) { expect_mistake(GetParam(), parse_math); }
INSTANTIATE_TEST_SUITE_P(
    Labels, LabelMistakes,
    testing::Values(
        Mistake{"\\mathbf{L", 10, "expected } to close column 8, found the end"},
        Mistake{"\\sqrt{2T", 9, "expected } to close column 6"},
        Mistake{"\\sqrt[3{x}", 11, "expected ] to close column 6"},
        Mistake{"L}", 2, "} closes nothing"},
        Mistake{"\\omgea_1", 1, "unknown command \\omgea; did you mean \"omega\"?"},
        Mistake{"a + \\thta", 5, "did you mean \"theta\"?"},
        Mistake{"\\qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq", 1,
                "unknown command \\qqqqqqqqqqqqqqqqqqqqqqqq…"},
        Mistake{"x_", 3, "expected a subscript after _, found the end"},
        Mistake{"x^}", 3, "expected a superscript after ^, found }"},
        Mistake{"x_1_2", 4, "a second subscript"}, Mistake{"x^1^2", 4, "a second superscript"},
        Mistake{"x^2'", 4, "a prime after a superscript"}, Mistake{"ω₁_2", 3, "a second subscript"},
        Mistake{"\\frac{1}", 9, "expected the denominator of \\frac, found the end"},
        Mistake{"\\frac", 6, "expected the numerator of \\frac"},
        Mistake{"\\dot", 5, "expected an argument of \\dot"},
        Mistake{"\\text s", 6, "expected { after \\text"},
        Mistake{"\\text{a{b}}", 8, "does not stand within \\text"},
        Mistake{"\\text{a", 8, "expected } to close column 6"},
        Mistake{"$\\omega$", 1, "this is mathematics already"},
        Mistake{"\\left( x", 9, "expected \\right to close column 1"},
        Mistake{"\\left x\\right)", 7, "expected a delimiter"},
        Mistake{"\\left(x\\right", 14, "expected a delimiter"},
        Mistake{"x\\right)", 2, "\\right without \\left"},
        Mistake{"\\begin{array}x\\end{array}", 7, "expected {pmatrix} after \\begin"},
        Mistake{"\\begin{pmatrix} x & y", 22, "expected \\end{pmatrix} to close column 1"},
        Mistake{"\\begin{pmatrix}x\\end", 21, "expected {pmatrix} after \\end"},
        Mistake{"x\\end{pmatrix}", 2, "\\end without \\begin"},
        Mistake{"a\\", 3, "expected a command's name after the backslash, found the end"},
        Mistake{"a\\\u00e9", 2, "unknown command after the backslash"},
        Mistake{"ab\xff", 3, "not valid UTF-8"}, Mistake{"ab\xc3", 3, "not valid UTF-8"},
        Mistake{"\xe0\x80\x80", 1, "not valid UTF-8"},      // overlong
        Mistake{"\xed\xa0\x80", 1, "not valid UTF-8"},      // a surrogate
        Mistake{"\xf4\x90\x80\x80", 1, "not valid UTF-8"},  // past U+10FFFF
        Mistake{"a\x1b[31m", 2, "control character (U+001B)"},
        Mistake{std::string("a\0b", 3), 2, "control character (U+0000)"},
        Mistake{"ωω\\ome", 3, "unknown command"}));

class CaptionMistakes : public testing::TestWithParam<Mistake> {};
TEST_P(CaptionMistakes, AreNamedWithTheirColumn) { expect_mistake(GetParam(), parse_caption); }
INSTANTIATE_TEST_SUITE_P(
    Captions, CaptionMistakes,
    testing::Values(Mistake{"at $t = 1", 10, "expected $ to close column 4, found the end"},
                    Mistake{"the \\omega of it", 5, "write it within dollar signs: $\\omega$"},
                    Mistake{"the {word", 10, "expected } to close column 5"},
                    Mistake{"word}", 5, "} closes nothing"},
                    Mistake{"\\textbf word", 8, "expected { after \\textbf"},
                    Mistake{"\\emhp{word}", 1, "did you mean \"emph\"?"},
                    Mistake{"cost $x}$", 8, "} closes nothing"}));

TEST(LabelLimits, NestingIsBoundedForEveryConstruct) {
    const std::vector<std::string> openings{"{",      "\\sqrt{", "\\frac{",    "x_{",
                                            "\\dot{", "\\left(", "\\mathbf{",  "\\sqrt[",
                                            "\\dot",  "\\sqrt",  "\\bar\\vec", "\\begin{pmatrix}"};
    for (const std::string& opening : openings) {
        std::string label;
        while (label.size() + opening.size() < label_length_limit) label += opening;
        try {
            parse_math(label);
            ADD_FAILURE() << opening;
        } catch (const LabelError& error) {
            EXPECT_NE(std::string(error.what()).find("nested more than 32 deep"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_THROW(parse_caption(std::string(2000, '{')), LabelError);
}

TEST(LabelLimits, DeepestAndLongestLabelsAreAccepted) {
    // The label itself is the first level.
    const int groups = label_nesting_limit - 1;
    EXPECT_EQ(parse_math(std::string(groups, '{') + "xy" + std::string(groups, '}')).size(), 1u);
    EXPECT_THROW(parse_math(std::string(groups + 1, '{') + "xy" + std::string(groups + 1, '}')),
                 LabelError);
    EXPECT_EQ(parse_math(std::string(label_length_limit, 'x')).size(), 4096u);
    EXPECT_THROW(parse_math(std::string(label_length_limit + 1, 'x')), LabelError);
}

TEST(MathLabels, EmptyLabelHasNoAtoms) {
    EXPECT_TRUE(parse_math("").empty());
    EXPECT_TRUE(parse_math("  ").empty());
    EXPECT_TRUE(parse_caption("").empty());
}

TEST(MathLabels, LettersAreItalicDigitsAndCapitalGreekUpright) {
    const MathList atoms = parse_math("Lh2\\omega\\Omega\\phi\\varphi\\partial");
    ASSERT_EQ(atoms.size(), 8u);
    EXPECT_EQ(atoms[0].symbol, 0x1D43Fu);  // mathematical italic capital L
    EXPECT_EQ(atoms[1].symbol, 0x210Eu);   // this italic letter is in an older Unicode block
    EXPECT_EQ(atoms[2].symbol, U'2');
    EXPECT_EQ(atoms[3].symbol, 0x1D714u);  // mathematical italic small omega
    EXPECT_EQ(atoms[4].symbol, 0x3A9u);
    EXPECT_EQ(atoms[5].symbol, 0x1D719u);  // italic phi symbol, the closed form
    EXPECT_EQ(atoms[6].symbol, 0x1D711u);  // italic small phi, the open form
    EXPECT_EQ(atoms[7].symbol, 0x1D715u);
}

TEST(MathLabels, AlphabetsChangeLettersWithinTheirArgumentOnly) {
    const auto only = [](const char* label) {
        const MathList atoms = parse_math(label);
        EXPECT_EQ(atoms.size(), 1u) << label;
        return atoms.at(0).symbol;
    };
    EXPECT_EQ(only("\\mathbf{L}"), 0x1D40Bu);
    EXPECT_EQ(only("\\mathbf L"), 0x1D40Bu);
    EXPECT_EQ(only("\\mathbf1"), 0x1D7CFu);
    EXPECT_EQ(only("\\boldsymbol\\omega"), 0x1D74Eu);
    EXPECT_EQ(only("\\mathbf{\\omega}"), 0x1D6DAu);
    EXPECT_EQ(only("\\boldsymbol{\\Omega}"), 0x1D6C0u);
    EXPECT_EQ(only("\\mathrm{d}"), U'd');
    EXPECT_EQ(only("\\mathcal{L}"), 0x2112u);
    EXPECT_EQ(only("\\mathbf{\\mathrm L}"), U'L');
    EXPECT_EQ(parse_math("\\mathbf{a}b").at(1).symbol, 0x1D44Fu);
}

TEST(MathLabels, UnicodeAndCommandsAreEquivalent) {
    EXPECT_EQ(parse_math("ω").at(0).symbol, parse_math("\\omega").at(0).symbol);
    EXPECT_EQ(parse_math("≤").at(0).atom_class, AtomClass::rel);
    EXPECT_EQ(parse_math("-").at(0).symbol, 0x2212u);
    // A bare bar may open or close; \lvert and \rvert distinguish the two.
    EXPECT_EQ(parse_math("|").at(0).atom_class, AtomClass::ord);
    EXPECT_EQ(parse_math("\\lvert").at(0).atom_class, AtomClass::open);

    const MathList with_digits = parse_math("ω₁²");
    ASSERT_EQ(with_digits.size(), 1u);
    EXPECT_EQ(with_digits[0].subscript.at(0).symbol, U'1');
    EXPECT_EQ(with_digits[0].superscript.at(0).symbol, U'2');

    const MathList dotted = parse_math("ω\u0307");
    ASSERT_EQ(dotted.size(), 1u);
    EXPECT_EQ(dotted[0].kind, Kind::accent);
    EXPECT_EQ(dotted[0].body.at(0).symbol, 0x1D714u);
}

TEST(MathLabels, ScriptsBelongToThePrecedingAtom) {
    const MathList atoms = parse_math("I_1 \\omega^{2}_{ij} L'' f'^2");
    ASSERT_EQ(atoms.size(), 4u);
    EXPECT_EQ(atoms[0].subscript.size(), 1u);
    EXPECT_FALSE(atoms[0].has_superscript);
    EXPECT_EQ(atoms[1].subscript.size(), 2u);
    EXPECT_EQ(atoms[1].superscript.size(), 1u);
    EXPECT_EQ(atoms[2].superscript.size(), 2u);
    EXPECT_EQ(atoms[3].superscript.size(), 2u);
    // \dot\omega_1: the script belongs to the accented letter.
    const MathList dotted = parse_math("\\dot\\omega_1");
    ASSERT_EQ(dotted.size(), 1u);
    EXPECT_TRUE(dotted[0].has_subscript);
}

TEST(Captions, AreSplitIntoWordsFormulasAndSpaces) {
    const Caption caption = parse_caption("  a  $x$b \n\\textbf{c d}~e");
    ASSERT_EQ(caption.size(), 9u);
    using Piece = CaptionPiece::Kind;
    const Piece kinds[] = {Piece::text,  Piece::space,      Piece::formula,
                           Piece::text,  Piece::line_break, Piece::text,
                           Piece::space, Piece::text,       Piece::text};
    for (std::size_t i = 0; i < caption.size(); ++i) EXPECT_EQ(caption[i].kind, kinds[i]) << i;
    EXPECT_EQ(caption[5].text.face, TextFace::bold);
    EXPECT_EQ(caption[7].text.face, TextFace::bold);
    EXPECT_EQ(caption[8].text.face, TextFace::regular);
    EXPECT_EQ(caption[8].text.characters.at(0).code, U'\u00A0');
}

std::u32string caption_text(const char* text) {
    std::u32string joined;
    for (const CaptionPiece& piece : parse_caption(text)) {
        if (piece.kind == CaptionPiece::Kind::space) joined += U' ';
        for (const LabelCharacter& character : piece.text.characters) joined += character.code;
    }
    return joined;
}

TEST(Captions, HyphensBecomeMinusSignsOrDashes) {
    EXPECT_EQ(caption_text("from -1.25 s"), U"from \u22121.25 s");
    EXPECT_EQ(caption_text("t = -1.25"), U"t\u00A0=\u00A0\u22121.25");
    EXPECT_EQ(caption_text("(-.5)"), U"(\u2212.5)");
    EXPECT_EQ(caption_text("T-handle, 3-1"), U"T-handle, 3-1");
    EXPECT_EQ(caption_text("1--3 --- so"), U"1–3 — so");
    EXPECT_EQ(caption_text("``L''"), U"“L”");
    EXPECT_EQ(caption_text("5\\% \\$ \\{ \\_"), U"5% $ { _");
    EXPECT_EQ(caption_text("50% a_b ^"), U"50% a_b ^");
}

TEST(Captions, AreNotBrokenAtRelations) {
    EXPECT_EQ(caption_text("at t = 1.25 s"), U"at t\u00A0=\u00A01.25 s");
    EXPECT_EQ(caption_text("I > J"), U"I\u00A0>\u00A0J");
    EXPECT_EQ(caption_text("$x$ = 3"), U"\u00A0=\u00A03");
    EXPECT_EQ(caption_text("a=b c"), U"a=b c");
    EXPECT_EQ(caption_text("= a"), U"= a");
}

TEST(Commands, AreSortedUniqueAndFound) {
    const auto& commands = label_commands();
    for (std::size_t i = 1; i < commands.size(); ++i) {
        EXPECT_LT(commands[i - 1].name, commands[i].name);
    }
    for (const LabelCommand& command : commands) {
        EXPECT_EQ(find_label_command(command.name), &command);
    }
    EXPECT_EQ(find_label_command("omeg"), nullptr);
}

TEST(Messages, ContainNoTerminalControls) {
    EXPECT_EQ(describe(0x1B), "(U+001B)");
    EXPECT_EQ(describe(0x202E), "(U+202E)");
    EXPECT_EQ(describe(0x9B), "(U+009B)");
    EXPECT_EQ(describe(U'x'), "x");
    EXPECT_EQ(describe(U'字'), "字 (U+5B57)");
}

}  // namespace
}  // namespace poinsot
