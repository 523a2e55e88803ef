#include "shapes/crop.h"

#include <algorithm>
#include <cmath>

#include "shapes/identity.h"

namespace poinsot {

namespace {

// A mask smaller than this is kept whole: then one upload serves all crops.
constexpr int largest_whole_mask_px = 1024;

// Crops a mask to a rectangle whose corner is (x, y).
GlyphMask cut(const GlyphMask& mask, int x, int y, int width, int height) {
    GlyphMask crop;
    crop.id = next_identity();
    crop.width = width;
    crop.height = height;
    crop.samples = mask.samples;
    crop.coverage.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int row = y; row < y + height; ++row) {
        const auto from = mask.coverage.begin() + static_cast<std::ptrdiff_t>(row) * mask.width + x;
        crop.coverage.insert(crop.coverage.end(), from, from + width);
        if (mask.tints.empty()) continue;
        const auto tint = mask.tints.begin() + static_cast<std::ptrdiff_t>(row) * mask.width + x;
        crop.tints.insert(crop.tints.end(), tint, tint + width);
    }
    return crop;
}

// Adds a label in the pixels of the area, unless it lies outside.
void add_label(Label label, const PixelArea& area, View& view) {
    if (label.mask == nullptr) return;
    const GlyphMask& mask = *label.mask;
    const int n = mask.samples;
    const double reach = std::ceil(std::max(label.halo_px / n, 0.0)) + 2.0;
    // The columns or rows of the mask whose ink or halo extends into the area.
    const auto range = [n, reach](double corner_px, int size, int room_px) {
        const double corner = corner_px / n, room = 1.0 * room_px / n;
        const double first = std::clamp(std::floor(-corner - reach), 0.0, 1.0 * size);
        const double end = std::clamp(std::ceil(room - corner + reach), 0.0, 1.0 * size);
        return std::pair(static_cast<int>(first), static_cast<int>(end));
    };
    const auto [left, right] = range(label.top_left_px.x(), mask.width, area.width_px);
    const auto [top, bottom] = range(label.top_left_px.y(), mask.height, area.height_px);
    if (left >= right || top >= bottom) return;
    if (std::max(mask.width, mask.height) > largest_whole_mask_px) {
        label.mask =
            &view.live_masks.emplace_back(cut(mask, left, top, right - left, bottom - top));
        label.top_left_px += Eigen::Vector2d(n * left, n * top);
    }
    view.labels.push_back(label);
}

}  // namespace

Drawing cropped(const Drawing& whole, const PixelArea& area) {
    Drawing crop;
    crop.width_px = area.width_px;
    crop.height_px = area.height_px;
    crop.background = whole.background;
    crop.background_top_px = whole.background_top_px - area.y_px;
    crop.background_rows_px =
        whole.background_rows_px > 0 ? whole.background_rows_px : whole.height_px;
    // Labels refer to masks of their own view, so reallocation must not copy the views.
    crop.views.reserve(whole.views.size());
    for (const View& view : whole.views) {
        View& shifted = crop.views.emplace_back(view);
        shifted.x_px -= area.x_px;
        shifted.y_px -= area.y_px;
        shifted.labels.clear();
        shifted.live_masks.clear();
        shifted.live_curves.clear();  // the whole drawing owns those to which the curves refer
        for (Label label : view.labels) {
            label.top_left_px -= Eigen::Vector2d(area.x_px, area.y_px);
            add_label(label, area, shifted);
        }
    }
    return crop;
}

}  // namespace poinsot
