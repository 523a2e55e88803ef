// Letters of the plain alphabet for letters of the mathematical ones.
#include "vector/font_face.h"

#include <gtest/gtest.h>

namespace poinsot::vector {
namespace {

TEST(PlainLetter, ConvertsMathematicalLetters) {
    EXPECT_EQ(plain_letter(U'\U0001D6DA'), U'ω');  // bold small omega
    EXPECT_EQ(plain_letter(U'\U0001D74E'), U'ω');  // bold italic
    EXPECT_EQ(plain_letter(U'\U0001D43F'), U'L');
    EXPECT_EQ(plain_letter(U'\U0001D40B'), U'L');
    EXPECT_EQ(plain_letter(U'\U0001D7CF'), U'1');
    EXPECT_EQ(plain_letter(U'√'), U'√');
}

}  // namespace
}  // namespace poinsot::vector
