// Text made to break a parser or a terminal is refused, or printed harmlessly.
#include <gtest/gtest.h>

#include <string>

#include "scene/toml/toml_document.h"
#include "scene_text.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

std::string repeated(const std::string& text, int n) {
    std::string all;
    for (int i = 0; i < n; ++i) all += text;
    return all;
}

TEST(InputLimits, ControlCharactersAreRefusedWithTheirPlace) {
    // [\x18a] aborts toml++ 3.3 where its assertions are compiled in.
    EXPECT_EQ(refusal("\n[\x18"
                      "a]\n"),
              "scenes/a.toml:2:2: control character U+0018; remove it");
    EXPECT_EQ(refusal("é = \"\x1b[31m\"\n"),
              "scenes/a.toml:1:6: control character U+001B; remove it");
    EXPECT_EQ(refusal("a = \"\u009b31m\"\n"),
              "scenes/a.toml:1:6: control character U+009B; remove it");
    EXPECT_EQ(refusal("a = 1\rb = 2\n"), "scenes/a.toml:1:6: control character U+000D; remove it");
}

TEST(InputLimits, WindowsLineEndsAndTabsAreAccepted) {
    const Scene scene = scene_of(
        "title\t= \"x\"\r\n[body]\r\nmoments_kg_m2 = [3,2,1]\r\n[start]\r\n"
        "omega_rad_s = [1, 2, 3]\r\n");
    EXPECT_EQ(scene.title, "x");
    EXPECT_EQ(scene.locations.at("start.omega_rad_s").line, 5);
}

TEST(InputLimits, EscapedControlCharactersInStringsAreRefused) {
    EXPECT_EQ(refusal("title = \"\\u001b[31mred\"\n"),
              "scenes/a.toml:1:9: title contains the control character U+001B; remove it");
    EXPECT_EQ(refusal("[film]\nquality = \"\\u009b\"\n"),
              "scenes/a.toml:2:11: film.quality contains the control character U+009B; remove it");
}

TEST(InputLimits, PrintedKeysContainNoControlCharacters) {
    const std::string message = refusal("\"\\u001b[31m\\u009b\" = 1\n");
    EXPECT_EQ(message.rfind("scenes/a.toml:1:1: unknown key \"\\u001b[31m\\u009b\"", 0), 0u)
        << message;
    const std::string file = "\x1b[31m.toml";
    try {
        parse_scene("x = 1", file);
        FAIL() << "accepted";
    } catch (const SceneError& error) {
        EXPECT_EQ(std::string(error.what()).rfind("\\u001b[31m.toml:1:1: ", 0), 0u) << error.what();
    }
    EXPECT_EQ(refusal(a_scene, {"x\x1b=1"}).rfind("--set x\\u001b=1: unknown key \"x\\u001b\"", 0),
              0u);
}

TEST(InputLimits, LongTextIsShortenedInMessages) {
    const std::string message = refusal(repeated("x", 100000) + " = 1\n");
    EXPECT_LT(message.size(), 1000u);
    EXPECT_NE(message.find("xxx…xxx"), std::string::npos);
}

TEST(InputLimits, DeepNestingIsRefusedBeforeParsing) {
    EXPECT_EQ(refusal("a = " + repeated("[", 17) + repeated("]", 17)),
              "scenes/a.toml:1:21: brackets nested more than 16 deep; no key of a scene needs "
              "that, remove them");
    EXPECT_EQ(refusal("\na = " + repeated("{b = [", 1000)),
              "scenes/a.toml:2:53: brackets nested more than 16 deep; no key of a scene needs "
              "that, remove them");
    EXPECT_EQ(refusal("a" + repeated(".a", 16) + " = 1\n"),
              "scenes/a.toml:1:32: a key of more than 16 parts; no key of a scene has that many, "
              "shorten it");
    EXPECT_EQ(refusal(repeated("\"a\".", 20000) + "b = 1\n"),
              "scenes/a.toml:1:64: a key of more than 16 parts; no key of a scene has that many, "
              "shorten it");
}

