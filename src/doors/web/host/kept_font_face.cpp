// FontFace over kept glyphs, in a page: its vector figures draw all type as paths, for a page has
// no font files that a figure could embed.
#include <string>

#include "vector/font_face.h"
#include "web/host/kept_fonts.h"

namespace poinsot::vector {

struct FontFace::Handles {
    const KeptFont* font;
};

FontFace::FontFace(const std::filesystem::path& file)
    : handles_(new Handles{&kept_font_named(file.string())}) {}
FontFace::~FontFace() = default;
FontFace::FontFace(FontFace&&) noexcept = default;

char32_t FontFace::character(std::uint32_t) const { return 0; }
std::u32string FontFace::meaning(std::uint32_t) const { return {}; }
std::string FontFace::family() const { return {}; }
std::string FontFace::subset(const std::set<char32_t>&) const { return {}; }
FT_FaceRec_* FontFace::handle() const { return nullptr; }
char32_t plain_letter(char32_t character) { return character; }

double FontFace::advance(std::uint32_t glyph) const {
    return handles_->font->metrics(glyph).advance / handles_->font->units_per_em();
}

Path FontFace::outline(std::uint32_t glyph) const {
    const double unit = 1.0 / handles_->font->units_per_em();
    const auto placed = [unit](const OutlinePoint& point) {
        return Eigen::Vector2d(unit * point.x, -unit * point.y);
    };
    Path path;
    bool is_open = false;
    for (const OutlineStep& step : handles_->font->outline(glyph).steps) {
        switch (step.kind) {
            case OutlineStep::Kind::move:
                if (is_open) path.close();
                path.move(placed(step.to));
                is_open = true;
                break;
            case OutlineStep::Kind::line:
                path.line(placed(step.to));
                break;
            case OutlineStep::Kind::cubic:
                path.cubic(placed(step.control_1), placed(step.control_2), placed(step.to));
                break;
        }
    }
    if (is_open) path.close();
    return path;
}

FontFace& FontFaces::of(const std::filesystem::path& file) {
    return faces_.try_emplace(file, file).first->second;
}

}  // namespace poinsot::vector
