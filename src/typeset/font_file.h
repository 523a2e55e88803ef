// One OpenType font: its glyphs' metrics and outlines, its kerning, and its mathematical constants,
// all in font units, so that nothing here depends on a size.
#pragma once

#include <hb-ot.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "typeset/glyph_outline.h"

namespace poinsot {

using GlyphId = std::uint32_t;

// Font units, y up, from the glyph's origin.
struct GlyphMetrics {
    double advance = 0.0;
    double height = 0.0;             // of the ink's top above the baseline
    double depth = 0.0;              // of the ink's bottom below the baseline
    double left = 0.0, right = 0.0;  // of the ink
    double italic_correction = 0.0;
    double accent_attachment = 0.0;  // x of the middle of what stands above it
};

struct ShapedGlyph {
    GlyphId glyph = 0;
    double x = 0.0, y = 0.0;  // font units from the start of the run
};

struct ShapedRun {
    std::vector<ShapedGlyph> glyphs;
    double advance = 0.0;
};

// A taller form of a glyph, whole or built from pieces one above the other (bottom first). The ink
// reaches from y = 0 up to `extent`.
struct TallGlyph {
    std::vector<ShapedGlyph> pieces;
    double extent = 0.0;
};

// Metrics, shapes and outlines are kept once asked for. Not safe for use by two threads at once.
class FontFile {
 public:
    // throws: EnvironmentError where the file cannot be read as a font.
    explicit FontFile(const std::filesystem::path& file);
    ~FontFile();
    FontFile(FontFile&&) noexcept;
    FontFile& operator=(FontFile&&) noexcept;

    const std::filesystem::path& file() const { return file_; }
    double units_per_em() const { return units_per_em_; }
    bool has_math() const;
    // The glyph of a character, if the font has one.
    std::optional<GlyphId> glyph(char32_t character);
    // The form of a character for scripts: level 1 or 2, by the font's ssty feature (OpenType
    // specification, "Registered features"); level 0 is the plain glyph.
    std::optional<GlyphId> script_glyph(char32_t character, int level);
    const GlyphMetrics& metrics(GlyphId glyph);
    const GlyphOutline& outline(GlyphId glyph);
    // Kerned and ligatured, left to right; every character must have a glyph.
    ShapedRun shape(std::span<const char32_t> characters);

    // A value of the font's MATH table (OpenType specification, "MathConstants").
    double constant(hb_ot_math_constant_t which) const;
    // The smallest vertical variant of at least min_extent, or one assembled from parts, or the
    // tallest there is ("MathVariants").
    TallGlyph tall_glyph(GlyphId glyph, double min_extent);

 private:
    TallGlyph assembled(GlyphId glyph, double min_extent);

    struct Handles;
    std::unique_ptr<Handles> handles_;
    std::filesystem::path file_;
    double units_per_em_ = 1000.0;
    std::array<std::unordered_map<char32_t, std::optional<GlyphId>>, 3> glyphs_;
    std::unordered_map<GlyphId, GlyphMetrics> metrics_;
    std::unordered_map<GlyphId, GlyphOutline> outlines_;
};

}  // namespace poinsot
