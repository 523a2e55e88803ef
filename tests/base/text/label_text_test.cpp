// File names as captions.
#include "text/label_text.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(AsCaption, KeepsPlainNames) {
    for (const char* name : {"", "generic", "tennis-racket 2", "Foucault's", "Волчок", "陀螺", "ω"})
        EXPECT_EQ(as_caption(name), name);
}

TEST(AsCaption, EscapesMarkup) {
    EXPECT_EQ(as_caption("a$b"), "a\\$b");
    EXPECT_EQ(as_caption("{x"), "\\{x");
    EXPECT_EQ(as_caption("a_b&c%#}"), "a\\_b\\&c\\%\\#\\}");
    EXPECT_EQ(as_caption("a\\b~"), "a$\\backslash$b$\\sim$");
    EXPECT_EQ(as_caption("a--b---c"), "a-{}-b-{}-{}-c");
    EXPECT_EQ(as_caption("-5 -.5"), "-{}5 -{}.5");
    EXPECT_EQ(as_caption("a\u202eb\n\xff"), "a\ufffdb\ufffd\ufffd");
    EXPECT_EQ(as_caption("a  b"), "a \\ b");
}

}  // namespace
}  // namespace poinsot
