#include "shapes/depth_order.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

// Two axes that cross at the origin of the picture: there `first` has depth 3, `second` depth 2.
const SeenAxis first{{{-1.0, 0.0}, 3.0}, {{1.0, 0.0}, 3.0}};
const SeenAxis second{{{0.0, -1.0}, 1.0}, {{0.0, 1.0}, 3.0}};

TEST(DepthOrder, NearerAtTheCrossingIsLast) {
    const SeenAxis ahead[] = {first, second}, behind[] = {second, first};
    EXPECT_EQ(back_to_front(ahead, {}, false), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(back_to_front(behind, {}, false), (std::vector<std::size_t>{1, 0}));
}

// Halfway in the picture, an axis from depth 1 to 3 in perspective has depth 1.5 (1/depth is linear
// there), not 2.
TEST(DepthOrder, PerspectiveIsLinearInTheInverseDepth) {
    const SeenAxis between{{{-1.0, 0.0}, 1.75}, {{1.0, 0.0}, 1.75}};
    const SeenAxis axes[] = {between, second};
    EXPECT_EQ(back_to_front(axes, {}, true), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(back_to_front(axes, {}, false), (std::vector<std::size_t>{1, 0}));
}

TEST(DepthOrder, DotOnAnArrowIsInFrontOfIt) {
    const SeenAxis axes[] = {first};
    const SeenPoint dots[] = {{{0.5, 0.0}, 3.0}, {{0.5, 0.0}, 3.5}};
    EXPECT_EQ(back_to_front(axes, dots, false), (std::vector<std::size_t>{2, 0, 1}));
}

}  // namespace
}  // namespace poinsot
