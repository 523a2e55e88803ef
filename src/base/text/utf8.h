// Characters of UTF-8 text, and which characters are invisible to a reader.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

struct Utf8Character {
    char32_t code = 0;
    std::size_t size = 1;  // bytes; 1 for a byte that is not valid UTF-8
    bool valid = false;
};

// The first character of a text (RFC 3629 §4). Precondition: the text is not empty.
Utf8Character first_character(std::string_view text);

// Encodes a character as UTF-8. Precondition: a Unicode scalar value.
std::string utf8_of(char32_t code);

// True for C0 and C1 control characters, DEL, and the Unicode line and paragraph separators.
constexpr bool is_control(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

// True for the 66 codes that Unicode keeps from being characters (Unicode Standard §23.7).
constexpr bool is_noncharacter(char32_t code) {
    return (code & 0xfffe) == 0xfffe || (code >= 0xfdd0 && code <= 0xfdef);
}

// True for control characters, and for those that are invisible or change how others appear:
// writing directions, zero-width and blank characters, tags and noncharacters.
bool is_hidden(char32_t code);

}  // namespace poinsot
