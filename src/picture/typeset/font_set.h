// The fonts of labels and captions, opened on first use.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "typeset/font_source.h"
#include "typeset/label_tree.h"
#include "typeset/type_box.h"

namespace poinsot {

// Captions use Latin Modern Sans: its even strokes stay legible at 16…20 px, especially dark on
// light, where the thin strokes of the roman face fade. Text inside a formula uses Latin Modern
// Roman, which matches the math font, so that a label has one style of digits and units.
enum class TextFamily { caption, formula };

class FontSet {
 public:
    explicit FontSet(FontSource source) : source_(std::move(source)) {}

    // throws: EnvironmentError that names the package if a font is not found.
    FontFile& math();
    FontFile& text(TextFamily family, TextFace face);

    // Typesets a run of text at size_px (px per em) with the face's own glyphs and kerning.
    // Characters that the face lacks come from the math font, or from the first system font that
    // has them. A character that no font has is drawn as a box and recorded in missing().
    TypeBox set_text(const TextRun& run, TextFamily family, double size_px);

    // The system fonts that have been used, in the order of their first use, and the characters
    // that no font has.
    const std::vector<std::filesystem::path>& fallbacks_used() const { return fallbacks_used_; }
    const std::vector<char32_t>& missing() const { return missing_; }

 private:
    FontFile& open(std::size_t index);
    FontFile* fallback(char32_t character);

    FontSource source_;
    std::array<std::optional<FontFile>, 7> fonts_;
    std::optional<std::vector<std::filesystem::path>> fallback_files_;  // empty until searched
    std::map<std::size_t, std::unique_ptr<FontFile>> fallbacks_;  // by index in fallback_files_;
                                                                  // null: not a font
    std::map<char32_t, FontFile*> fallback_of_;                   // null: no font has it
    std::vector<std::filesystem::path> fallbacks_used_;
    std::vector<char32_t> missing_;
};

// Throws the error for a character that no font has.
[[noreturn]] void fail_missing_glyph(char32_t character, int column);

}  // namespace poinsot
