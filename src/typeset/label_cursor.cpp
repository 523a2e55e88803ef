#include "typeset/label_cursor.h"

#include <fmt/format.h>

namespace poinsot {
namespace {

constexpr char32_t kInvalid = 0xFFFFFFFF;

bool is_command_letter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

// Characters that move a terminal's cursor or turn its writing direction are named, never shown.
bool is_harmless(char32_t c) {
    const bool control = c < 0x20 || (c >= 0x7F && c < 0xA1) || c == 0xAD;
    const bool format = (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) ||
                        (c >= 0x2060 && c <= 0x206F) || (c >= 0xE000 && c < 0xF900) ||
                        (c >= 0xFE00 && c < 0x10000) || c >= 0xE0000;
    return !control && !format;
}

void append_utf8(std::string& text, char32_t c) {
    const auto put = [&text](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xC0 | (c >> 6)), put(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        put(0xE0 | (c >> 12)), put(0x80 | ((c >> 6) & 0x3F)), put(0x80 | (c & 0x3F));
    } else {
        put(0xF0 | (c >> 18)), put(0x80 | ((c >> 12) & 0x3F));
        put(0x80 | ((c >> 6) & 0x3F)), put(0x80 | (c & 0x3F));
    }
}

// The character at `index`, which moves past it; kInvalid where the bytes are not UTF-8 (Unicode
// Standard, table 3-7).
char32_t decode(std::string_view bytes, std::size_t& index) {
    const auto byte = [&](std::size_t i) {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u;
    };
    const unsigned lead = byte(index);
    const std::size_t n = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (n == 0 || lead > 0xF4) return kInvalid;
    char32_t code = n == 1 ? lead : lead & (0xFFu >> (n + 1));
    for (std::size_t k = 1; k < n; ++k) {
        const unsigned next = byte(index + k);
        if ((next & 0xC0u) != 0x80u) return kInvalid;
        code = (code << 6) | (next & 0x3Fu);
    }
    const bool overlong = (n == 3 && code < 0x800) || (n == 4 && code < 0x10000);
    if (overlong || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return kInvalid;
    index += n;
    return code;
}

}  // namespace

std::string describe(char32_t character) {
    if (character > 0x20 && character < 0x7F) return {static_cast<char>(character)};
    std::string shown;
    if (is_harmless(character)) {
        append_utf8(shown, character);
        shown += ' ';
    }
    return shown + fmt::format("(U+{:04X})", static_cast<unsigned>(character));
}

LabelCursor::LabelCursor(std::string_view utf8) {
    characters_.reserve(utf8.size() < kLabelLengthLimit ? utf8.size() : kLabelLengthLimit);
    for (std::size_t index = 0; index < utf8.size();) {
        const int column = static_cast<int>(characters_.size()) + 1;
        if (column > kLabelLengthLimit) {
            throw LabelError(column, fmt::format("a label holds at most {} characters; shorten it",
                                                 kLabelLengthLimit));
        }
        const char32_t c = decode(utf8, index);
        if (c == kInvalid) throw LabelError(column, "not valid UTF-8; save the text as UTF-8");
        if ((c < 0x20 && c != U'\n' && c != U'\t') || (c >= 0x7F && c < 0xA0)) {
            throw LabelError(column, fmt::format("control character {}; remove it", describe(c)));
        }
        characters_.push_back(c);
    }
}

LabelCharacter LabelCursor::take() {
    const LabelCharacter taken{peek(), column()};
    if (!at_end()) ++position_;
    return taken;
}

void LabelCursor::skip_spaces() {
    while (peek() == U' ' || peek() == U'\n' || peek() == U'\t') take();
}

std::string LabelCursor::take_command_name() {
    if (at_end()) fail_expected("a command's name after the backslash");
    if (!is_command_letter(peek())) {
        std::string name;
        append_utf8(name, take().code);
        return name;
    }
    std::string name;
    while (is_command_letter(peek())) name.push_back(static_cast<char>(take().code));
    return name;
}

void LabelCursor::fail_expected(const std::string& what) const {
    throw LabelError(column(), fmt::format("expected {}, found {}", what,
                                           at_end() ? "the end" : describe(peek())));
}

LabelCursor::Nesting::Nesting(LabelCursor& cursor) : cursor_(cursor) {
    if (cursor_.depth_ == kLabelNestingLimit) {
        throw LabelError(
            cursor_.column(),
            fmt::format("nested more than {} deep; simplify the label", kLabelNestingLimit));
    }
    ++cursor_.depth_;
}

}  // namespace poinsot
