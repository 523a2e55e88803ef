// Captions as plain text for subtitles.
#include "typeset/plain_text.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(PlainText, ConvertsCaptionsToReadableText) {
    EXPECT_EQ(plain_text("L stays; ω does not."), "L stays; ω does not.");
    EXPECT_EQ(plain_text("$\\mathbf{L}$ and $\\boldsymbol{\\omega}$"), "L and ω");
    EXPECT_EQ(plain_text("$I_1 = 3$~kg~m²"), "I₁ = 3 kg m²");
    EXPECT_EQ(plain_text("$\\sqrt{2T}/L$"), "√(2T)/L");
    EXPECT_EQ(plain_text("$e^{-3}$"), "e⁻³");
    EXPECT_EQ(plain_text("$\\begin{pmatrix}1 & 2 \\\\ 3 & 4\\end{pmatrix}$"), "(1, 2; 3, 4)");
    EXPECT_EQ(plain_text("$L^2/(2I_\\mathrm{max})$"), "L²/(2I_max)");
    EXPECT_EQ(plain_text("\\textbf{a} -- b\\\\c"), "a – b\nc");
    EXPECT_EQ(plain_text("\\$5 \\& 3\\%"), "$5 & 3%");
    EXPECT_EQ(plain_text(""), "");
}

}  // namespace
}  // namespace poinsot
