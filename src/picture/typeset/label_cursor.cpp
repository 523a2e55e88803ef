#include "typeset/label_cursor.h"

#include <fmt/format.h>

#include "text/utf8.h"

namespace poinsot {
namespace {

bool is_command_letter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

}  // namespace

std::string describe(char32_t character) {
    if (character > 0x20 && character < 0x7F) return {static_cast<char>(character)};
    std::string shown;
    // Hidden characters and spaces are shown only by code point.
    if (!is_hidden(character) && character != 0x20 && character != 0xa0)
        shown = utf8_of(character) + ' ';
    return shown + fmt::format("(U+{:04X})", static_cast<unsigned>(character));
}

LabelCursor::LabelCursor(std::string_view utf8) {
    characters_.reserve(utf8.size() < label_length_limit ? utf8.size() : label_length_limit);
    for (std::size_t index = 0; index < utf8.size();) {
        const int column = static_cast<int>(characters_.size()) + 1;
        if (column > label_length_limit) {
            throw LabelError(column, fmt::format("a label holds at most {} characters; shorten it",
                                                 label_length_limit));
        }
        const Utf8Character character = first_character(utf8.substr(index));
        if (!character.valid) {
            throw LabelError(column, "not valid UTF-8; save the text as UTF-8");
        }
        index += character.size;
        const char32_t c = character.code;
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
        return utf8_of(take().code);
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
    if (cursor_.depth_ == label_nesting_limit) {
        throw LabelError(
            cursor_.column(),
            fmt::format("nested more than {} deep; simplify the label", label_nesting_limit));
    }
    ++cursor_.depth_;
}

}  // namespace poinsot
