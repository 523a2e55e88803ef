// The languages of the words in pictures, and a word in each of them.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// The order of the words in a Phrase.
constexpr std::array<std::string_view, 6> language_codes{"en", "de", "fr", "es", "it", "ja"};

// A word, heading or formula of a picture in every language: one that lacks a language does not
// compile. An expression that is the same in all languages, such as a formula, is given once.
class Phrase {
 public:
    constexpr Phrase() = default;
    template <typename... Texts>
    requires(sizeof...(Texts) == language_codes.size())
        // NOLINTNEXTLINE(google-explicit-constructor): a row of a table holds the words in braces
        constexpr Phrase(const Texts&... texts)
        : texts_{texts...} {}

    friend constexpr Phrase formula(std::string_view text);

    constexpr std::string_view operator[](std::size_t language) const { return texts_[language]; }
    static constexpr std::size_t size() { return language_codes.size(); }

 private:
    std::array<std::string_view, language_codes.size()> texts_{};
};

constexpr Phrase no_words{};
constexpr Phrase formula(std::string_view text) {
    Phrase phrase;
    phrase.texts_[0] = text;
    return phrase;
}

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
