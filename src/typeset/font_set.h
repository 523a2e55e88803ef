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

class FontSet {
 public:
    explicit FontSet(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

    // throws: EnvironmentError naming the package where a font is not found.
    FontFile& math();
    FontFile& text(TextFace face);

    // A run of text at size_px: the face's own glyphs, kerned, and the math font's for characters
    // that the face lacks.
    // throws: LabelError naming a character that both lack.
    TypeBox set_text(const TextRun& run, double size_px);

 private:
    FontFile& open(std::size_t index);

    std::vector<std::filesystem::path> folders_;
    std::array<std::optional<FontFile>, 4> fonts_;
};

// The error for a character that no font here has.
[[noreturn]] void fail_missing_glyph(char32_t character, int column);

}  // namespace poinsot
