#include "typeset/font_set.h"

#include <algorithm>
#include <string_view>

#include "typeset/font_search.h"
#include "typeset/label_cursor.h"

namespace poinsot {

FontFile& FontSet::open(std::size_t index) {
    std::optional<FontFile>& font = fonts_.at(index);
    if (!font) font.emplace(find_font(font_names().at(index), {folders_}));
    return *font;
}

FontFile& FontSet::math() { return open(0); }

FontFile& FontSet::text(TextFamily family, TextFace face) {
    return open((family == TextFamily::caption ? 1u : 4u) + static_cast<std::size_t>(face));
}

TypeBox FontSet::set_text(const TextRun& run, TextFamily family, double size_px) {
    TypeBox box;
    std::vector<char32_t> part;
    FontFile* part_font = nullptr;
    const auto flush = [&] {
        if (part.empty()) return;
        const double scale = size_px / part_font->units_per_em();
        const ShapedRun shaped = part_font->shape(part);
        for (const ShapedGlyph& glyph : shaped.glyphs) {
            const GlyphMetrics& metrics = part_font->metrics(glyph.glyph);
            box.glyphs.push_back(
                {part_font, glyph.glyph, box.width + glyph.x * scale, glyph.y * scale, scale});
            box.height = std::max(box.height, (metrics.height + glyph.y) * scale);
            box.depth = std::max(box.depth, (metrics.depth - glyph.y) * scale);
        }
        box.width += shaped.advance * scale;
        part.clear();
    };
    FontFile& face = text(family, run.face);
    for (const LabelCharacter& character : run.characters) {
        // A space that no line breaks at is as wide as one where it may.
        const char32_t code = character.code == U'\u00A0' ? U' ' : character.code;
        FontFile* font = face.glyph(code) ? &face : &math();
        if (font != &face && !font->glyph(code)) fail_missing_glyph(code, character.column);
        if (font != part_font) flush();
        part_font = font;
        part.push_back(code);
    }
    flush();
    return box;
}

void fail_missing_glyph(char32_t character, int column) {
    throw LabelError(
        column, "no font here has the character " + describe(character) + "; write it otherwise");
}

}  // namespace poinsot
