#include "drawing/stage/type/caption_template.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "error/error.h"
#include "refusal.h"

namespace poinsot {
namespace {

const std::array<LiveValue, 2> values{{{"time_s", 1.25}, {"omega_1_rad_s", -0.5}}};

std::string error_of(std::string_view text) {
    return refusal_message([&] { expand_live_text(text, values); });
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

// One turn a second in units = ["deg"], 2.5 J in SI.
const std::array<LiveValue, 4> with_units{{{"omega_3", 360.0, "deg/s", true},
                                           {"omega_3_rad_s", 6.283185307179586, "rad/s"},
                                           {"T", 2.5, "J", true},
                                           {"L", 1.5, "kg m\u00b2/s", true}}};
std::string printed(std::string_view text) { return expand_live_text(text, with_units); }
std::vector<std::string> noted(std::string_view text) { return unit_notes(text, with_units); }

TEST(CaptionTemplate, BringsUnitsWhereTheNameHasNone) {
    EXPECT_EQ(printed("$\\omega_3$ = {omega_3:.0f}, and"), "$\\omega_3$ = 360~deg/s, and");
    EXPECT_EQ(printed("{L} and {T}"), "1.5~kg~m\u00b2/s and 2.5~J");
    EXPECT_EQ(printed("{omega_3_rad_s:.3f}"), "6.283");
    EXPECT_TRUE(noted("{omega_3}, {L} and {T}.").empty());
    const std::array<LiveValue, 1> angle{{{"theta", 30.0, "\u00b0", true}}};
    EXPECT_EQ(expand_live_text("{theta}", angle), "30\u00b0");
}

TEST(CaptionTemplate, GroupsTheDigitsOfLargeNumbers) {
    const std::array<LiveValue, 3> large{{{"L", 367568.37, "g cm\u00b2/s", true},
                                          {"n", -12345678.0},
                                          {"t", 9.96667, "s", true, ".2f"}}};
    EXPECT_EQ(expand_live_text("{L:.2f}", large, ","), "367\\,568,37~g~cm\u00b2/s");
    EXPECT_EQ(expand_live_text("{n:.0f}", large), "\u221212\\,345\\,678");
    EXPECT_EQ(expand_live_text("{n:.1e}", large), "\u22121.2e+07");
    EXPECT_EQ(printed("{T:.0f} {T}~mJ"), "2~J 2500~mJ");  // four digits stay together
    // A number may have a format of its own.
    EXPECT_EQ(expand_live_text("{t}, {t:.0f}", large), "9.97~s, 10~s");
}

TEST(CaptionTemplate, ShowsANumberInTheUnitBesideIt) {
    // However it is written.
    for (const char* unit :
         {"~rad/s", " rad/s", "\\,rad/s", "~$\\mathrm{rad/s}$", " $\\mathrm{rad\\,s^{-1}}$"})
        EXPECT_EQ(printed(std::string("{omega_3:.4f}") + unit), std::string("6.2832") + unit);
    EXPECT_EQ(printed("{L} kg m\u00b2/s"), "1.5 kg m\u00b2/s");
    EXPECT_EQ(printed("{T}~mJ"), "2500~mJ");
    // The unit of the scene, in another spelling.
    EXPECT_EQ(printed("{omega_3} \u00b0/s."), "360 \u00b0/s.");
    EXPECT_TRUE(noted("{omega_3} \u00b0/s.").empty());
    EXPECT_EQ(
        noted("{omega_3} rad/s"),
        std::vector<std::string>{"{omega_3} is shown in rad/s, which stands beside it, although "
                                 "its unit here is deg/s; leave the unit out, and the number "
                                 "brings its own"});
}

TEST(CaptionTemplate, NamesUnitsOfOtherKinds) {
    EXPECT_EQ(printed("{T}~rad/s"), "2.5~J~rad/s");
    EXPECT_EQ(noted("{T}~rad/s"), std::vector<std::string>{
                                      "\"rad/s\" stands beside {T}, which is shown in J; leave the "
                                      "unit out, since the number brings its own"});
    EXPECT_EQ(printed("{omega_3_rad_s:.2f}~deg/s"), "6.28~deg/s");
    EXPECT_EQ(noted("{omega_3_rad_s:.2f}~deg/s"),
              std::vector<std::string>{"\"deg/s\" stands beside {omega_3_rad_s}, which is a number "
                                       "in rad/s; write rad/s there"});
    EXPECT_EQ(noted("{omega_3_rad_s}~J, {T}~s").size(), 2u);
}

TEST(CaptionTemplate, TakesWordsForNoUnits) {
    for (const char* text :
         {"{omega_3} in the body", "{T} at every instant", "{T} J in the body", "{omega_3}: done",
          "{omega_3} m\u00eame", "{omega_3}", "{omega_3} $\\to$ {T}", "{omega_3_rad_s}~rad/s falls",
          "{omega_3} deg a day"})
        EXPECT_TRUE(noted(text).empty()) << text << ": " << noted(text).front();
}

TEST(CaptionTemplate, HasTheDecimalMarkOfTheLanguage) {
    EXPECT_EQ(expand_live_text("t. {omega_3_rad_s:.2f}. {T:.1e}", with_units, ","),
              "t. 6,28. 2,5e+00~J");
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
