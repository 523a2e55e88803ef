// The source of the fonts of labels and captions. Programs on a computer use installed_fonts()
// (typeset/files/); a program without files gives the bytes of its fonts.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "typeset/font_file.h"

namespace poinsot {

// File names of the fonts: mathematics; regular, bold and italic face of captions; the same three
// faces for text inside formulas.
const std::array<std::string_view, 7>& font_names();

// throws: the EnvironmentError of a font that is not there.
[[noreturn]] FontFile no_font(std::string_view name);

// By default there are no fonts.
struct FontSource {
    // Opens one of font_names(). throws: EnvironmentError if there is none, with the remedy.
    std::function<FontFile(std::string_view name)> open = no_font;

    // The fonts for characters that those lack, in order of preference.
    std::function<std::vector<std::filesystem::path>()> fallbacks = [] {
        return std::vector<std::filesystem::path>();
    };
    // Opens one of the fallbacks. throws: EnvironmentError if it is not a font.
    std::function<FontFile(const std::filesystem::path& file)> open_fallback =
        [](const std::filesystem::path& file) { return no_font(file.string()); };
};

// A font file in memory.
struct FontBytes {
    std::string_view name;  // of font_names()
    std::string_view bytes;
};

// The bytes must outlive everything that is set in these fonts.
FontSource fonts_in_memory(std::span<const FontBytes> fonts);

}  // namespace poinsot
