#include "text/utf8.h"

#include <algorithm>
#include <array>

namespace poinsot {

namespace {

unsigned byte_at(std::string_view text, std::size_t index) {
    return static_cast<unsigned char>(text[index]);
}

}  // namespace

Utf8Character first_character(std::string_view text) {
    const unsigned lead = byte_at(text, 0);
    if (lead < 0x80) return {lead, 1, true};

    // The lead byte gives the length and the smallest code of that length.
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return {};
    char32_t code = lead & (0xffu >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        const unsigned next = byte_at(text, i);
        if ((next & 0xc0u) != 0x80u) return {};
        code = (code << 6) | (next & 0x3fu);
    }
    constexpr char32_t least[] = {0x0, 0x0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < least[size] || code > 0x10ffff || surrogate) return {};
    return {code, size, true};
}

std::string utf8_of(char32_t code) {
    std::string text;
    const auto put = [&text](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0 | (code >> 6)), put(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        put(0xe0 | (code >> 12)), put(0x80 | ((code >> 6) & 0x3f)), put(0x80 | (code & 0x3f));
    } else {
        put(0xf0 | (code >> 18)), put(0x80 | ((code >> 12) & 0x3f));
        put(0x80 | ((code >> 6) & 0x3f)), put(0x80 | (code & 0x3f));
    }
    return text;
}

bool is_hidden(char32_t code) {
    if (is_control(code) || is_noncharacter(code)) return true;
    // Unicode's Default_Ignorable_Code_Point (DerivedCoreProperties), and the characters of
    // category Cf among annotations.
    struct Range {
        char32_t first, last;
    };
    constexpr std::array<Range, 17> hidden{{{0xad, 0xad},
                                            {0x34f, 0x34f},
                                            {0x61c, 0x61c},
                                            {0x115f, 0x1160},
                                            {0x17b4, 0x17b5},
                                            {0x180b, 0x180f},
                                            {0x200b, 0x200f},
                                            {0x202a, 0x202e},
                                            {0x2060, 0x206f},
                                            {0x3164, 0x3164},
                                            {0xfe00, 0xfe0f},
                                            {0xfeff, 0xfeff},
                                            {0xffa0, 0xffa0},
                                            {0xfff0, 0xfffb},
                                            {0x1bca0, 0x1bca3},
                                            {0x1d173, 0x1d17a},
                                            {0xe0000, 0xe0fff}}};
    return std::any_of(hidden.begin(), hidden.end(), [code](const Range& range) {
        return range.first <= code && code <= range.last;
    });
}

}  // namespace poinsot
