// Chooses or assembles the taller form of a glyph.
#include <algorithm>

#include "typeset/font_file.h"

namespace poinsot {

TallGlyph FontFile::tall_glyph(GlyphId glyph, double min_extent) {
    const auto whole = [this](GlyphId variant) {
        const GlyphMetrics& ink = metrics(variant);
        return TallGlyph{{{variant, 0.0, ink.depth}}, ink.height + ink.depth};
    };
    const TallForms forms = tall_forms(glyph);
    TallGlyph tallest = whole(glyph);
    for (std::size_t i = 0; i < forms.variants.size() && tallest.extent < min_extent; ++i)
        tallest = whole(forms.variants[i]);
    if (tallest.extent >= min_extent) return tallest;
    TallGlyph built = assembled(forms, min_extent);
    return built.extent > tallest.extent ? built : tallest;
}

// Repeats the extender pieces as often as needed. Joints overlap by the font's minimum or more, so
// that the extent is exactly min_extent if possible.
TallGlyph FontFile::assembled(const TallForms& forms, double min_extent) {
    if (forms.pieces.empty()) return {};
    const double least = forms.least_overlap;
    constexpr int most_repeats = 1000;
    for (int repeats = 0; repeats <= most_repeats; ++repeats) {
        std::vector<const GlyphPiece*> row;
        for (const GlyphPiece& piece : forms.pieces)
            for (int k = 0; k < (piece.repeats ? repeats : 1); ++k) row.push_back(&piece);
        if (row.empty()) continue;
        double longest = 0.0, most_overlap = 0.0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            longest += row[i]->advance;
            if (i == 0) continue;
            longest -= least;
            most_overlap += std::min(row[i - 1]->end_connector, row[i]->start_connector) - least;
        }
        if (longest < min_extent && repeats < most_repeats) continue;
        const double excess = std::clamp(longest - min_extent, 0.0, std::max(0.0, most_overlap));
        TallGlyph built;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) {
                const double room =
                    std::min(row[i - 1]->end_connector, row[i]->start_connector) - least;
                built.extent -= least + (most_overlap > 0.0 ? excess * room / most_overlap : 0.0);
            }
            const double depth = metrics(row[i]->glyph).depth;
            built.pieces.push_back({row[i]->glyph, 0.0, built.extent + depth});
            built.extent += row[i]->advance;
        }
        return built;
    }
    return {};
}

}  // namespace poinsot
