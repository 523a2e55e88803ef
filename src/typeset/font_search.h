// Where the fonts of labels and captions are looked for.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

namespace poinsot {

// The folder of fonts that came with the program, then those in which Debian's fonts-lmodern and
// TeX Live put Latin Modern, first choice first.
std::vector<std::filesystem::path> default_font_folders();

// The folders in which systems keep all their fonts.
std::vector<std::filesystem::path> system_font_folders();

struct FontSearch {
    std::vector<std::filesystem::path> folders = default_font_folders();
    // Where a font is looked for that has a character which those above lack.
    std::vector<std::filesystem::path> fallback_folders = system_font_folders();
};

// The font files in and below some folders, those of plain sans-serif faces first, then by path:
// the same order on every machine that has the same fonts.
std::vector<std::filesystem::path> fonts_below(const std::vector<std::filesystem::path>& folders);

// File names of the fonts used: mathematics; the regular, bold and italic faces of captions; the
// same of text within formulas.
const std::array<std::string_view, 7>& font_names();

// The font's path in the first folder that holds it.
// throws: EnvironmentError naming the package to install where none does.
std::filesystem::path find_font(std::string_view name, const FontSearch& search = {});

}  // namespace poinsot
