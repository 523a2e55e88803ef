// Labels.
#include "render/passes/label_pass.h"

#include <gtest/gtest.h>

#include <array>

#include "pictures.h"

namespace poinsot::testing {
namespace {

GlyphMask block(std::uint64_t id, int width, int height) {
    GlyphMask mask;
    mask.id = id;
    mask.width = width;
    mask.height = height;
    mask.coverage.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
    return mask;
}

TEST(LabelPicture, DrawsItsMaskWithInkCorrectedForLinearLight) {
    GlyphMask mask = block(9501, 9, 5);
    for (std::size_t k = 0; k < mask.coverage.size(); ++k)
        mask.coverage[k] = static_cast<std::uint8_t>(k * 5);
    Drawing drawing = flat_drawing(40, 30, 30.0);
    Label label;
    label.mask = &mask;
    label.top_left_px = {11.0, 7.0};
    drawing.views[0].labels = {label};
    const Image image = renderer().render(drawing);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 11 && x < 20 && y >= 7 && y < 12;
            const double covered = inside ? 5.0 * ((y - 7) * 9 + x - 11) / 255.0 : 0.0;
            const double ink = covered * (1.8 - 0.8 * covered);
            EXPECT_NEAR(image.at(x, y).a, 255.0 * ink, 1.0) << x << "," << y;
        }
    }
}

// Each pixel has the colour of its tint's ink; a tint without an ink has the label's colour.
TEST(LabelPicture, DrawsWordsInTheirOwnInks) {
    GlyphMask mask = block(9503, 9, 4);
    mask.tints.assign(mask.coverage.size(), 0);
    for (std::size_t k = 0; k < mask.tints.size(); ++k)
        mask.tints[k] = static_cast<std::uint8_t>(k % 9 / 3);  // 0, 1, 2, three columns each
    Drawing drawing = flat_drawing(20, 12, 12.0);
    Label label;
    label.mask = &mask;
    label.top_left_px = {5.0, 3.0};
    label.colour = {0.0, 0.0, 0.0};
    label.inks = {{1.0, 0.0, 0.0}};
    const auto colours_of = [&] {
        drawing.views[0].labels = {label};
        const Image image = renderer().render(drawing);
        return std::array{image.at(6, 4), image.at(9, 4), image.at(12, 4)};
    };
    EXPECT_EQ(colours_of(),
              (std::array<Rgba8, 3>{{{0, 0, 0, 255}, {255, 0, 0, 255}, {0, 0, 0, 255}}}));
    label.inks = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(colours_of(),
              (std::array<Rgba8, 3>{{{0, 0, 0, 255}, {255, 0, 0, 255}, {0, 0, 255, 255}}}));
}

TEST(LabelPicture, HasAHaloThatFadesWithDistance) {
    const GlyphMask mask = block(9502, 1, 1);
    const std::vector<std::uint8_t> texels = with_halo(mask, 4.0, 5);
    const auto halo = [&](int x, int y) {
        return texels[3 * static_cast<std::size_t>(y * 11 + x) + 1];
    };
    EXPECT_EQ(halo(5, 5), 255);
    EXPECT_EQ(halo(7, 5), 255);
    EXPECT_GT(halo(8, 5), halo(9, 5));
    EXPECT_EQ(halo(10, 5), 0);
    EXPECT_EQ(halo(5, 1), halo(9, 5));
}

TEST(LabelPicture, DrawsMoreMasksThanTheTextureHolds) {
    // 300 masks of 100×100 px fill three textures of 1024² px; each mask is still drawn completely.
    std::vector<GlyphMask> masks;
    for (std::uint64_t k = 0; k < 300; ++k) masks.push_back(block(9600 + k, 100, 100));
    Drawing drawing = flat_drawing(128, 128, 128.0);
    for (const GlyphMask& mask : masks) {
        Label label;
        label.mask = &mask;
        label.top_left_px = {10.0, 12.0};
        drawing.views[0].labels = {label};
        ASSERT_NEAR(covered_px(renderer().render(drawing)), 10000.0, 1.0);
    }
    drawing.views[0].labels.clear();
    for (const GlyphMask& mask : masks) {
        Label label;
        label.mask = &mask;
        label.top_left_px = {10.0, 12.0};
        drawing.views[0].labels.push_back(label);
    }
    EXPECT_NEAR(covered_px(renderer().render(drawing)), 10000.0, 1.0);
}

TEST(LabelPicture, EqualsASeparatelyDrawnPicture) {
    // The texture previously held full masks at the positions of these labels and all around them.
    std::vector<GlyphMask> masks, letters;
    for (std::uint64_t k = 0; k < 61; ++k) masks.push_back(block(10'000 + k, 200, 60));
    for (std::uint64_t k = 0; k < 60; ++k)
        letters.push_back(block(10'100 + k, 11, 7 + static_cast<int>(k % 9)));
    const auto drawing_of = [](const GlyphMask& mask, double halo_px, double shift_px) {
        Drawing drawing = flat_drawing(40, 40, 40.0);
        Label label;
        label.mask = &mask;
        label.top_left_px = {11.0 + shift_px, 9.0 - 0.7 * shift_px};
        label.halo_px = halo_px;
        drawing.views[0].labels = {label};
        return drawing;
    };
    Renderer film(context());
    for (const GlyphMask& mask : masks) film.render(drawing_of(mask, 2.0, 0.3));
    for (std::size_t k = 0; k < letters.size(); ++k) {
        const Drawing drawing =
            drawing_of(letters[k], k % 3 == 0 ? 1.7 : 0.0, 0.0137 * static_cast<double>(k));
        Renderer alone(context());
        ASSERT_EQ(n_different(alone.render(drawing), film.render(drawing)), 0u) << k;
    }
}

// While a camera comes near, halos widen by less than a hundredth of a pixel a frame: each frame
// has its own, not that of a frame before.
TEST(LabelPicture, HasItsOwnHaloHoweverNearAnEarlierOne) {
    const GlyphMask mask = block(10'200, 9, 7);
    const auto drawing_of = [&mask](int k) {
        Drawing drawing = flat_drawing(40, 40, 40.0);
        Label label;
        label.mask = &mask;
        label.top_left_px = {14.0, 15.0};
        label.halo_px = 4.0 + 0.003 * k;
        drawing.views[0].labels = {label};
        return drawing;
    };
    Renderer film(context()), alone(context());
    for (int k = 0; k < 6; ++k) film.render(drawing_of(k));
    const Image later = film.render(drawing_of(6));
    EXPECT_EQ(n_different(alone.render(drawing_of(6)), later), 0u);
    EXPECT_GT(n_different(alone.render(drawing_of(0)), later), 0u);
}

TEST(LabelPicture, DrawsACaptionOf12000PixelsToItsEnd) {
    // A caption of a poster; its last seven columns are ink.
    constexpr int width = 12000;
    GlyphMask mask = block(9950, width, 3);
    for (std::size_t k = 0; k < mask.coverage.size(); ++k)
        mask.coverage[k] = k % width >= width - 7 ? 255 : 0;
    Drawing drawing = flat_drawing(40, 30, 30.0);
    Label label;
    label.mask = &mask;
    label.top_left_px = {20.0 - width, 7.0};
    drawing.views[0].labels = {label};
    const Image image = renderer().render(drawing);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            EXPECT_EQ(image.at(x, y).a, x >= 13 && x < 20 && y >= 7 && y < 10 ? 255 : 0)
                << x << "," << y;
}

}  // namespace
}  // namespace poinsot::testing
