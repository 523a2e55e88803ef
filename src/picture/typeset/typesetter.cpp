#include "typeset/typesetter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "typeset/caption_layout.h"
#include "typeset/label_parser.h"
#include "typeset/math_layout.h"
#include "typeset/rasteriser.h"

namespace poinsot {
namespace {

constexpr double size_limit_px = 4096.0;
// A large mask is computed in bands of rows, so that the buffer fits into the CPU cache.
constexpr std::size_t band_pixels = 1u << 18;

void check_style(const TypeStyle& style) {
    if (!(style.size_px >= 1.0 && style.size_px <= size_limit_px)) {
        throw InputError(fmt::format("type size {} px; give one between 1 and {}", style.size_px,
                                     size_limit_px));
    }
    if (!(style.max_width_px >= 0.0 && std::isfinite(style.max_width_px))) {
        throw InputError(
            fmt::format("caption width {} px; give 0 or a positive width", style.max_width_px));
    }
    if (!(style.line_spacing > 0.0 && style.line_spacing <= 10.0)) {
        throw InputError(fmt::format("line spacing {}; give one up to 10 ems", style.line_spacing));
    }
}

struct GlyphRun {
    TypeBox box;
    int n_lines = 0;
};

GlyphRun set_type(std::string_view text, const TypeStyle& style, FontSet& fonts) {
    check_style(style);
    if (style.mode == TypeMode::math) {
        const MathList atoms = parse_math(text);
        const MathStyle display{MathStyle::Level::display, false};
        return {set_formula(atoms, display, style.size_px, fonts), atoms.empty() ? 0 : 1};
    }
    Caption parsed = parse_caption(text);
    if (style.terms != nullptr) tint_terms(*style.terms, parsed);
    SetCaption caption = set_caption(parsed, style, fonts);
    return {std::move(caption.box), caption.n_lines};
}

// Aligns the upper edge of every rule, and the glyphs attached to it, to whole pixels: a bar has a
// sharp edge instead of two grey rows.
void align_rules(TypeBox& box) {
    for (PlacedRule& rule : box.rules) {
        const double top = rule.y + rule.thickness;
        const double move = std::floor(top + 0.5) - top;
        rule.y += move;
        for (std::size_t i = rule.first_glyph; i < rule.last_glyph; ++i) box.glyphs[i].y += move;
    }
}

// The smallest box of whole pixels around the ink; y down.
struct InkBox {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    bool empty = true;

