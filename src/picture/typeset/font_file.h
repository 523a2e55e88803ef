// One OpenType font: metrics and outlines of its glyphs, kerning and mathematical constants. All
// values are in font units, so that they do not depend on a size.
#pragma once

#include <hb-ot.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "typeset/glyph_outline.h"

namespace poinsot {

using GlyphId = std::uint32_t;

// In font units, y up, relative to the glyph's origin.
struct GlyphMetrics {
    double advance = 0.0;
    double height = 0.0;             // top of the ink above the baseline
    double depth = 0.0;              // bottom of the ink below the baseline
    double left = 0.0, right = 0.0;  // extent of the ink
    double italic_correction = 0.0;
    double accent_attachment = 0.0;  // x of the middle of an accent above it
};

struct ShapedGlyph {
    GlyphId glyph = 0;
    double x = 0.0, y = 0.0;    // font units from the start of the run
    std::size_t character = 0;  // its (first) character in the run
};

struct ShapedRun {
    std::vector<ShapedGlyph> glyphs;
    double advance = 0.0;
};

// A taller form of a glyph, either one glyph or assembled from pieces (bottom first). The ink
// extends from y = 0 to `extent`.
struct TallGlyph {
    std::vector<ShapedGlyph> pieces;
    double extent = 0.0;
};

// A piece from which taller forms of a glyph are assembled, bottom first; its connectors may
// overlap those of its neighbours.
struct GlyphPiece {
    GlyphId glyph = 0;
    double advance = 0.0, start_connector = 0.0, end_connector = 0.0;
    bool repeats = false;
};

// The taller forms that a font has of a glyph: whole glyphs, by size, and pieces.
struct TallForms {
    std::vector<GlyphId> variants;
    std::vector<GlyphPiece> pieces;
    double least_overlap = 0.0;
};

struct FreeBlob {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
};
using FontBlob = std::unique_ptr<hb_blob_t, FreeBlob>;

// Caches metrics, shapes and outlines. Not safe for use by two threads at once.
class FontFile {
 public:
    // A font in memory, which must outlive it; `file` is its name. throws: EnvironmentError if it
    // cannot be read as a font.
    FontFile(std::string_view bytes, const std::filesystem::path& file);
    // The same for a file that HarfBuzz holds; null: it could not be read.
    FontFile(FontBlob blob, const std::filesystem::path& file);
    ~FontFile();
    FontFile(FontFile&&) noexcept;
    FontFile& operator=(FontFile&&) noexcept;

    const std::filesystem::path& file() const { return file_; }
    double units_per_em() const { return units_per_em_; }
    bool has_math() const;
    // The glyph of a character; empty if the font has none.
    std::optional<GlyphId> glyph(char32_t character);
    // The variant of a character for sub- and superscripts: level 1 or 2, by the font's ssty
    // feature (OpenType specification, "Registered features"); level 0 is the normal glyph.
    std::optional<GlyphId> script_glyph(char32_t character, int level);
    const GlyphMetrics& metrics(GlyphId glyph);
    const GlyphOutline& outline(GlyphId glyph);
    // Shapes characters with kerning and ligatures, left to right. Precondition: every character
    // has a glyph.
    ShapedRun shape(std::span<const char32_t> characters);

    // A constant of the font's MATH table (OpenType specification, "MathConstants").
    double constant(hb_ot_math_constant_t which) const;
    // The forms that the font has for tall_glyph.
    TallForms tall_forms(GlyphId glyph) const;
    // The smallest vertical variant of at least min_extent, else a glyph assembled from parts, else
    // the tallest variant ("MathVariants").
    TallGlyph tall_glyph(GlyphId glyph, double min_extent);

 private:
    TallGlyph assembled(const TallForms& forms, double min_extent);

    struct Handles;
    std::unique_ptr<Handles> handles_;
    std::filesystem::path file_;
    double units_per_em_ = 1000.0;
    std::array<std::unordered_map<char32_t, std::optional<GlyphId>>, 3> glyphs_;
    std::unordered_map<GlyphId, GlyphMetrics> metrics_;
    std::unordered_map<GlyphId, GlyphOutline> outlines_;
};

}  // namespace poinsot
