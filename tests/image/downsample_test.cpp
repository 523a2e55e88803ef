#include "image/downsample.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(Downsample, KeepsAnEvenColour) {
    Image image(6, 4);
    for (int level : {0, 1, 7, 100, 200, 255}) {
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 6; ++x) {
                image.set(x, y, {static_cast<std::uint8_t>(level), 10, 250, 255});
            }
        }
        const Image small = downsampled(image, 2);
        ASSERT_EQ(small.width(), 3);
        ASSERT_EQ(small.height(), 2);
        EXPECT_EQ(small.at(2, 1), (Rgba8{static_cast<std::uint8_t>(level), 10, 250, 255}));
    }
}

TEST(Downsample, MixesInLinearLight) {
    // Half black and half white is half the light: sRGB level 188 (0.5 → 0.7354 · 255 = 187.5).
    Image image(2, 2);
    image.set(0, 0, {255, 255, 255, 255});
    image.set(1, 1, {255, 255, 255, 255});
    image.set(1, 0, {0, 0, 0, 255});
    image.set(0, 1, {0, 0, 0, 255});
    EXPECT_EQ(downsampled(image, 2).at(0, 0), (Rgba8{188, 188, 188, 255}));
}

TEST(Downsample, TransparentPixelsLendNoColour) {
    Image image(2, 2);
    image.set(0, 0, {200, 50, 10, 255});
    image.set(1, 0, {200, 50, 10, 255});
    image.set(0, 1, {0, 0, 0, 0});
    image.set(1, 1, {0, 0, 0, 0});
    EXPECT_EQ(downsampled(image, 2).at(0, 0), (Rgba8{200, 50, 10, 128}));
}

}  // namespace
}  // namespace poinsot
