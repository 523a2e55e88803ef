#include "drawing/stage/type/written_unit.h"

#include <array>
#include <cctype>
#include <utility>

namespace poinsot {

namespace {

// The longest unit that is looked for, in bytes.
constexpr std::size_t longest = 32;

// Markup within a unit, and what it means.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> meanings{{
    {"~", " "},
    {"\\,", " "},
    {"\\;", " "},
    {"\\:", " "},
    {"\\ ", " "},
    {"\\!", ""},
    {"\\mathrm{", ""},
    {"\\textrm{", ""},
    {"\\text{", ""},
    {"^{\\circ}", "\u00b0"},
    {"^\\circ", "\u00b0"},
    {"\\cdot", "\u00b7"},
    {"\\mu ", "\u00b5"},
    {"^{", "^"},
    {"$", ""},
    {"}", ""},
}};

// The text without markup, up to the first other command or the next number.
std::string without_markup(std::string_view text) {
    std::string plain;
    while (!text.empty() && plain.size() < longest + 8) {
        bool known = false;
        for (const auto& [markup, meaning] : meanings) {
            if (!text.starts_with(markup)) continue;
            plain += meaning;
            text.remove_prefix(markup.size());
            known = true;
            break;
        }
        if (known) continue;
        if (text.front() == '\\' || text.front() == '{') break;
        plain += text.front();
        text.remove_prefix(1);
    }
    return plain;
}

// Whether a word or a number goes on here.
bool goes_on_with_word(std::string_view rest) {
    if (rest.empty()) return false;
    const auto byte = static_cast<unsigned char>(rest.front());
    const bool latin_letter = byte >= 0xc3 && byte <= 0xcb;  // in UTF-8
    return latin_letter || (byte < 0x80 && std::isalnum(byte) != 0);
}

// Whether the words after a unit make another one of it.
bool makes_another_unit(std::string_view rest) {
    constexpr std::array<std::string_view, 8> words{" a ",   " an ",  " per ", " each ",
                                                    " pro ", " par ", " por ", " al "};
    for (const std::string_view word : words)
        if (rest.starts_with(word)) return true;
    return false;
}

}  // namespace

std::optional<WrittenUnit> written_unit(std::string_view after_number, const Dimension& of_number) {
    const std::string plain = without_markup(after_number);
    std::string_view text = plain;
    while (text.starts_with(' ')) text.remove_prefix(1);
    std::optional<WrittenUnit> found;
    for (std::size_t n = std::min(text.size(), longest); n > 0; --n) {
        const std::string_view candidate = text.substr(0, n);
        const std::string_view rest = text.substr(n);
        // "in" is a word far more often than an inch.
        if (candidate.back() == ' ' || goes_on_with_word(rest) || candidate == "in") continue;
        const auto unit = unit_named(candidate);
        if (!unit) continue;
        WrittenUnit written{std::string(candidate), *unit, makes_another_unit(rest)};
        if (unit->dimension == of_number) return written;
        if (!found) found = std::move(written);
    }
    return found;
}

}  // namespace poinsot
