// The fonts that labels and captions are set in, opened when first asked for.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "typeset/font_file.h"
#include "typeset/font_search.h"
#include "typeset/label_tree.h"
#include "typeset/type_box.h"

namespace poinsot {

// Captions are set in Latin Modern Sans: at 16…20 px its even strokes stay legible, dark on light
// most of all, where the hairlines of the roman face fade. Text within a formula is set in Latin
// Modern Roman, the companion of the math font, so that a label has one kind of digits and units.
enum class TextFamily { caption, formula };

class FontSet {
 public:
    explicit FontSet(FontSearch search) : search_(std::move(search)) {}

    // throws: EnvironmentError naming the package where a font is not found.
    FontFile& math();
    FontFile& text(TextFamily family, TextFace face);

    // A run of text at size_px (px per em): the face's own glyphs, kerned, and for characters that
    // it lacks those of the math font, or of the first font of the system that has them. What no
    // font has is a box, and is remembered.
    TypeBox set_text(const TextRun& run, TextFamily family, double size_px);

    // The fonts of the system that have been used, in the order of their first use, and the
    // characters that no font has.
    const std::vector<std::filesystem::path>& fallbacks_used() const { return fallbacks_used_; }
    const std::vector<char32_t>& missing() const { return missing_; }

 private:
    FontFile& open(std::size_t index);
    FontFile* fallback(char32_t character);

    FontSearch search_;
    std::array<std::optional<FontFile>, 7> fonts_;
    std::optional<std::vector<std::filesystem::path>> fallback_files_;  // once looked for
    std::map<std::size_t, std::unique_ptr<FontFile>> fallbacks_;  // of those; null: not a font
    std::map<char32_t, FontFile*> fallback_of_;                   // null: no font has it
    std::vector<std::filesystem::path> fallbacks_used_;
    std::vector<char32_t> missing_;
};

// The error for a character that no font here has.
[[noreturn]] void fail_missing_glyph(char32_t character, int column);

}  // namespace poinsot
