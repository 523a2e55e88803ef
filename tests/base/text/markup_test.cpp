// Escaped text stays text in markup and scripts, whatever its bytes.
#include "text/markup.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace poinsot {
namespace {

TEST(EscapedMarkup, EscapesMarkupCharacters) {
    EXPECT_EQ(escaped_markup("<b a=\"1\" c='2'>&amp;"),
              "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
    EXPECT_EQ(escaped_markup("ω₁ → 𝛀"), "ω₁ → 𝛀");
}

// XML 1.0 §2.2 lists the characters that a document may contain.
TEST(EscapedMarkup, ContainsOnlyCharactersThatXmlAllows) {
    EXPECT_EQ(escaped_markup(std::string_view("a\0b\x1b[31m\x7f", 9)), "a\ufffdb\ufffd[31m\ufffd");
    EXPECT_EQ(escaped_markup("a\tb\nc"), "a\tb\nc");
    EXPECT_EQ(escaped_markup("\xef\xbf\xbe\xef\xbf\xbf"), "\ufffd\ufffd");
}

// RFC 3629 §4: invalid UTF-8, byte by byte.
TEST(EscapedMarkup, ReplacesInvalidUtf8) {
    for (const std::string bad :
         {"\x80", "\xff", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
          "\xf0\x80\x80\x80", "\xe2\x82"}) {
        std::string replaced;
        for (std::size_t i = 0; i < bad.size(); ++i) replaced += "\ufffd";
        EXPECT_EQ(escaped_markup("a" + bad), "a" + replaced);
        EXPECT_EQ(script_string("a" + bad), "\"a" + replaced + "\"");
    }
    EXPECT_EQ(escaped_markup("\xf4\x8f\xbf\xbd\xed\x9f\xbf"), "\xf4\x8f\xbf\xbd\xed\x9f\xbf");
}

TEST(ScriptString, CannotCloseTheScriptElement) {
    EXPECT_EQ(script_string("</script><!--"), R"("\u003c/script\u003e\u003c!--")");
    EXPECT_EQ(script_string("\"\\\n"), R"("\"\\\u000a")");
}

// For any bytes, the result contains nothing that ends a string, an attribute or an element.
TEST(Escaping, IsSafeForAnyBytes) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> byte(0, 255), length(0, 30);
    for (int i = 0; i < 20000; ++i) {
        std::string text(static_cast<std::size_t>(length(random)), '\0');
        for (char& c : text) c = static_cast<char>(byte(random));
        EXPECT_EQ(escaped_markup(text).find_first_of("<>\"'"), std::string::npos);
        const std::string script = script_string(text);
        ASSERT_GE(script.size(), 2u);
        EXPECT_EQ(script.find_first_of("<>&\n\r"), std::string::npos);
        // Every quote inside is escaped: an odd number of backslashes precedes it.
        for (std::size_t at = 1; at + 1 < script.size(); ++at) {
            if (script[at] != '"') continue;
            const std::size_t other = script.find_last_not_of('\\', at - 1);
            EXPECT_EQ((at - 1 - other) % 2, 1u) << script;
        }
    }
}

// RFC 4648 §10.
TEST(Base64, AgreesWithTheStandardsExamples) {
    const std::vector<std::pair<std::string, std::string>> vectors = {{"", ""},
                                                                      {"f", "Zg=="},
                                                                      {"fo", "Zm8="},
                                                                      {"foo", "Zm9v"},
                                                                      {"foob", "Zm9vYg=="},
                                                                      {"fooba", "Zm9vYmE="},
                                                                      {"foobar", "Zm9vYmFy"}};
    for (const auto& [plain, coded] : vectors)
        EXPECT_EQ(base64({reinterpret_cast<const std::uint8_t*>(plain.data()), plain.size()}),
                  coded);
    const std::vector<std::uint8_t> high = {0xff, 0xfe, 0xfd};
    EXPECT_EQ(base64(high), "//79");
}

}  // namespace
}  // namespace poinsot
