// Which texts have control characters: by the list of Unicode's general categories Cc, Zl and Zp.
#include "text/control_characters.h"

#include <gtest/gtest.h>

#include <string>

namespace poinsot {
namespace {

TEST(ControlCharacters, AreFoundAnywhere) {
    for (int code = 0; code < 0x80; ++code) {
        const bool is_one = code < 0x20 || code == 0x7f;
        EXPECT_EQ(has_control_characters("a" + std::string(1, static_cast<char>(code)) + "b"),
                  is_one)
            << code;
    }
    for (const char* one : {"\xc2\x80", "\xc2\x9b[2J", "a\xe2\x80\xa8", "\xe2\x80\xa9z"})
        EXPECT_TRUE(has_control_characters(one)) << one;
    // Letters, spaces, and bytes that are no UTF-8.
    for (const char* none :
         {"", "a b.toml", "\xc2\xa0", "\xc3\xa9", "\xf0\x9f\x99\x82", "\x9b", "\xff"})
        EXPECT_FALSE(has_control_characters(none)) << none;
}

}  // namespace
}  // namespace poinsot
