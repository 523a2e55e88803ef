// Colours of films, compared with the formulas of BT.709 and with swscale.
#include "encoding/yuv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "encoding/libav_calls.h"
#include "image/synthetic.h"

namespace poinsot {
namespace {

struct Planes {
    Planes(int w, int h)
        : width(w),
          height(h),
          y(static_cast<std::size_t>(w * h)),
          cb(static_cast<std::size_t>(chroma_width() * chroma_height())),
          cr(cb.size()) {}
    int chroma_width() const { return (width + 1) / 2; }
    int chroma_height() const { return (height + 1) / 2; }
    YuvPlanes pointers() {
        return {y.data(), cb.data(), cr.data(), width, chroma_width(), chroma_width()};
    }
    int width, height;
    std::vector<std::uint8_t> y, cb, cr;
};

Planes converted(const Image& image) {
    Planes planes(image.width(), image.height());
    YuvConverter(image.width()).convert(image, planes.pointers());
    return planes;
}

Image filled(int width, int height, Rgba8 colour) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.set(x, y, colour);
    return image;
}

// BT.709-6 items 3.2 to 3.4 in real numbers, 8 bits.
struct Exact {
    double y, cb, cr;
};
Exact exact(double r, double g, double b) {
    const double luma = (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
    return {16 + 219 * luma, 128 + 224 * (b / 255 - luma) / 1.8556,
            128 + 224 * (r / 255 - luma) / 1.5748};
}

// Rounded values of BT.709 for 100 % bars, limited range, from the usual tables.
TEST(Yuv, PureColoursMatchTheTables) {
    const auto check = [](Rgba8 colour, int y, int cb, int cr) {
        const Planes planes = converted(filled(4, 4, colour));
        EXPECT_EQ(planes.y[5], y);
        EXPECT_EQ(planes.cb[3], cb);
        EXPECT_EQ(planes.cr[3], cr);
    };
    check({255, 255, 255, 255}, 235, 128, 128);
    check({0, 0, 0, 255}, 16, 128, 128);
    check({255, 0, 0, 255}, 63, 102, 240);
    check({0, 255, 0, 255}, 173, 42, 26);
    check({0, 0, 255, 255}, 32, 240, 118);
    check({255, 255, 0, 255}, 219, 16, 138);
    check({0, 255, 255, 255}, 188, 154, 16);
    check({255, 0, 255, 255}, 78, 214, 230);
}

TEST(Yuv, GreysHaveNoChroma) {
    for (int level = 0; level < 256; ++level) {
        const auto grey = static_cast<std::uint8_t>(level);
        const Planes planes = converted(filled(2, 2, {grey, grey, grey, 255}));
        EXPECT_EQ(planes.y[0], std::lround(16 + 219 * level / 255.0)) << level;
        EXPECT_EQ(planes.cb[0], 128) << level;
        EXPECT_EQ(planes.cr[0], 128) << level;
    }
}

TEST(Yuv, EveryColourIsWithinHalfALevel) {
    double worst_luma = 0, worst_chroma = 0;
    Planes planes(2, 2);
    YuvConverter converter(2);
    for (int r = 0; r < 256; r += 5)
        for (int g = 0; g < 256; g += 3)
            for (int b = 0; b < 256; b += 5) {
                converter.convert(
                    filled(2, 2,
                           {static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                            static_cast<std::uint8_t>(b), 255}),
                    planes.pointers());
                const Exact wanted = exact(r, g, b);
                worst_luma = std::max(worst_luma, std::abs(planes.y[0] - wanted.y));
                worst_chroma = std::max({worst_chroma, std::abs(planes.cb[0] - wanted.cb),
                                         std::abs(planes.cr[0] - wanted.cr)});
            }
    EXPECT_LT(worst_luma, 0.51);    // measured 0.5034
    EXPECT_LT(worst_chroma, 0.51);  // measured 0.5058
}

// As above in 10 bits; the exact values of 8 bits are four times smaller.
TEST(Yuv, EveryColourOfTenBitsIsWithinHalfALevel) {
    double worst = 0;
    std::array<std::uint16_t, 4> at{};
    for (int r = 0; r < 256; r += 5)
        for (int g = 0; g < 256; g += 3)
            for (int b = 0; b < 256; b += 5) {
                convert_to_10_bits(
                    filled(1, 1,
                           {static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                            static_cast<std::uint8_t>(b), 255}),
                    {reinterpret_cast<std::uint8_t*>(&at[0]),
                     reinterpret_cast<std::uint8_t*>(&at[1]),
                     reinterpret_cast<std::uint8_t*>(&at[2]),
                     reinterpret_cast<std::uint8_t*>(&at[3])},
                    {2, 2, 2, 2});
                const Exact wanted = exact(r, g, b);
                worst =
                    std::max({worst, std::abs(at[0] - 4 * wanted.y),
                              std::abs(at[1] - 4 * wanted.cb), std::abs(at[2] - 4 * wanted.cr)});
            }
    EXPECT_LT(worst, 0.506);
}

// Rows and columns are at their places, and an alpha of 8 bits is the upper part of one of 10.
TEST(Yuv, TenBitsKeepPlacesAndAlpha) {
    Image image = filled(3, 5, {0, 0, 0, 0});
    image.set(2, 4, {255, 255, 255, 255});
    image.set(1, 0, {0, 0, 0, 129});
    constexpr std::size_t stride = 4;  // in samples
    std::array<std::array<std::uint16_t, 5 * stride>, 4> planes{};
    std::array<std::uint8_t*, 4> pointers{};
    for (std::size_t i = 0; i < 4; ++i)
        pointers[i] = reinterpret_cast<std::uint8_t*>(planes[i].data());
    convert_to_10_bits(image, pointers, {8, 8, 8, 8});
    for (std::size_t y = 0; y < 5; ++y)
        for (std::size_t x = 0; x < 3; ++x) {
            const bool white = x == 2 && y == 4, half = x == 1 && y == 0;
            EXPECT_EQ(planes[0][y * stride + x], white ? 940 : 64);
            EXPECT_EQ(planes[1][y * stride + x], 512);
            EXPECT_EQ(planes[2][y * stride + x], 512);
            EXPECT_EQ(planes[3][y * stride + x], white ? 1023 : half ? 129 * 4 + 2 : 0);
        }
}

// Chroma lies on the even columns, between the rows: its filter is [1 2 1]/4 across, [1 1]/2 down.
TEST(Yuv, ChromaIsSitedLeft) {
    const int at = 4;
    const double full = exact(255, 0, 0).cr - 128;
    for (int x = at - 2; x <= at + 2; ++x) {
        Image image = filled(10, 4, {0, 0, 0, 255});
        image.set(x, 2, {255, 0, 0, 255});
        const Planes planes = converted(image);
        const double weight = x == at ? 0.5 : std::abs(x - at) == 1 ? 0.25 : 0;
        EXPECT_NEAR(planes.cr[static_cast<std::size_t>(planes.chroma_width() + at / 2)],
                    128 + full * weight / 2, 0.6)
            << x;
    }
}

TEST(Yuv, OddSizesRepeatTheLastColumnAndRow) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 3}, {5, 2}, {2, 7}}) {
        const Planes planes = converted(filled(width, height, {0, 0, 255, 255}));
        for (const std::uint8_t cb : planes.cb) EXPECT_EQ(cb, 240);
        for (const std::uint8_t y : planes.y) EXPECT_EQ(y, 32);
    }
}

