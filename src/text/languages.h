// The languages that pictures have words of their own in, and such a word in each of them.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace poinsot {

// In this order.
constexpr std::array<std::string_view, 6> language_codes{"en", "de", "fr", "es", "it", "ja"};

// A word, heading or formula of a picture in every language; one that stands alone is the same in
// all of them, as formulas are.
using Phrase = std::array<std::string_view, language_codes.size()>;

constexpr Phrase no_words{};
constexpr Phrase formula(std::string_view text) { return {text}; }

inline std::span<const std::string_view> languages() { return language_codes; }

// Precondition: one of languages().
std::string_view phrase_in(std::string_view language, const Phrase& phrase);

}  // namespace poinsot
