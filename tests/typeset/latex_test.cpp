// Labels and captions as LaTeX reads them.
#include "typeset/latex.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

std::string label(std::string_view text) { return latex_of(text, TypeMode::math); }
std::string caption(std::string_view text) { return latex_of(text, TypeMode::text); }

TEST(Latex, SaysALabelInItsOwnCommands) {
    EXPECT_EQ(label("L"), "$\\displaystyle L$");
    EXPECT_EQ(label("\\mathbf{L}"), "$\\displaystyle \\mathbf{L}$");
    EXPECT_EQ(label("\\omega_1"), "$\\displaystyle \\omega _{1}$");
    EXPECT_EQ(label("\\boldsymbol{\\omega}"), "$\\displaystyle \\boldsymbol{\\omega }$");
    EXPECT_EQ(label("\\sqrt{2T}/L"), "$\\displaystyle \\sqrt{2T}/L$");
    EXPECT_EQ(label("\\frac{a}{b}"), "$\\displaystyle \\frac{a}{b}$");
    EXPECT_EQ(label("\\dot\\theta"), "$\\displaystyle \\dot{\\theta }$");
    EXPECT_EQ(label("\\left(x\\right)"), "$\\displaystyle \\left( x\\right) $");
}

TEST(Latex, UnicodeAndCommandsAreOne) {
    EXPECT_EQ(label("ω₁"), label("\\omega_1"));
    EXPECT_EQ(label("a·b"), label("a\\cdot b"));
    EXPECT_EQ(label("-1"), "$\\displaystyle -1$");
    EXPECT_EQ(label("\\mathrm{kg}"), "$\\displaystyle {\\mathrm{k}\\mathrm{g}}$");
}

TEST(Latex, RunningTextKeepsItsWordsAndHidesWhatLatexReads) {
    EXPECT_EQ(caption("Two words"), "Two words");
    EXPECT_EQ(caption("100\\% of \\$5 \\& more \\#1 a\\_b"), "100\\% of \\$5 \\& more \\#1 a\\_b");
    EXPECT_EQ(caption("at $t = 1$ s"), "at $t=1$ s");
    EXPECT_EQ(caption("kg m²"), "kg m$^{2}$");
    EXPECT_EQ(caption("ω in rad/s"), "$\\omega$ in rad/s");
    EXPECT_EQ(caption("a -- b"), "a -- b");
    EXPECT_EQ(caption("\\textbf{bold} \\emph{slanted}"), "\\textbf{bold} \\textit{slanted}");
    EXPECT_EQ(caption("one\\\\two"), "one\\\\ two");
}

}  // namespace
}  // namespace poinsot
