#include "image/downsample.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(Downsample, PreservesAUniformColour) {
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
    // Half black and half white gives half the light: sRGB level 188 (0.5 → 0.7354 · 255 = 187.5).
    Image image(2, 2);
    image.set(0, 0, {255, 255, 255, 255});
    image.set(1, 1, {255, 255, 255, 255});
    image.set(1, 0, {0, 0, 0, 255});
    image.set(0, 1, {0, 0, 0, 255});
    EXPECT_EQ(downsampled(image, 2).at(0, 0), (Rgba8{188, 188, 188, 255}));
}

TEST(Downsample, TransparentPixelsContributeNoColour) {
    Image image(2, 2);
    image.set(0, 0, {200, 50, 10, 255});
    image.set(1, 0, {200, 50, 10, 255});
    image.set(0, 1, {0, 0, 0, 0});
    image.set(1, 1, {0, 0, 0, 0});
    EXPECT_EQ(downsampled(image, 2).at(0, 0), (Rgba8{200, 50, 10, 128}));
}

TEST(Downsample, DeepPicturesMixInLinearLight) {
    DeepImage image(2, 2);
    const auto set = [&](std::size_t pixel, std::uint16_t level, std::uint16_t alpha) {
        for (std::size_t c = 0; c < 3; ++c) image.samples()[4 * pixel + c] = level;
        image.samples()[4 * pixel + 3] = alpha;
    };
    const auto mean = [&] {
        DeepImage small;
        downsample_into(image, 2, small);
        return std::pair{small.samples()[0], small.samples()[3]};
    };
    // Half the light: 1.055·0.5^(1/2.4) − 0.055 = 0.735357, of 65535.
    set(0, 65535, 65535), set(1, 0, 65535), set(2, 0, 65535), set(3, 65535, 65535);
    EXPECT_EQ(mean(), (std::pair<std::uint16_t, std::uint16_t>{48192, 65535}));
    // Transparent pixels contribute no colour.
    set(0, 12345, 65535), set(1, 12345, 65535), set(2, 0, 0), set(3, 0, 0);
    EXPECT_EQ(mean(), (std::pair<std::uint16_t, std::uint16_t>{12345, 32768}));
}

}  // namespace
}  // namespace poinsot
