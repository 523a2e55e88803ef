#include "text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "text/utf8.h"

namespace poinsot {

namespace {

std::string escape_of(char32_t code) {
    const auto number = static_cast<std::uint32_t>(code);
    return number < 0x10000 ? fmt::format("\\u{:04x}", number) : fmt::format("\\U{:08x}", number);
}

// JSON writes characters beyond 16 bits as a surrogate pair.
std::string json_escape_of(char32_t code) {
    const auto number = static_cast<std::uint32_t>(code);
    if (number < 0x10000) return fmt::format("\\u{:04x}", number);
    return fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + ((number - 0x10000) >> 10),
                       0xdc00 + ((number - 0x10000) & 0x3ff));
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
    struct Piece {
        std::string shown;
        std::size_t width;
    };
    std::vector<Piece> pieces;
    std::size_t width = 0;
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        Piece piece{std::string(text.substr(0, character.size)), 1};
        if (!character.valid || is_hidden(character.code)) {
            piece.shown = character.valid
                              ? escape_of(character.code)
                              : fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
            piece.width = piece.shown.size();
        }
        width += piece.width;
        pieces.push_back(std::move(piece));
        text.remove_prefix(character.size);
    }

    // Cut where the end of the text stays whole: it usually says what to do.
    std::size_t first_cut = pieces.size(), end_of_cut = pieces.size();
    if (width > most) {
        const std::size_t most_of_tail = most / 3;
        std::size_t kept = 0;
        for (first_cut = 0; kept + pieces[first_cut].width + most_of_tail < most; ++first_cut)
            kept += pieces[first_cut].width;
        for (kept = 0; kept + pieces[end_of_cut - 1].width <= most_of_tail; --end_of_cut)
            kept += pieces[end_of_cut - 1].width;
    }
    std::string safe;
    for (std::size_t i = 0; i < first_cut; ++i) safe += pieces[i].shown;
    if (width > most) safe += "…";
    for (std::size_t i = end_of_cut; i < pieces.size(); ++i) safe += pieces[i].shown;
    return safe;
}

std::string listed(std::span<const char32_t> characters) {
    constexpr std::size_t most = 8;
    std::string list;
    for (const char32_t c : characters.first(std::min(most, characters.size()))) {
        const std::string code = fmt::format("U+{:04X}", static_cast<std::uint32_t>(c));
        if (!list.empty()) list += ", ";
        list += is_hidden(c) ? code : fmt::format("{} ({})", utf8_of(c), code);
    }
    return characters.size() > most ? list + ", …" : list;
}

std::string json_string(std::string_view text) {
    std::string quoted = "\"";
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        if (!character.valid) {
            quoted += "\ufffd";
        } else if (character.code == '"' || character.code == '\\') {
            quoted += '\\';
            quoted += text[0];
        } else if (is_hidden(character.code)) {
            quoted += json_escape_of(character.code);
        } else {
            quoted += text.substr(0, character.size);
        }
        text.remove_prefix(character.size);
    }
    return quoted + "\"";
}

}  // namespace poinsot
