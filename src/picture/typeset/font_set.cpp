#include "typeset/font_set.h"

#include <algorithm>
#include <string_view>

#include "error/error.h"
#include "typeset/label_cursor.h"

namespace poinsot {

FontFile& FontSet::open(std::size_t index) {
    std::optional<FontFile>& font = fonts_.at(index);
    if (!font) font.emplace(source_.open(font_names().at(index)));
    return *font;
}

FontFile& FontSet::math() { return open(0); }

FontFile& FontSet::text(TextFamily family, TextFace face) {
    return open((family == TextFamily::caption ? 1u : 4u) + static_cast<std::size_t>(face));
}

FontFile* FontSet::fallback(char32_t character) {
    if (const auto known = fallback_of_.find(character); known != fallback_of_.end())
        return known->second;
    if (!fallback_files_) fallback_files_ = source_.fallbacks();
    for (std::size_t i = 0; i < fallback_files_->size(); ++i) {
        const std::filesystem::path& file = (*fallback_files_)[i];
        try {
            auto& font = fallbacks_[i];
            if (!font) font = std::make_unique<FontFile>(source_.open_fallback(file));
            const std::optional<GlyphId> glyph = font->glyph(character);
            // Bitmap and colour fonts have glyphs without outlines.
            if (!glyph || font->outline(*glyph).steps.empty()) continue;
            if (std::ranges::find(fallbacks_used_, file) == fallbacks_used_.end())
                fallbacks_used_.push_back(file);
            return fallback_of_[character] = font.get();
        } catch (const EnvironmentError&) {
            continue;  // not a readable font
        }
    }
    missing_.push_back(character);
    return fallback_of_[character] = nullptr;
}

namespace {

// Draws the box for a character that no font has, as wide as a letter.
void add_missing_box(TypeBox& box, double size_px) {
    const double width = 0.5 * size_px, height = 0.7 * size_px, line = 0.06 * size_px;
    const double left = box.width + 0.05 * size_px;
    box.rules.push_back({left, 0.0, width, line});
    box.rules.push_back({left, height - line, width, line});
    box.rules.push_back({left, line, line, height - 2.0 * line});
    box.rules.push_back({left + width - line, line, line, height - 2.0 * line});
    box.width += width + 0.1 * size_px;
    box.height = std::max(box.height, height);
}

}  // namespace

TypeBox FontSet::set_text(const TextRun& run, TextFamily family, double size_px) {
    TypeBox box;
    std::vector<char32_t> part;
    std::vector<int> tints;
    FontFile* part_font = nullptr;
    const auto flush = [&] {
        if (part.empty()) return;
        const double scale = size_px / part_font->units_per_em();
        const ShapedRun shaped = part_font->shape(part);
        for (const ShapedGlyph& glyph : shaped.glyphs) {
            const GlyphMetrics& metrics = part_font->metrics(glyph.glyph);
            box.glyphs.push_back({part_font, glyph.glyph, box.width + glyph.x * scale,
                                  glyph.y * scale, scale, tints[glyph.character]});
            box.height = std::max(box.height, (metrics.height + glyph.y) * scale);
            box.depth = std::max(box.depth, (metrics.depth - glyph.y) * scale);
        }
        box.width += shaped.advance * scale;
        part.clear();
        tints.clear();
    };
    FontFile& face = text(family, run.face);
    for (const LabelCharacter& character : run.characters) {
        // A no-break space is as wide as a normal space.
        const char32_t code = character.code == U'\u00A0' ? U' ' : character.code;
        FontFile* font = face.glyph(code) ? &face : &math();
        if (font != &face && !font->glyph(code)) font = fallback(code);
        if (font != part_font) flush();
        part_font = font;
        if (font == nullptr) {
            add_missing_box(box, size_px);
            continue;
        }
        part.push_back(code);
        tints.push_back(character.tint);
    }
    flush();
    return box;
}

void fail_missing_glyph(char32_t character, int column) {
    throw LabelError(column, "no installed font has the character " + describe(character) +
                                 "; write it otherwise");
}

}  // namespace poinsot