TEST(InputLimits, BracketsAndDotsInStringsAndCommentsAreText) {
    const std::string text =
        "title = \"[[[[[[[[[[[[[[[[[[[[ \\\" ................. {{{{{{{{{{{{{{{{{{{{\"\n"
        "# [[[[[[[[[[[[[[[[[[[[[[[[[ .................. \"\n"
        "caption = '''[[[[[[[[[[[[[[[[[[[[\n ''[[[[[[ ................... '''\n" +
        a_scene;
    EXPECT_NO_THROW(scene_of(text));
    // An escaped closing quote does not hide the text after the real one.
    EXPECT_EQ(refusal("title = \"\\\\\"\na = " + repeated("[", 17)).rfind("scenes/a.toml:2:21:", 0),
              0u);
}

TEST(InputLimits, LettersOutsideOfQuotesAreRefusedBeforeParsing) {
    // toml++ 3.3 has undefined behaviour for some of them.
    EXPECT_EQ(refusal("[moments1.\u00b2 "),
              "scenes/a.toml:1:11: \"\u00b2\" stands outside of quotes; put text in quotes");
    EXPECT_EQ(refusal("[film]\n\u00a0fps = 30\n"),
              "scenes/a.toml:2:1: \"\u00a0\" stands outside of quotes; put text in quotes");
    EXPECT_EQ(refusal("ω = 3\n"),
              "scenes/a.toml:1:1: \"ω\" stands outside of quotes; put text in quotes");
    EXPECT_EQ(scene_of("\xef\xbb\xbf" + a_scene).body.inertia.moments_kg_m2()[0], 3.0);
    EXPECT_EQ(scene_of(a_scene, {"title=ω of t"}).title, "ω of t");
}

TEST(InputLimits, LongListsOfNumbersAreNotDeepKeys) {
    const Scene scene = scene_of(a_start, {"body.masses=[{mass_kg=1.5,at_m=[0.5,0.5,0.5]},"
                                           "{mass_kg=1.5,at_m=[0.5,1.5,0.5]},"
                                           "{mass_kg=1.5,at_m=[0.5,0.5,1.5]},"
                                           "{mass_kg=1.5,at_m=[1.5,0.5,0.5]},"
                                           "{mass_kg=1.5,at_m=[1.5,1.5,0.5]}]"});
    EXPECT_EQ(scene.body.masses.size(), 5u);
}

TEST(InputLimits, InputsThatBrokeTheParserAreRefused) {
    for (const char* const text :
         {"[[[a]]]", "[[a]", "[a\n", "a = {", "a = \"\\", "a = '''", "=", "a = 1e99999", "a = 0x",
          "[a]\n[a]\n", "a.b = 1\na = 2\n", "a = [1, 2\n", "\xef\xbb\xbf\xef\xbb\xbf",
          "a = 99999999999999999999", "a = 1979-13-45", "\"\" = 1", "a = {b = 1, b = 2}"}) {
        EXPECT_THROW(scene_of(text), SceneError) << text;
    }
}

TEST(InputLimits, CharactersAreDecodedByTheUnicodeStandard) {
    // Unicode 15, table 3-7: first and last of each length, and ill-formed sequences.
    EXPECT_EQ(first_character("\x7f").code, 0x7fu);
    EXPECT_EQ(first_character("\xc2\x80").code, 0x80u);
    EXPECT_EQ(first_character("\xdf\xbf").code, 0x7ffu);
    EXPECT_EQ(first_character("\xe0\xa0\x80").code, 0x800u);
    EXPECT_EQ(first_character("\xef\xbf\xbf").code, 0xffffu);
    EXPECT_EQ(first_character("\xf0\x90\x80\x80").code, 0x10000u);
    EXPECT_EQ(first_character("\xf4\x8f\xbf\xbf").code, 0x10ffffu);
    for (const char* const bad :
         {"\x80", "\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xc3", "\xe2\x82", "\xe2(\xa1", "\xff"}) {
        EXPECT_FALSE(first_character(bad).valid) << bad;
        EXPECT_EQ(first_character(bad).size, 1u);
    }
}

}  // namespace

}  // namespace poinsot
