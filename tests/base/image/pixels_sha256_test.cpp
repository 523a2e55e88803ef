// A picture's hash depends on its pixels and its shape, not on the file that holds it.
#include "image/pixels_sha256.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(PixelsSha256, DependsOnTheShape) {
    const Image wide(6, 2), tall(2, 6);
    EXPECT_NE(pixels_sha256(wide), pixels_sha256(tall));
    EXPECT_EQ(pixels_sha256(wide), pixels_sha256(Image(6, 2)));
}

TEST(PixelsSha256, DependsOnEveryBit) {
    Image a(3, 3), b(3, 3);
    b.set(2, 2, {0, 0, 1, 0});
    EXPECT_NE(pixels_sha256(a), pixels_sha256(b));
}

}  // namespace
}  // namespace poinsot
