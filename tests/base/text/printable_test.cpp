// Text from any source, for a terminal and for a JSON parser.
#include "text/printable.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "text/utf8.h"

namespace poinsot {
namespace {

TEST(Printable, KeepsVisibleText) {
    for (const char* text : {"", "Tennis racket", "ω₁ → 𝛀", "Волчок", "陀螺", "e\u0301", "a\\b\"c"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesControlAndHiddenCharacters) {
    EXPECT_EQ(printable("a\x1b[31m\n\t\x7f"), "a\\u001b[31m\\u000a\\u0009\\u007f");
    EXPECT_EQ(printable("\u009b\u2028\u2029"), "\\u009b\\u2028\\u2029");
    // A name that displays as "gpj.exe" right to left.
    EXPECT_EQ(printable("a\u202egpj.exe"), "a\\u202egpj.exe");
    EXPECT_EQ(printable("\u2066\u2067\u2069\u061c\u200e"), "\\u2066\\u2067\\u2069\\u061c\\u200e");
    EXPECT_EQ(printable("a\u200bb\u200c\u200d\u2060\ufeff\u00ad"),
              "a\\u200bb\\u200c\\u200d\\u2060\\ufeff\\u00ad");
    EXPECT_EQ(printable("\U000e0041"), "\\U000e0041");
}

TEST(Printable, EscapesInvalidUtf8) {
    EXPECT_EQ(printable("a\xff\xc3"), "a\\xff\\xc3");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
    EXPECT_EQ(printable("\xc0\x80"), "\\xc0\\x80");           // overlong
    EXPECT_EQ(printable("\x9b"), "\\x9b");                    // CSI in 8-bit encodings
}

TEST(Printable, TruncatesTheMiddleOfLongText) {
    const std::string text = "begin" + std::string(100'000, 'x') + "end";
    const std::string shown = printable(text, 100);
    EXPECT_TRUE(shown.starts_with("beginx"));
    EXPECT_TRUE(shown.ends_with("xend"));
    EXPECT_NE(shown.find("x…x"), std::string::npos);
    EXPECT_LE(shown.size(), 102u);  // the ellipsis is one character of three bytes
    EXPECT_EQ(printable(text, any_length), text);
    EXPECT_EQ(printable(std::string(400, 'x')), std::string(400, 'x'));
    EXPECT_LE(printable(std::string(100'000, '\xff')).size(), most_of_a_name + 2);
    // Truncated text is not shortened again.
    EXPECT_EQ(printable(shown, 100), shown);
}

TEST(Printable, TruncatesAtAnyLimit) {
    for (const char* text : {"aaaa\u202e\u202eaaaa", "\xff\xff\xff", "𝛀𝛀𝛀𝛀𝛀𝛀", "a"})
        for (std::size_t most = 1; most < 40; ++most) {
            const std::string shown = printable(text, most);
            std::size_t n_characters = 0;
            for (std::string_view rest = shown; !rest.empty(); ++n_characters)
                rest.remove_prefix(first_character(rest).size);
            EXPECT_LE(n_characters, most) << text << " " << most;
        }
}

TEST(JsonString, RoundTripsUtf8AndEscapesHiddenCharacters) {
    EXPECT_EQ(json_string("a\"b\\c\n"), R"("a\"b\\c\u000a")");
    EXPECT_EQ(json_string("ω 陀螺"), "\"ω 陀螺\"");
    EXPECT_EQ(json_string("\u202e\u200b\u009b"), R"("\u202e\u200b\u009b")");
    EXPECT_EQ(json_string("\U000e0041"), R"("\udb40\udc41")");
    EXPECT_EQ(json_string("a\xff\xc3"), "\"a\ufffd\ufffd\"");
}

// For any bytes, the result is UTF-8 without hidden characters.
TEST(Text, FromAnySourceBecomesVisibleUtf8) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> byte(0, 255), length(0, 40), code(0, 0x10ffff), kind(0, 2);
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        for (int k = length(random); k > 0; --k) {
            const auto c = static_cast<char32_t>(code(random));
            if (kind(random) == 0 || (c >= 0xd800 && c < 0xe000))
                text += static_cast<char>(byte(random));
            else
                text += utf8_of(kind(random) == 0 ? c : 0x2000 + c % 0x100);
        }
        for (const std::string& shown : {printable(text), json_string(text)})
            for (std::string_view rest = shown; !rest.empty();) {
                const Utf8Character character = first_character(rest);
                ASSERT_TRUE(character.valid) << shown;
                ASSERT_FALSE(is_hidden(character.code)) << shown;
                rest.remove_prefix(character.size);
            }
    }
}

TEST(Utf8, RoundTripsEveryCharacter) {
    for (char32_t code = 0; code <= 0x10ffff; ++code) {
        if (code >= 0xd800 && code < 0xe000) continue;
        const std::string text = utf8_of(code);
        const Utf8Character back = first_character(text);
        ASSERT_TRUE(back.valid);
        ASSERT_EQ(back.code, code);
        ASSERT_EQ(back.size, text.size());
    }
}

}  // namespace
}  // namespace poinsot
