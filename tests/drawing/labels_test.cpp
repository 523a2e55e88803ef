#include "drawing/type/labels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace poinsot {
namespace {

class Labels : public testing::Test {
 protected:
    Labels() {
        view.width_px = 800;
        view.height_px = 600;
        mask.id = 1;
        mask.width = 40;
        mask.height = 20;
        mask.coverage.assign(800, 255);
    }
    LabelWish wish(double x, double y, double dx, double dy) const {
        LabelWish w;
        w.type.mask = &mask;
        w.anchor_px = {x, y};
        w.away = {dx, dy};
        w.gap_px = 5.0;
        return w;
    }
    Eigen::Vector2d centre(std::size_t i) const {
        return view.labels[i].top_left_px + Eigen::Vector2d(20.0, 10.0);
    }
    View view;
    GlyphMask mask;
};

TEST_F(Labels, StandOnTheSideThatTheyAskFor) {
    place_labels({wish(400, 300, 1, 0), wish(100, 300, 0, -1)}, {}, 2.0, view);
    EXPECT_GT(view.labels[0].top_left_px.x(), 400.0);
    EXPECT_LT(view.labels[1].top_left_px.y() + 20.0, 300.0);
}

TEST_F(Labels, DoNotCoverEachOther) {
    place_labels({wish(400, 300, 1, 0), wish(404, 302, 1, 0.05), wish(398, 301, 1, -0.05)}, {}, 2.0,
                 view);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) {
            const Eigen::Vector2d apart = (centre(i) - centre(j)).cwiseAbs();
            EXPECT_TRUE(apart.x() > 36.0 || apart.y() > 14.0) << apart.transpose();
        }
    }
}

TEST_F(Labels, StayInsideTheView) {
    place_labels({wish(799, 300, 1, 0), wish(0, 0, -1, -1)}, {}, 3.0, view);
    for (const Label& label : view.labels) {
        EXPECT_GE(label.top_left_px.x(), 3.0);
        EXPECT_GE(label.top_left_px.y(), 3.0);
        EXPECT_LE(label.top_left_px.x() + 40.0, 797.0);
    }
}

TEST_F(Labels, MoveContinuously) {
    // A label whose direction turns once round and passes through zero never jumps.
    Eigen::Vector2d before;
    double largest = 0.0;
    constexpr int n = 4000;
    for (int k = 0; k <= n; ++k) {
        const double angle = 2.0 * 3.14159265358979 * k / n;
        view.labels.clear();
        place_labels({wish(400, 300, std::cos(angle), 0.3 * std::sin(angle)), wish(430, 300, 1, 0)},
                     {}, 2.0, view);
        if (k > 0) largest = std::max(largest, (centre(0) - before).norm());
        before = centre(0);
    }
    EXPECT_LT(largest, 2.0);  // measured below 1 px a step of 2π/4000
}

}  // namespace
}  // namespace poinsot
