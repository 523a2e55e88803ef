// The fast hash agrees with published values and does not depend on how a file stores the pixels.
#include "image/pixels_xxh64.h"

#include <gtest/gtest.h>

#include <random>

#include "image/files/png_bands.h"
#include "image/files/png_files.h"
#include "image/synthetic.h"
#include "system/faults.h"

namespace poinsot {
namespace {

std::uint64_t hash_of(std::string_view text) {
    Xxh64 hash;
    hash.add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return hash.value();
}

// Values published by users of the reference implementation.
TEST(Xxh64, AgreesWithPublishedValues) {
    EXPECT_EQ(hash_of(""), 0xef46db3751d8e999u);
    EXPECT_EQ(hash_of("a"), 0xd24ec4f1a98c6e5bu);
    EXPECT_EQ(hash_of("abc"), 0x44bc2cf5ad770999u);
    EXPECT_EQ(hash_of("Nobody inspects the spammish repetition"), 0xfbcea83c8a378bf1u);
}

TEST(PixelsXxh64, OfAnImageEqualsThatOfItsFile) {
    const TemporaryFolder folder;
    Image image = synthetic_frame(70, 50, 4);
    for (const std::uint8_t alpha : {255, 100}) {
        image.set(3, 2, {1, 2, 3, alpha});
        write_png(folder / "a.png", image);
        EXPECT_EQ(pixels_xxh64_of(folder / "a.png"), pixels_xxh64(image)) << int{alpha};
    }
    const std::string before = pixels_xxh64(image);
    image.set(69, 49, {1, 2, 4, 255});
    EXPECT_NE(pixels_xxh64(image), before);
    // The same number of equal bytes in a different shape is a different picture.
    EXPECT_NE(pixels_xxh64(Image(20, 10)), pixels_xxh64(Image(10, 20)));
}

// In a picture written without alpha, the alpha of its bands is ignored.
TEST(PixelsXxh64, OfBandsEqualsThatOfTheFile) {
    const TemporaryFolder folder;
    std::mt19937 random(9);
    for (const bool opaque : {true, false}) {
        PngBandWriter shallow(folder / "8.png", 30, 20, opaque);
        PngBandWriter deep(folder / "16.png", 30, 20, opaque, {}, 16);
        for (int band = 0; band < 2; ++band) {
            Image image(30, 10);
            for (std::uint8_t& byte : image.bytes()) byte = static_cast<std::uint8_t>(random());
            shallow.write(image);
            DeepImage deep_image(30, 10);
            for (std::uint16_t& s : deep_image.samples()) s = static_cast<std::uint16_t>(random());
            deep.write(deep_image);
        }
        const std::string of_shallow = shallow.pixels_xxh64(), of_deep = deep.pixels_xxh64();
        shallow.finish({{"Note", of_shallow}});
        deep.finish();
        EXPECT_EQ(pixels_xxh64_of(folder / "8.png"), of_shallow);
        EXPECT_EQ(pixels_xxh64_of(folder / "16.png"), of_deep);
        EXPECT_EQ(pixels_xxh64(read_stored_png(folder / "16.png")), of_deep);
        // The texts after the pixels are read without decoding the pixels.
        EXPECT_EQ(read_png_info(folder / "8.png").texts["Note"], of_shallow);
        EXPECT_EQ(read_png_info(folder / "8.png").height_px, 20);
    }
}

}  // namespace
}  // namespace poinsot
