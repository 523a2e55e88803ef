// A part of a font as a table, for a page in a browser: the glyphs of chosen characters with their
// outlines, metrics, kerning, ligatures and tall forms, and the constants for mathematics. A page
// then needs neither FreeType nor HarfBuzz, and sets the same text to the same positions.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "typeset/font_file.h"

namespace poinsot {

// The characters of a font to keep. Characters that the font lacks are left out.
struct KeptCharacters {
    std::span<const char32_t> all;
    std::span<const char32_t> running{};  // of which pairs keep their kerning and ligatures
    std::span<const char32_t> scripts{};  // that keep their forms for sub- and superscripts
    std::span<const char32_t> tall{};     // that keep their tall forms
};

// Writes the table of these characters.
std::string keep_font(FontFile& font, const KeptCharacters& characters);

// A table that keep_font wrote. The members mean what those of FontFile mean.
class KeptFont {
 public:
    // The bytes must outlive it. throws: EnvironmentError if they are no such table.
    explicit KeptFont(std::string_view bytes);

    double units_per_em() const { return units_per_em_; }
    bool has_math() const { return has_math_; }
    std::optional<GlyphId> script_glyph(char32_t character, int level) const;
    GlyphMetrics metrics(GlyphId glyph) const;
    GlyphOutline outline(GlyphId glyph) const;
    ShapedRun shape(std::span<const char32_t> characters) const;
    double constant(std::size_t which) const { return constants_.at(which); }
    TallForms tall_forms(GlyphId glyph) const;

    static constexpr std::size_t n_constants = 56;  // of OpenType's MathConstants

 private:
    struct Glyph {
        GlyphMetrics metrics;
        std::string_view outline;
    };

    double units_per_em_ = 1000.0;
    bool has_math_ = false;
    std::array<double, n_constants> constants_{};
    std::unordered_map<char32_t, std::array<GlyphId, 3>> characters_;
    std::unordered_map<GlyphId, Glyph> glyphs_;
    std::unordered_map<GlyphId, TallForms> tall_forms_;
    // Of two glyphs that are set beside each other: the one that replaces both, or their kerning by
    // classes of left and right glyphs.
    std::map<std::pair<GlyphId, GlyphId>, GlyphId> ligatures_;
    std::unordered_map<GlyphId, std::pair<std::size_t, std::size_t>> classes_;
    std::vector<double> kerning_;
    std::size_t n_right_ = 0;
};

}  // namespace poinsot
