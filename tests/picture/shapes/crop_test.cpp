// Parts of a drawing that are drawn separately.
#include "shapes/crop.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace poinsot {
namespace {

// Cropped pieces of large labels belong to the view of the part that uses them.
TEST(Part, LabelsReferToMasksOfTheirOwnView) {
    constexpr int n_views = 5;
    Drawing whole;
    whole.width_px = whole.height_px = 4000;
    std::deque<GlyphMask> masks;
    for (int k = 0; k < n_views; ++k) {
        GlyphMask& mask = masks.emplace_back();
        mask.id = static_cast<std::uint64_t>(k) + 1;
        mask.width = 2000 + k;
        mask.height = 10;
        mask.coverage.resize(static_cast<std::size_t>(mask.width) * 10, 200);
        View& view = whole.views.emplace_back();
        view.width_px = view.height_px = 4000;
        Label& label = view.labels.emplace_back();
        label.mask = &mask;
        label.top_left_px = {100.0, 100.0 + 20.0 * k};
    }
    const Drawing part = cropped(whole, {0, 0, 4000, 1000});
    ASSERT_EQ(part.views.size(), static_cast<std::size_t>(n_views));
    for (const View& view : part.views) {
        ASSERT_EQ(view.labels.size(), 1u);
        EXPECT_TRUE(
            std::any_of(view.live_masks.begin(), view.live_masks.end(),
                        [&](const GlyphMask& held) { return &held == view.labels[0].mask; }));
    }
}

}  // namespace
}  // namespace poinsot
