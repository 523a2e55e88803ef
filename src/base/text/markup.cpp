#include "text/markup.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/printable.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

constexpr std::string_view replacement_character = "\xef\xbf\xbd";  // U+FFFD

}  // namespace

std::string escaped_markup(std::string_view text) {
    std::string escaped;
    while (!text.empty()) {
        const Utf8Character c = first_character(text);
        if (c.code == '<') {
            escaped += "&lt;";
        } else if (c.code == '>') {
            escaped += "&gt;";
        } else if (c.code == '&') {
            escaped += "&amp;";
        } else if (c.code == '"') {
            escaped += "&quot;";
        } else if (c.code == '\'') {
            escaped += "&#39;";
        } else if (!c.valid || (is_hidden(c.code) && c.code != '\n' && c.code != '\t')) {
            escaped += replacement_character;
        } else {
            escaped += text.substr(0, c.size);
        }
        text.remove_prefix(c.size);
    }
    return escaped;
}

std::string escaped_cue(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else
            escaped += c;
    }
    return escaped;
}

std::string script_string(std::string_view text) {
    std::string quoted;
    for (const char c : json_string(text)) {
        if (c == '<' || c == '>' || c == '&')
            quoted += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        else
            quoted += c;
    }
    return quoted;
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
