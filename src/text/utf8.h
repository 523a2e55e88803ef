// Characters of UTF-8 text, as far as a scene's reader needs them.
#pragma once

#include <string_view>

namespace poinsot {

struct Utf8Character {
    char32_t code = 0;
    std::size_t size = 1;  // bytes; 1 where the byte is not UTF-8
    bool valid = false;
};

// The first character of a text that is not empty.
Utf8Character first_character(std::string_view text);

// True for C0 and C1 control characters, DEL, and the two separators that end a line elsewhere.
constexpr bool is_control(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

}  // namespace poinsot
