// Draws labels as letters on their baselines.
#include "vector/passes/type.h"

#include <cstddef>
#include <utility>

namespace poinsot::vector {

bool is_omitted(const Canvas& canvas, const Label& label) {
    return label.with_point && label.at && canvas.occluders.at(*label.at, {}).before_bodies < 0.5;
}

void draw_label(const Canvas& canvas, const Label& label) {
    if (label.mask == nullptr || label.opacity <= 0.0) return;
    const GlyphMask& mask = *label.mask;
    if (mask.letters.empty() && mask.rules.empty()) return;
    if (is_omitted(canvas, label)) return;
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
    for (const MaskLetter& letter : mask.letters) {
        type.letters.push_back({letter.font_file,
                                letter.glyph,
                                corner.x() + pt * letter.x_px,
                                corner.y() + pt * letter.baseline_px,
                                pt * letter.em_px,
                                {}});
        if (letter.tint > 0 && static_cast<std::size_t>(letter.tint) <= label.inks.size())
            type.letters.back().colour = label.inks[static_cast<std::size_t>(letter.tint) - 1];
    }
    for (const MaskRule& rule : mask.rules)
        type.rules.add_rectangle(corner + pt * Eigen::Vector2d(rule.left_px, rule.top_px),
                                 pt * Eigen::Vector2d(rule.width_px, rule.height_px));
    type.ink = {label.colour, label.opacity};
    // Type over lines has a halo; over a uniform background a halo would be invisible.
    const View& view = canvas.view;
    const bool may_cover =
        label.over_figure || !(view.curves.empty() && view.arrows.empty() && view.planes.empty() &&
                               view.ellipsoids.empty() && view.meshes.empty());
    type.halo = {label.halo_colour, may_cover ? label.opacity : 0.0};
    type.halo_pt = canvas.pt(label.halo_px);
    canvas.add(std::move(type));
}

}  // namespace poinsot::vector
