// Which name is near enough to be guessed.
#include "text/nearest.h"

#include <gtest/gtest.h>

#include <array>

namespace poinsot {
namespace {

constexpr std::array<std::string_view, 7> names{"top",   "space", "iop",   "lecture",
                                                "draft", "--dpi", "--time"};

TEST(Nearest, IsANameOfWhichMostLettersAreRight) {
    EXPECT_EQ(did_you_mean("tpo", names), "; did you mean \"top\"?");
    EXPECT_EQ(did_you_mean("darft", names), "; did you mean \"draft\"?");
    EXPECT_EQ(did_you_mean("tip", names), "; did you mean \"top\"?");
    EXPECT_EQ(did_you_mean("sapce", names), "; did you mean \"space\"?");
    EXPECT_EQ(did_you_mean("lectur", names), "; did you mean \"lecture\"?");
    EXPECT_EQ(did_you_mean("--tiem", names), "; did you mean \"--time\"?");
}

// Two of three letters make no likeness.
TEST(Nearest, IsNothingFar) {
    for (const char* far : {"foo", "x", "", "abc", "tax", "loop", "xyzzy", "--fps"})
        EXPECT_EQ(did_you_mean(far, names), "") << far;
    EXPECT_EQ(choose_instead("foo", std::array<std::string_view, 2>{"top", "space"}),
              "; choose from: top, space");
}

}  // namespace
}  // namespace poinsot
