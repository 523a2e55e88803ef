// The words that pictures have of their own, in every language: one table.
#pragma once

#include <span>
#include <string_view>

namespace poinsot {

// "en", "de", "fr", "es", "it", "ja".
std::span<const std::string_view> languages();

// An English word or heading of a picture in another language; the same text where the table has
// no such row: what the scene says itself is not ours to translate.
// Precondition: one of languages().
std::string_view translated(std::string_view english, std::string_view language);

// Whether the table has a row for it, whole in every language.
bool has_translations(std::string_view english);

}  // namespace poinsot
