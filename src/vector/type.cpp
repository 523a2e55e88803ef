// Draws labels as letters on their baselines.
#include <cstddef>
#include <utility>

#include "vector/canvas.h"

namespace poinsot::vector {

namespace {

// A band behind type for legibility: each row is as dense as the mask's row.
void draw_band(const Canvas& canvas, const Label& label) {
    const GlyphMask& mask = *label.mask;
    const double pt = canvas.pt(mask.samples);
    const Eigen::Vector2d corner = canvas.projection.units_per_px * label.top_left_px;
    const Eigen::Vector2d size = pt * Eigen::Vector2d(mask.width, mask.height);
    LinearFade fade{corner, corner + Eigen::Vector2d(0.0, size.y()), {}};
    constexpr int n_stops = 33;
    for (int k = 0; k < n_stops; ++k) {
        const int row = k * (mask.height - 1) / (n_stops - 1);
        const double density =
            mask.coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(mask.width)] /
            255.0;
        fade.stops.push_back(
            {k / (n_stops - 1.0), PaperInk{label.colour, label.opacity * density}});
    }
    Fill fill;
    fill.path.add_rectangle(corner, size);
    fill.paint = std::move(fade);
    canvas.add(std::move(fill));
}

}  // namespace

bool is_omitted(const Canvas& canvas, const Label& label) {
    return label.with_point && label.at && canvas.occluders.at(*label.at, {}).before_bodies < 0.5;
}

void draw_label(const Canvas& canvas, const Label& label) {
    if (label.mask == nullptr || label.opacity <= 0.0) return;
    const GlyphMask& mask = *label.mask;
    if (mask.letters.empty() && mask.rules.empty()) return;
    if (is_omitted(canvas, label)) return;
    if (mask.letters.empty()) {
        draw_band(canvas, label);
        return;
    }
    const double pt = canvas.pt(mask.samples);
    const Eigen::Vector2d corner = canvas.projection.units_per_px * label.top_left_px;
    Type type;
    type.wording = {
        mask.source.text,
        mask.source.is_formula,
        pt * mask.source.em_px,
        corner,
        canvas.projection.units_per_px * Eigen::Vector2d(mask.width_px(), mask.height_px()),
        pt * mask.source.baseline_px,
        label.held_at,
        pt * mask.source.max_width_px};
    for (const MaskLetter& letter : mask.letters)
        type.letters.push_back({letter.font_file, letter.glyph, corner.x() + pt * letter.x_px,
                                corner.y() + pt * letter.baseline_px, pt * letter.em_px});
    for (const MaskRule& rule : mask.rules)
        type.rules.add_rectangle(corner + pt * Eigen::Vector2d(rule.left_px, rule.top_px),
                                 pt * Eigen::Vector2d(rule.width_px, rule.height_px));
    type.ink = {label.colour, label.opacity};
    // Type over lines has a halo; over a uniform background a halo would be invisible.
    const View& view = canvas.view;
    const bool may_cover = !(view.curves.empty() && view.arrows.empty() && view.planes.empty() &&
                             view.ellipsoids.empty() && view.meshes.empty());
    type.halo = {label.halo_colour, may_cover ? label.opacity : 0.0};
    type.halo_pt = canvas.pt(label.halo_px);
    canvas.add(std::move(type));
}

}  // namespace poinsot::vector
