#include "text/markup.h"

#include <fmt/format.h>

#include <algorithm>

namespace poinsot {

namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

// Length of the UTF-8 character that the text begins with, or 0 for bytes that are none
// (RFC 3629 §4).
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool surrogate = first == 0xed && byte(1) > 0x9f;
    const bool too_large = first == 0xf4 && byte(1) > 0x8f;
    return overlong || surrogate || too_large ? 0 : length;
}

// Calls put with each character, bad bytes as U+FFFD one by one.
template <typename Put>
void for_each_character(std::string_view text, const Put& put) {
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        put(length == 0 ? kReplacement : text.substr(0, length));
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
}

bool is_control(std::string_view character) {
    const auto c = static_cast<unsigned char>(character.front());
    return character.size() == 1 && (c < 0x20 || c == 0x7f);
}

}  // namespace

std::string escaped_markup(std::string_view text) {
    std::string escaped;
    for_each_character(text, [&](std::string_view c) {
        if (c == "<") {
            escaped += "&lt;";
        } else if (c == ">") {
            escaped += "&gt;";
        } else if (c == "&") {
            escaped += "&amp;";
        } else if (c == "\"") {
            escaped += "&quot;";
        } else if (c == "'") {
            escaped += "&#39;";
        } else if ((is_control(c) && c != "\n" && c != "\t") || c == "\xef\xbf\xbe" ||
                   c == "\xef\xbf\xbf") {
            escaped += kReplacement;  // U+FFFE and U+FFFF are no characters of XML either
        } else {
            escaped += c;
        }
    });
    return escaped;
}

std::string script_string(std::string_view text) {
    std::string quoted = "\"";
    for_each_character(text, [&](std::string_view c) {
        if (c == "\"" || c == "\\") {
            quoted += '\\';
            quoted += c;
        } else if (is_control(c) || c == "<" || c == ">" || c == "&") {
            quoted += fmt::format("\\u{:04x}", static_cast<unsigned char>(c.front()));
        } else {
            quoted += c;
        }
    });
    return quoted + "\"";
}

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8 | (j < n ? bytes[i + j] : std::uint8_t{0});
        for (std::size_t j = 0; j < 4; ++j)
            text += j <= n ? digits[(group >> (18 - 6 * j)) & 63] : '=';
    }
    return text;
}

}  // namespace poinsot
