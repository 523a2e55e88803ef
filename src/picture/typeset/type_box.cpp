#include "typeset/type_box.h"

#include <algorithm>

namespace poinsot {

void TypeBox::place(const TypeBox& other, double x, double y) {
    const std::size_t offset = glyphs.size();
    for (PlacedGlyph glyph : other.glyphs) {
        glyph.x += x;
        glyph.y += y;
        glyphs.push_back(glyph);
    }
    for (PlacedRule rule : other.rules) {
        rule.x += x;
        rule.y += y;
        rule.first_glyph += offset;
        rule.last_glyph += offset;
        rules.push_back(rule);
    }
    height = std::max(height, other.height + y);
    depth = std::max(depth, other.depth - y);
}

}  // namespace poinsot
