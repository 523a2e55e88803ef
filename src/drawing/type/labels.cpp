#include "drawing/type/labels.h"

#include <algorithm>
#include <cmath>

#include "shapes/identity.h"

namespace poinsot {

namespace {

// 1 for a point in the view, falling to 0 a little way outside: a label stays with what it names,
// and leaves with it.
double nearness_to_view(const Eigen::Vector2d& at_px, const View& view) {
    const double reach_px = 0.06 * view.height_px;
    const double outside_px =
        std::max({view.x_px - at_px.x(), at_px.x() - view.x_px - view.width_px,
                  view.y_px - at_px.y(), at_px.y() - view.y_px - view.height_px, 0.0});
    return std::clamp(1.0 - outside_px / reach_px, 0.0, 1.0);
}

}  // namespace

TypesetMask TypeCase::set_legible(std::string_view text, TypeStyle style) const {
    style.size_px /= samples_;
    style.max_width_px /= samples_;
    if (style.size_px >= least_legible_px || !(style.size_px > 0.0))
        return typesetter_.set(text, style);
    style.size_px = least_legible_px;
    typesetter_.measure(text, style);
    return {};
}

SetType TypeCase::keep(TypesetMask&& set, std::deque<GlyphMask>& masks) const {
    GlyphMask& mask = masks.emplace_back();
    mask.id = next_identity();
    mask.width = set.width;
    mask.height = set.height;
    mask.samples = samples_;
    mask.coverage = std::move(set.coverage);
    for (const SetGlyph& glyph : set.glyphs)
        mask.letters.push_back(
            {glyph.font_file, glyph.glyph, glyph.x_px, glyph.baseline_px, glyph.em_px});
    for (const SetRule& rule : set.rules)
        mask.rules.push_back({rule.left_px, rule.top_px, rule.width_px, rule.height_px});
    return {&mask, samples_ * set.left_px, samples_ * set.baseline_px};
}

SetType TypeCase::set(std::string_view text, const TypeStyle& style) {
    const auto key = std::make_tuple(std::string(text), style.size_px, static_cast<int>(style.mode),
                                     style.max_width_px);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    const SetType type = keep(set_legible(text, style), masks_);
    known_.emplace(key, type);
    return type;
}

SetType TypeCase::set_live(std::string_view text, const TypeStyle& style, View& view) const {
    return keep(set_legible(text, style), view.live_masks);
}

void place_labels(const std::vector<LabelWish>& wishes, const Colour& halo, double halo_px,
                  View& view) {
    struct Box {
        Eigen::Vector2d centre;
        Eigen::Vector2d half;
    };
    std::vector<Box> boxes;
    for (const LabelWish& wish : wishes) {
        const Eigen::Vector2d half =
            0.5 * Eigen::Vector2d(wish.type.width_px(), wish.type.height_px());
        // The box touches the anchor's neighbourhood as an ellipse would: smooth in the direction.
        // A vanishing direction (an arrow pointing at the eye) fades into "to the right". No
        // function of the direction alone is continuous there: the box comes nearer to the anchor
        // as well.
        const Eigen::Vector2d leaning = wish.away + Eigen::Vector2d(0.2, 0.0);
        const double length = std::max(leaning.norm(), 1e-9);
        const Eigen::Vector2d away = leaning / length;
        const double reach = std::hypot(half.x() * away.x(), half.y() * away.y());
        const double nearness = length / std::hypot(length, 0.25);
        boxes.push_back({wish.anchor_px + away * (nearness * (wish.gap_px + reach)), half});
    }

    // Overlapping pairs push each other apart along the line of their centres, as ellipses of their
    // boxes.
    constexpr int n_rounds = 40;
    for (int round = 0; round < n_rounds; ++round) {
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t j = i + 1; j < boxes.size(); ++j) {
                const Eigen::Vector2d sum = 1.25 * (boxes[i].half + boxes[j].half);
                const Eigen::Vector2d between = boxes[j].centre - boxes[i].centre;
                const double nearness = between.cwiseQuotient(sum).norm();
                // Of two that are left out it is no number.
                if (!(nearness < 1.0)) continue;
                const Eigen::Vector2d push =
                    0.5 * (1.0 - nearness) * between.cwiseQuotient(sum).cwiseProduct(sum) /
                    std::max(nearness, 1e-3) * wishes[i].opacity * wishes[j].opacity;
                boxes[i].centre -= 0.5 * push;
                boxes[j].centre += 0.5 * push;
            }
        }
    }

    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (wishes[i].type.mask->width == 0) continue;
        const double margin = halo_px + 2.0 * wishes[i].type.mask->samples;
        Eigen::Vector2d corner = boxes[i].centre - boxes[i].half;
        const auto keep = [&](double value, double from, double size, double box) {
            return std::max(from + margin, std::min(value, from + size - box - margin));
        };
        corner.x() = keep(corner.x(), view.x_px, view.width_px, 2.0 * boxes[i].half.x());
        corner.y() = keep(corner.y(), view.y_px, view.height_px, 2.0 * boxes[i].half.y());
        Label label;
        label.mask = wishes[i].type.mask;
        label.top_left_px = corner;
        label.colour = wishes[i].colour;
        label.halo_colour = halo;
        label.halo_px = halo_px;
        label.opacity = wishes[i].opacity * nearness_to_view(wishes[i].anchor_px, view);
        if (!(label.opacity > 0.0)) continue;
        view.labels.push_back(label);
    }
}

}  // namespace poinsot
