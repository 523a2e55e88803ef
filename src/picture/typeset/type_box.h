// The output of typesetting: placed glyphs and rules, and their box.
#pragma once

#include <cstddef>
#include <vector>

#include "typeset/font_file.h"

namespace poinsot {

struct PlacedGlyph {
    FontFile* font = nullptr;
    GlyphId glyph = 0;
    double x = 0.0, y = 0.0;  // px from the box's origin on the baseline, y up
    double px_per_unit = 0.0;
    int tint = 0;  // of a term (CaptionTerm); 0: none
};

// A filled rectangle. The glyphs from first_glyph up to last_glyph are attached to it (a root's
// sign to its bar) and move with it when it is aligned to whole pixels.
struct PlacedRule {
    double x = 0.0, y = 0.0;  // px, lower left corner, y up
    double width = 0.0, thickness = 0.0;
    std::size_t first_glyph = 0, last_glyph = 0;
};

// In px; height and depth are above and below the baseline.
struct TypeBox {
    double width = 0.0, height = 0.0, depth = 0.0;
    std::vector<PlacedGlyph> glyphs;
    std::vector<PlacedRule> rules;

    // Adds the contents of another box with its origin at (x, y), and enlarges height and depth to
    // contain them; the width does not change.
    void place(const TypeBox& other, double x, double y);
};

}  // namespace poinsot
