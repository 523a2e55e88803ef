// FontFile over a table of kept glyphs, in a page: the native program's is over FreeType and
// HarfBuzz.
#include <utility>

#include "typeset/font_file.h"
#include "typeset/kept_font.h"

namespace poinsot {

struct FontFile::Handles {
    KeptFont font;
};

FontFile::FontFile(std::string_view bytes, const std::filesystem::path& file)
    : handles_(new Handles{KeptFont(bytes)}), file_(file) {
    units_per_em_ = handles_->font.units_per_em();
}
FontFile::~FontFile() = default;
FontFile::FontFile(FontFile&&) noexcept = default;
FontFile& FontFile::operator=(FontFile&&) noexcept = default;

bool FontFile::has_math() const { return handles_->font.has_math(); }

std::optional<GlyphId> FontFile::glyph(char32_t character) { return script_glyph(character, 0); }

std::optional<GlyphId> FontFile::script_glyph(char32_t character, int level) {
    return handles_->font.script_glyph(character, level);
}

const GlyphMetrics& FontFile::metrics(GlyphId glyph) {
    if (const auto found = metrics_.find(glyph); found != metrics_.end()) return found->second;
    return metrics_.emplace(glyph, handles_->font.metrics(glyph)).first->second;
}

const GlyphOutline& FontFile::outline(GlyphId glyph) {
    if (const auto found = outlines_.find(glyph); found != outlines_.end()) return found->second;
    return outlines_.emplace(glyph, handles_->font.outline(glyph)).first->second;
}

ShapedRun FontFile::shape(std::span<const char32_t> characters) {
    return handles_->font.shape(characters);
}

double FontFile::constant(hb_ot_math_constant_t which) const {
    return handles_->font.constant(static_cast<std::size_t>(which));
}

TallForms FontFile::tall_forms(GlyphId glyph) const { return handles_->font.tall_forms(glyph); }

}  // namespace poinsot
