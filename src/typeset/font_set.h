// The fonts that labels and captions are set in, opened when first asked for.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "typeset/font_file.h"
#include "typeset/label_tree.h"
#include "typeset/type_box.h"

namespace poinsot {

// Captions are set in Latin Modern Sans: at 16…20 px its even strokes stay legible, dark on light
// most of all, where the hairlines of the roman face fade. Text within a formula is set in Latin
// Modern Roman, the companion of the math font, so that a label has one kind of digits and units.
enum class TextFamily { caption, formula };

class FontSet {
 public:
    explicit FontSet(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

    // throws: EnvironmentError naming the package where a font is not found.
    FontFile& math();
    FontFile& text(TextFamily family, TextFace face);

    // A run of text at size_px (px per em): the face's own glyphs, kerned, and the math font's for
    // characters that the face lacks. throws: LabelError naming a character that both lack.
    TypeBox set_text(const TextRun& run, TextFamily family, double size_px);

 private:
    FontFile& open(std::size_t index);

    std::vector<std::filesystem::path> folders_;
    std::array<std::optional<FontFile>, 7> fonts_;
};

// The error for a character that no font here has.
[[noreturn]] void fail_missing_glyph(char32_t character, int column);

}  // namespace poinsot
