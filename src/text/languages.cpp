#include "text/languages.h"

#include <algorithm>

namespace poinsot {

std::string_view phrase_in(std::string_view language, const Phrase& phrase) {
    const auto at = std::find(language_codes.begin(), language_codes.end(), language);
    const std::string_view own = phrase.at(static_cast<std::size_t>(at - language_codes.begin()));
    return own.empty() ? phrase.front() : own;
}

}  // namespace poinsot
