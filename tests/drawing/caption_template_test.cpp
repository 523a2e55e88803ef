#include "drawing/stage/type/caption_template.h"

#include <gtest/gtest.h>

#include <array>

#include "error/error.h"

namespace poinsot {
namespace {

const std::array<LiveValue, 2> values{{{"time_s", 1.25}, {"omega_1_rad_s", -0.5}}};

std::string error_of(std::string_view text) {
    try {
        expand_live_text(text, values);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(CaptionTemplate, ReplacesNumbersInTheirFormat) {
    EXPECT_EQ(expand_live_text("t = {time_s:.3f} s", values), "t = 1.250 s");
    EXPECT_EQ(expand_live_text("{time_s}", values), "1.25");
}

TEST(CaptionTemplate, WritesNegativeNumbersWithAMinusSign) {
    EXPECT_EQ(expand_live_text("{omega_1_rad_s:.1f}", values), "\u22120.5");
}

TEST(CaptionTemplate, DoesNotChangeFormulas) {
    EXPECT_EQ(expand_live_text("$\\mathbf{L}$ at {time_s:.0f}", values), "$\\mathbf{L}$ at 1");
    EXPECT_FALSE(is_live("$\\mathbf{L}$ is kept"));
    EXPECT_TRUE(is_live("{time_s}"));
}

TEST(CaptionTemplate, DoesNotChangeArgumentsOfCommands) {
    EXPECT_EQ(expand_live_text("\\textbf{never {x}} {time_s:.0f}", values),
              "\\textbf{never {x}} 1");
    EXPECT_FALSE(is_live("\\emph{stable}"));
}

TEST(CaptionTemplate, DoubledBracesAreLiteralBraces) {
    EXPECT_EQ(expand_live_text("{{x}}", values), "{x}");
    EXPECT_FALSE(is_live("{{x}}"));
}

TEST(CaptionTemplate, ReportsErrorsWithTheirColumn) {
    EXPECT_EQ(error_of("at {time}"),
              "caption column 5: no number called \"time\"; did you mean \"time_s\"?");
    EXPECT_EQ(error_of("at {xyzzy}"),
              "caption column 5: no number called \"xyzzy\"; choose from: time_s, omega_1_rad_s");
    EXPECT_EQ(error_of("at {time_s"),
              "caption column 4: a brace without its partner; double it to print a brace");
    EXPECT_EQ(error_of("}"),
              "caption column 1: a brace without its partner; double it to print a brace");
    EXPECT_NE(error_of("{time_s:.999999f}"), "");
    EXPECT_NE(error_of("{time_s:s}"), "");
}

}  // namespace
}  // namespace poinsot