// swscale, with its most accurate settings and the same position of chroma. It uses four rows where
// two are enough, so the rows are made equal.
TEST(Yuv, AgreesWithSwscale) {
    const Image picture = synthetic_frame(320, 180, 4);
    Image image(320, 180);
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x) image.set(x, y, picture.at(x, 90));
    SwsContext* scaler = sws_alloc_context();
    const auto set = [&](const char* key, std::int64_t value) {
        ASSERT_GE(av_opt_set_int(scaler, key, value, 0), 0) << key;
    };
    set("srcw", 320), set("srch", 180), set("dstw", 320), set("dsth", 180);
    set("src_format", AV_PIX_FMT_RGBA), set("dst_format", AV_PIX_FMT_YUV420P);
    set("sws_flags", SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INP);
    set("dst_h_chr_pos", 0), set("dst_v_chr_pos", 128);
    sws_setColorspaceDetails(scaler, sws_getCoefficients(SWS_CS_ITU709), 1,
                             sws_getCoefficients(SWS_CS_ITU709), 0, 0, 1 << 16, 1 << 16);
    ASSERT_GE(sws_init_context(scaler, nullptr, nullptr), 0);
    Planes theirs(320, 180);
    const std::uint8_t* source = image.bytes().data();
    const int source_stride = 4 * 320;
    std::uint8_t* const targets[] = {theirs.y.data(), theirs.cb.data(), theirs.cr.data()};
    const int strides[] = {320, 160, 160};
    sws_scale(scaler, &source, &source_stride, 0, 180, targets, strides);
    sws_freeContext(scaler);

    const Planes ours = converted(image);
    const auto worst = [](const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
        int largest = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::abs(int{a[i]} - int{b[i]}));
        return largest;
    };
    EXPECT_LE(worst(ours.y, theirs.y), 1);    // measured 1
    EXPECT_LE(worst(ours.cb, theirs.cb), 0);  // measured 0
    EXPECT_LE(worst(ours.cr, theirs.cr), 0);  // measured 0
}

TEST(Yuv, AlphaIsCopied) {
    Image image(3, 2);
    for (std::size_t i = 0; i < image.bytes().size(); ++i)
        image.bytes()[i] = static_cast<std::uint8_t>(i * 7);
    std::vector<std::uint8_t> plane(2 * 5);
    copy_alpha(image, plane.data(), 5);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            EXPECT_EQ(plane[static_cast<std::size_t>(5 * y + x)], image.at(x, y).a);
}

}  // namespace
}  // namespace poinsot