    void include(double x0, double y0, double x1, double y1) {
        left = empty ? x0 : std::min(left, x0);
        top = empty ? y0 : std::min(top, y0);
        right = empty ? x1 : std::max(right, x1);
        bottom = empty ? y1 : std::max(bottom, y1);
        empty = false;
    }
};

InkBox ink_of(const TypeBox& box) {
    InkBox ink;
    for (const PlacedGlyph& placed : box.glyphs) {
        const GlyphOutline& outline = placed.font->outline(placed.glyph);
        if (outline.steps.empty()) continue;
        ink.include(placed.x + outline.min_x * placed.px_per_unit,
                    -placed.y - outline.max_y * placed.px_per_unit,
                    placed.x + outline.max_x * placed.px_per_unit,
                    -placed.y - outline.min_y * placed.px_per_unit);
    }
    for (const PlacedRule& rule : box.rules) {
        if (rule.width <= 0.0) continue;
        ink.include(rule.x, -rule.y - rule.thickness, rule.x + rule.width, -rule.y);
    }
    return ink;
}

TypeExtent extent_of(const GlyphRun& set) {
    TypeExtent extent;
    extent.advance_px = set.box.width;
    extent.n_lines = set.n_lines;
    const InkBox ink = ink_of(set.box);
    if (ink.empty) return extent;
    const double left = std::floor(ink.left), top = std::floor(ink.top);
    const double width = std::ceil(ink.right) - left, height = std::ceil(ink.bottom) - top;
    if (!(width <= mask_side_limit_px && height <= mask_side_limit_px)) {
        throw InputError(
            fmt::format("a label of {:.0f}x{:.0f} px; at most {} a side can be set, "
                        "take a smaller size or shorten it",
                        width, height, mask_side_limit_px));
    }
    extent.width = static_cast<int>(width);
    extent.height = static_cast<int>(height);
    extent.left_px = static_cast<int>(left);
    extent.baseline_px = -top;
    return extent;
}

void rasterise(const TypeBox& box, TypesetMask& mask) {
    const auto width = static_cast<std::size_t>(mask.width);
    mask.coverage.resize(width * static_cast<std::size_t>(mask.height));
    if (mask.coverage.empty()) return;
    const int band = static_cast<int>(std::max<std::size_t>(1, band_pixels / width));
    for (int first = 0; first < mask.height; first += band) {
        Rasteriser rows(mask.width, first, std::min(band, mask.height - first));
        for (const PlacedGlyph& placed : box.glyphs) {
            rows.add(placed.font->outline(placed.glyph), placed.x - mask.left_px,
                     mask.baseline_px - placed.y, placed.px_per_unit);
        }
        for (const PlacedRule& rule : box.rules) {
            if (rule.width <= 0.0) continue;
            const double left = rule.x - mask.left_px, bottom = mask.baseline_px - rule.y;
            rows.add_rectangle(left, bottom - rule.thickness, left + rule.width, bottom);
        }
        rows.write(mask.coverage.data() + width * static_cast<std::size_t>(first));
    }
}

// The tint of each pixel that a tinted glyph covers more than all others do.
void tint(const TypeBox& box, TypesetMask& mask) {
    std::set<int> tints;
    for (const PlacedGlyph& placed : box.glyphs) tints.insert(placed.tint);
    tints.erase(0);
    if (tints.empty() || mask.coverage.empty()) return;
    mask.tints.resize(mask.coverage.size());
    for (const int tint : tints) {
        TypeBox of_tint;
        for (const PlacedGlyph& placed : box.glyphs)
            if (placed.tint == tint) of_tint.glyphs.push_back(placed);
        TypesetMask alone{static_cast<const TypeExtent&>(mask), {}, {}, {}, {}};
        rasterise(of_tint, alone);
        for (std::size_t k = 0; k < mask.coverage.size(); ++k)
            if (2 * alone.coverage[k] > mask.coverage[k])
                mask.tints[k] = static_cast<std::uint8_t>(tint);
    }
}

}  // namespace

struct Typesetter::State {
    FontSet fonts;
};

Typesetter::Typesetter(FontSource fonts)
    : state_(std::make_unique<State>(State{FontSet(std::move(fonts))})) {}
Typesetter::~Typesetter() = default;
Typesetter::Typesetter(Typesetter&&) noexcept = default;
Typesetter& Typesetter::operator=(Typesetter&&) noexcept = default;

const std::vector<std::filesystem::path>& Typesetter::fallbacks_used() const {
    return state_->fonts.fallbacks_used();
}
const std::vector<char32_t>& Typesetter::missing() const { return state_->fonts.missing(); }

TypesetMask Typesetter::set(std::string_view text, const TypeStyle& style) const {
    GlyphRun type = set_type(text, style, state_->fonts);
    align_rules(type.box);
    TypesetMask mask{extent_of(type), {}, {}, {}, {}};
    rasterise(type.box, mask);
    tint(type.box, mask);
    for (const PlacedGlyph& placed : type.box.glyphs)
        mask.glyphs.push_back({&placed.font->file(), placed.glyph, placed.x - mask.left_px,
                               mask.baseline_px - placed.y,
                               placed.px_per_unit * placed.font->units_per_em(), placed.tint});
    for (const PlacedRule& rule : type.box.rules)
        if (rule.width > 0.0)
            mask.rules.push_back({rule.x - mask.left_px, mask.baseline_px - rule.y - rule.thickness,
                                  rule.width, rule.thickness});
    return mask;
}

TypeExtent Typesetter::measure(std::string_view text, const TypeStyle& style) const {
    GlyphRun type = set_type(text, style, state_->fonts);
    align_rules(type.box);
    return extent_of(type);
}

}  // namespace poinsot
