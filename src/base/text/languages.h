// The languages of the words in pictures, and a word in each of them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// The order of the words in a Phrase.
constexpr std::array<std::string_view, 6> language_codes{"en", "de", "fr", "es", "it", "ja"};

// A word, heading or formula of a picture in every language; an expression that is the same in all
// languages, such as a formula, is given once.
using Phrase = std::array<std::string_view, language_codes.size()>;

constexpr Phrase no_words{};
constexpr Phrase formula(std::string_view text) { return {text}; }

inline std::span<const std::string_view> languages() { return language_codes; }

// Its code in ISO 639-2, as films have it: "deu". Precondition as below.
std::string_view three_letters_of(std::string_view language);

// The word in this language. Precondition: `language` is in languages().
std::string_view phrase_in(std::string_view language, const Phrase& phrase);

// The decimal mark of numbers in this language: "," or ".".
std::string_view decimal_mark_of(std::string_view language);

// The same in a $formula$, where a comma outside of braces would have a space after it.
std::string_view decimal_mark_in_formula(std::string_view language);

// Digits with this decimal mark in place of their point.
std::string with_decimal_mark(std::string digits, std::string_view mark);

}  // namespace poinsot
