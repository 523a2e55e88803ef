// Finds the fonts of labels and captions.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace poinsot {

// The folder of fonts installed with the program, then the folders of Latin Modern in Debian's
// fonts-lmodern and in TeX Live, in order of preference.
std::vector<std::filesystem::path> default_font_folders();

// The folders in which operating systems keep their fonts.
std::vector<std::filesystem::path> system_font_folders();

struct FontSearch {
    std::vector<std::filesystem::path> folders = default_font_folders();
    // searched for a fallback font, for characters that the fonts above lack.
    std::vector<std::filesystem::path> fallback_folders = system_font_folders();
};

// The font files in and below these folders: plain sans-serif faces first, then by path. The order
// is the same on every machine with the same fonts.
std::vector<std::filesystem::path> fonts_below(const std::vector<std::filesystem::path>& folders);

// Returns the font's path in the first folder that has it. throws: EnvironmentError that names the
// package to install if no folder has it.
std::filesystem::path find_font(std::string_view name, const FontSearch& search = {});

}  // namespace poinsot
