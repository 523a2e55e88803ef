// Numbers that fill a whole text.
#include "text/numbers.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(Numbers, AreAcceptedOnlyAsTheWholeText) {
    EXPECT_EQ(number_of<double>("-1.5e3"), -1500.0);
    EXPECT_EQ(number_of<int>("12"), 12);
    for (const char* text : {"", " 1", "1 ", "1x", "+1", "0x10", "1,5", "one", "--1"}) {
        EXPECT_FALSE(number_of<double>(text)) << text;
        EXPECT_FALSE(number_of<int>(text)) << text;
    }
    EXPECT_FALSE(number_of<int>("1.5"));
}

TEST(Numbers, AreWithinTheirRange) {
    EXPECT_FALSE(number_of<int>("2147483648"));
    EXPECT_EQ(number_of<std::int64_t>("2147483648"), 2147483648);
    EXPECT_FALSE(number_of<double>("1e999"));
}

TEST(Numbers, MayHaveOneSign) {
    EXPECT_EQ(without_plus("+3"), "3");
    EXPECT_EQ(without_plus("-3"), "-3");
    EXPECT_EQ(without_plus("+-3"), "+-3");  // "-3" after the plus sign would be a number; "+-3" is
                                            // not
}

TEST(Numbers, AreRemovedFromTheFront) {
    std::string_view text = "12 0\nrest";
    std::int64_t number = 0;
    EXPECT_TRUE(take_count(text, number, ' '));
    EXPECT_EQ(number, 12);
    EXPECT_TRUE(take_count(text, number, '\n'));
    EXPECT_EQ(number, 0);
    EXPECT_EQ(text, "rest");
    for (std::string_view wrong : {"-1 ", "1", "1x", "", " "})
        EXPECT_FALSE(take_count(wrong, number, ' ')) << wrong;
}

}  // namespace
}  // namespace poinsot
