// A picture's hash depends on its pixels and its shape, not on the file that holds it.
#include "image/pixel_hash.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(PixelHash, DependsOnTheShape) {
    const Image wide(6, 2), tall(2, 6);
    EXPECT_NE(pixel_hash(wide), pixel_hash(tall));
    EXPECT_EQ(pixel_hash(wide), pixel_hash(Image(6, 2)));
}

TEST(PixelHash, DependsOnEveryBit) {
    Image a(3, 3), b(3, 3);
    b.set(2, 2, {0, 0, 1, 0});
    EXPECT_NE(pixel_hash(a), pixel_hash(b));
}

}  // namespace
}  // namespace poinsot
