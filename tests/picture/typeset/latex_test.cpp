// Labels and captions as LaTeX source.
#include "typeset/latex.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "text/utf8.h"

namespace poinsot {
namespace {

std::string label(std::string_view text) {
    LatexGaps gaps;
    return latex_of(text, TypeMode::math, gaps);
}
std::string caption(std::string_view text) {
    LatexGaps gaps;
    return latex_of(text, TypeMode::text, gaps);
}

TEST(Latex, ConvertsLabelsToLatexCommands) {
    EXPECT_EQ(label("L"), "$\\displaystyle L$");
    EXPECT_EQ(label("\\mathbf{L}"), "$\\displaystyle \\mathbf{L}$");
    EXPECT_EQ(label("\\omega_1"), "$\\displaystyle \\omega _{1}$");
    EXPECT_EQ(label("\\boldsymbol{\\omega}"), "$\\displaystyle \\boldsymbol{\\omega }$");
    EXPECT_EQ(label("\\sqrt{2T}/L"), "$\\displaystyle \\sqrt{2T}/L$");
    EXPECT_EQ(label("\\frac{a}{b}"), "$\\displaystyle \\frac{a}{b}$");
    EXPECT_EQ(label("\\dot\\theta"), "$\\displaystyle \\dot{\\theta }$");
    EXPECT_EQ(label("\\left(x\\right)"), "$\\displaystyle \\left( x\\right) $");
    EXPECT_EQ(label("\\begin{pmatrix} 1 & -2 \\\\ x & 0 \\\\ \\end{pmatrix}"),
              "$\\displaystyle \\left( \\begin{array}{cc}1 & -2\\\\{} x & 0\\end{array}\\right) $");
}

TEST(Latex, UnicodeAndCommandsAreEquivalent) {
    EXPECT_EQ(label("ω₁"), label("\\omega_1"));
    EXPECT_EQ(label("a·b"), label("a\\cdot b"));
    EXPECT_EQ(label("-1"), "$\\displaystyle -1$");
    EXPECT_EQ(label("\\mathrm{kg}"), "$\\displaystyle {\\mathrm{k}\\mathrm{g}}$");
}

TEST(Latex, EscapesSpecialCharactersInRunningText) {
    EXPECT_EQ(caption("Two words"), "Two words");
    EXPECT_EQ(caption("100\\% of \\$5 \\& more \\#1 a\\_b"), "100\\% of \\$5 \\& more \\#1 a\\_b");
    EXPECT_EQ(caption("at $t = 1$ s"), "at $t=1$ s");
    EXPECT_EQ(caption("kg m²"), "kg m$^{2}$");
    EXPECT_EQ(caption("ω in rad/s"), "$\\omega$ in rad/s");
    EXPECT_EQ(caption("a -- b"), "a -- b");
    EXPECT_EQ(caption("\\textbf{bold} \\emph{slanted}"), "\\textbf{bold} \\textit{slanted}");
    EXPECT_EQ(caption("one\\\\two"), "one\\\\{} two");
}

using Characters = std::vector<char32_t>;

TEST(Latex, LeavesOutWhatHasNoPictureAndSaysSo) {
    LatexGaps gaps;
    EXPECT_EQ(latex_of("a\u200bb\ufe0fc\uffff\U0001fffe\u200bd", TypeMode::text, gaps), "abcd");
    EXPECT_EQ(gaps.hidden, (Characters{0x200b, 0xfe0f, 0xffff, 0x1fffe}));
    EXPECT_TRUE(gaps.need_t1.empty() && gaps.need_unicode.empty());
    EXPECT_EQ(caption("a \u00ad b"), "a  b");
    EXPECT_EQ(label("\\text{a\u200b}"), "$\\displaystyle \\mbox{a}$");
}

TEST(Latex, MarksWhatNotEveryDocumentSets) {
    LatexGaps gaps;
    EXPECT_EQ(latex_of("é «陀»陀", TypeMode::text, gaps),
              "é \\poinsotonly{T1}{«}\\poinsotonly{TU}{陀}\\poinsotonly{T1}{»}"
              "\\poinsotonly{TU}{陀}");
    EXPECT_EQ(gaps.need_t1, (Characters{U'«', U'»'}));
    EXPECT_EQ(gaps.need_unicode, (Characters{U'陀'}));
    EXPECT_TRUE(gaps.hidden.empty());
}

// What pdflatex says of a document, its first complaint or nothing.
std::string complaint_about(const std::string& preamble, const std::string& body) {
    std::string name = (std::filesystem::temp_directory_path() / "poinsot-latex-XXXXXX").string();
    const std::filesystem::path folder = mkdtemp(name.data());
    std::ofstream(folder / "all.tex")
        << "\\documentclass{article}" << preamble << "\\begin{document}\n"
        << body << "\\end{document}\n";
    const std::string command = "cd '" + folder.string() +
                                "' && pdflatex -draftmode -halt-on-error "
                                "-interaction=nonstopmode all.tex >said 2>&1";
    const int status = std::system(command.c_str());
    std::ifstream log(folder / "all.log");
    std::string found;
    for (std::string line; found.empty() && std::getline(log, line);)
        if (line.starts_with("! ") || line.starts_with("Missing character")) {
            found = line;
            while (std::getline(log, line) && !line.starts_with("l.")) {
            }
            found += "; " + line;
        }
    std::filesystem::remove_all(folder);
    return found.empty() && status != 0 ? "pdflatex failed" : found;
}

// Every character that is written unchanged or as a command, and, with T1, those that need it.
TEST(Latex, SetsEveryCharacterThatItKeeps) {
    if (std::system("command -v pdflatex >/dev/null 2>&1") != 0) GTEST_SKIP() << "no pdflatex";
    std::string plain, with_t1;
    int n_kept = 0;
    for (char32_t c = 0xa0; c < 0x1d800; ++c) {
        if (c == 0xd800) c = 0xe000;
        if (c == 0x10000) c = 0x1d400;
        if (is_hidden(c)) continue;
        LatexGaps gaps;
        const std::string text = latex_of(utf8_of(c), TypeMode::text, gaps);
        const std::string line = "x\\hbox{" + text + "}\n\n";
        if (!gaps.need_unicode.empty() || text.empty()) continue;
        (gaps.need_t1.empty() ? plain : with_t1) += line;
        ++n_kept;
    }
    EXPECT_GT(n_kept, 800);  // 833
    // As in the figure (production/vectors/latex_figure.cpp).
    const std::string commands = R"(
\providecommand\boldsymbol[1]{\mbox{\boldmath$#1$}}
\providecommand\mathbb[1]{\mathbf{#1}}
\newcommand\poinsotonly[2]{#2}
)";
    EXPECT_EQ(complaint_about(commands, plain), "");
    EXPECT_EQ(complaint_about("\\usepackage[T1]{fontenc}" + commands, plain + with_t1), "");
    EXPECT_NE(complaint_about(commands, with_t1), "");
}

}  // namespace
}  // namespace poinsot
