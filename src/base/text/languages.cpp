#include "text/languages.h"

#include <algorithm>

namespace poinsot {

std::string_view phrase_in(std::string_view language, const Phrase& phrase) {
    const auto at = std::find(language_codes.begin(), language_codes.end(), language);
    const std::string_view own = phrase[static_cast<std::size_t>(at - language_codes.begin())];
    return own.empty() ? phrase[0] : own;
}

std::string_view three_letters_of(std::string_view language) {
    return phrase_in(language, {"eng", "deu", "fra", "spa", "ita", "jpn"});
}

std::string_view decimal_mark_of(std::string_view language) {
    constexpr std::array<std::string_view, 4> with_comma{"de", "fr", "es", "it"};
    const bool comma =
        std::find(with_comma.begin(), with_comma.end(), language) != with_comma.end();
    return comma ? "," : ".";
}

std::string_view decimal_mark_in_formula(std::string_view language) {
    const std::string_view mark = decimal_mark_of(language);
    return mark == "," ? "{,}" : mark;
}

std::string with_decimal_mark(std::string digits, std::string_view mark) {
    const std::size_t point = digits.find('.');
    if (point != std::string::npos) digits.replace(point, 1, mark);
    return digits;
}

}  // namespace poinsot
