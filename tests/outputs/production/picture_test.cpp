// Pictures: drawn in parts, transparent, with 16 bits, and with text at its final size for any
// number of samples per pixel.
#include "production/stills/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "drawing/scenes_by_hand.h"
#include "numerics/srgb.h"
#include "render/pictures.h"
#include "shapes/crop.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::testing {
namespace {

// A picture such as the default scene's, with text over it.
StagedScene staged(const std::string& theme, int width_px, int height_px, double line_scale = 0.0) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.5, 0.3, 0.75}, "space");
    scene.title = "A title";
    scene.caption = "A caption of some words and $\\omega_1$.";
    scene.theme = theme;
    scene.camera.target = Eigen::Vector3d(0.0, 0.0, 0.2);
    scene.film.width_px = width_px;
    scene.film.height_px = height_px;
    return StagedScene(scene, 6.0, line_scale);
}

struct Difference {
    int largest = 0;
    int n_pixels = 0;
    int n_over_a_level = 0;
    std::array<int, 2> at{};  // of the largest difference
};
Difference difference_of(const Image& a, const Image& b) {
    Difference difference;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const Rgba8 p = a.at(x, y), q = b.at(x, y);
            // Colours are weighted with their opacity.
            const auto seen = [&](int c, int d) { return std::abs(c * p.a - d * q.a) / 255; };
            const int off =
                std::max({seen(p.r, q.r), seen(p.g, q.g), seen(p.b, q.b), std::abs(p.a - q.a)});
            if (off > difference.largest) difference.at = {x, y};
            difference.largest = std::max(difference.largest, off);
            difference.n_pixels += off > 0;
            difference.n_over_a_level += off > 1;
        }
    }
    return difference;
}

TEST(Parts, AreIdenticalToTheWholePicture) {
    const OffscreenContext context;
    Renderer renderer(context);
    for (const char* theme : {"light", "transparent"}) {
        const StagedScene scene = staged(theme, 960, 544);
        const Drawing whole = scene.stage.at(5.0);
        const Image at_once = renderer.render(whole);
        Image pieced(960, 544);
        for (int y = 0; y < 544; y += 160) {
            for (int x = 0; x < 960; x += 352) {
                const PixelArea area{x, y, std::min(352, 960 - x), std::min(160, 544 - y)};
                const Image part = renderer.render(cropped(whole, area));
                for (int v = 0; v < area.height_px; ++v)
                    for (int u = 0; u < area.width_px; ++u) pieced.set(x + u, y + v, part.at(u, v));
            }
        }
        const Difference difference = difference_of(at_once, pieced);
        // Coordinates relative to another corner are rounded differently. Measured: 1 level in 38
        // of 522,240 pixels.
        RecordProperty(std::string(theme) + "_largest", difference.largest);
        RecordProperty(std::string(theme) + "_pixels", difference.n_pixels);
        EXPECT_LE(difference.largest, 2)
            << theme << " at " << difference.at[0] << ", " << difference.at[1];
        EXPECT_LE(difference.n_over_a_level, 1) << theme;
        EXPECT_LT(difference.n_pixels, 200) << theme;
    }
}

TEST(Parts, SplitLongMasksWithoutASeam) {
    const OffscreenContext context;
    Renderer renderer(context);
    // A mask wider than the picture, with a checkered pattern.
    GlyphMask mask;
    mask.id = 77001;
    mask.width = 3000;
    mask.height = 20;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 3000; ++x) mask.coverage.push_back((x / 7 + y / 5) % 2 == 0 ? 255 : 0);
    Drawing whole = flat_drawing(1024, 64, 64.0);
    Label label;
    label.mask = &mask;
    label.top_left_px = {-1000.0, 20.0};
    label.halo_px = 3.0;
    whole.views[0].labels.push_back(label);
    const Image at_once = renderer.render(whole);
    for (int x = 0; x < 1024; x += 256) {
        const Image part = renderer.render(cropped(whole, {x, 0, 256, 64}));
        for (int v = 0; v < 64; ++v)
            for (int u = 0; u < 256; ++u)
                ASSERT_EQ(part.at(u, v), at_once.at(x + u, v)) << x + u << " " << v;
    }
}

// A straight-alpha colour composited over a background in linear light.
double over(std::uint8_t colour, std::uint8_t alpha, double ground) {
    const double a = alpha / 255.0;
    return 255.0 * srgb_from_linear(a * linear_from_srgb(colour / 255.0) +
                                    (1.0 - a) * linear_from_srgb(ground));
}

TEST(TransparentPicture, CompositedOverABackgroundEqualsThePictureDrawnOnIt) {
    const OffscreenContext context;
    Renderer renderer(context);
    const StagedScene scene = staged("transparent", 640, 360);
    Drawing drawing = scene.stage.at(5.0);
    const Image picture = renderer.render(drawing);
    int n_translucent = 0;
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 640; ++x) {
            const int a = picture.at(x, y).a;
            n_translucent += a > 0 && a < 255;
        }
    EXPECT_GT(n_translucent, 20000);
    for (const double ground : {0.0, 0.5, 1.0}) {
        drawing.background.alpha = 1.0;
        drawing.background.top = drawing.background.bottom = {ground, ground, ground};
        drawing.views[0].background = drawing.background;
        const Image on_ground = renderer.render(drawing);
        double worst = 0.0, sum = 0.0;
        for (int y = 0; y < 360; ++y) {
            for (int x = 0; x < 640; ++x) {
                const Rgba8 p = picture.at(x, y);
                const double off = std::abs(over(p.g, p.a, ground) - on_ground.at(x, y).g);
                // On black, 8 bits of alpha are coarse: a level of 255 in linear light is 13 levels
                // of a dark colour. There only the sum is compared.
                if (ground > 0.0) worst = std::max(worst, off);
                sum += off;
            }
        }
        // Both are dithered by half a level and alpha is rounded. Premultiplied colours would be
        // too dark by most of the light of a half-covered pixel.
        EXPECT_LE(worst, 3.0) << ground;
        EXPECT_LT(sum / (640.0 * 360.0), 0.8) << ground;
    }
}

TEST(DeepPicture, AgreesWithEightBitsAndHasMoreLevels) {
    const OffscreenContext context;
    Renderer renderer(context);
    Drawing drawing;
    drawing.width_px = 64;
    drawing.height_px = 2048;
    drawing.background.top = {0.50, 0.50, 0.50};
    drawing.background.bottom = {0.54, 0.54, 0.54};
    const Image shallow = renderer.render(drawing);
    DeepImage deep;
    renderer.render_into(drawing, deep);
    int n_levels = 0;
    int before = -1;
    for (int y = 0; y < 2048; ++y) {
        const int level = deep.samples()[4u * 64u * static_cast<std::size_t>(y)];
        n_levels += level != before;
        before = level;
        EXPECT_EQ(deep.samples()[4u * 64u * static_cast<std::size_t>(y) + 3u], 65535);
        // A dithered level differs by less than one from the exact value.
        EXPECT_LT(std::abs(level / 257.0 - shallow.at(0, y).g), 1.0) << y;
    }
    // 0.04 of the range in 2048 rows is 1.28 levels of 65535 per row: nearly every row has a
    // different level.
    EXPECT_GT(n_levels, 1500);
}

// The mean square of the difference in linear light, over the edges' pixels.
TEST(WholePicture, HasSmootherEdgesThanFourSamplesPerPixel) {
    const OffscreenContext context;
    Renderer renderer(context);
    constexpr int width = 480, height = 270, n = 8;
    const StagedScene small = staged("light", width, height);
    const StagedScene large = staged("light", n * width, n * height, n * height / 1080.0);
    Drawing one = small.stage.at(5.0);
    Drawing many = large.stage.at(5.0);
    // Without text, which is set for its size and is not an edge of the geometry, and without
    // contours, which are a pixel wide in small pictures, too.
    for (Drawing* drawing : {&one, &many})
        for (View& view : drawing->views) {
            view.labels.clear();
            for (Ellipsoid& ellipsoid : view.ellipsoids) ellipsoid.contour_px = 0.0;
        }
    const Image analytic = renderer.render(one);
    const Image fine = renderer.render(many);

    const auto linear = [](int level) { return linear_from_srgb(level / 255.0); };
    // The usual positions of four samples in a pixel of 8 × 8.
    constexpr std::array<std::array<int, 2>, 4> places{{{3, 1}, {7, 3}, {1, 5}, {5, 7}}};
    double of_analytic = 0.0, of_samples = 0.0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double mean = 0.0, four = 0.0;
            for (int v = 0; v < n; ++v)
                for (int u = 0; u < n; ++u)
                    mean += linear(fine.at(n * x + u, n * y + v).g) / (n * n);
            for (const auto& [u, v] : places)
                four += 0.25 * linear(fine.at(n * x + u, n * y + v).g);
            of_analytic += std::pow(linear(analytic.at(x, y).g) - mean, 2);
            of_samples += std::pow(four - mean, 2);
        }
    }
    RecordProperty("analytic", std::to_string(of_analytic));
    RecordProperty("four_samples", std::to_string(of_samples));
    EXPECT_LT(of_analytic, of_samples);  // measured 7.3 and 20.3
}

constexpr int width_px = 640, height_px = 352;

// Title, caption and clock, names in the picture, numbers and names of a chart.
Session session_with_type(const std::string& theme) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.5, 0.3, 0.75}, "space");
    scene.title = "A title";
    scene.caption = "A caption of some words and $\\omega_1$.";
    scene.theme = theme;
    PanelSpec chart;
    chart.kind = "plot";
    chart.column = 1;
    scene.panels.push_back(chart);
    scene.grid.columns = {1.0, 1.0};
    scene.film.width_px = width_px;
    scene.film.height_px = height_px;
    return session_of(scene, {installed_fonts()});
}

// The text of a scene's picture alone, with this number of samples per side of a pixel.
class TypeAlone {
 public:
    TypeAlone(const std::string& theme, int samples)
        : session_(session_with_type(theme)),
          maker_(session_, context_, {.last_time_s = 6.0}, {.samples = samples}),
          drawing_(maker_.stage().at(5.0)) {
        for (View& view : drawing_.views) {
            view.planes.clear();
            view.ellipsoids.clear();
            view.curves.clear();
            view.arrows.clear();
            view.dots.clear();
        }
    }
    void clear() {
        for (View& view : drawing_.views) view.labels.clear();
    }
    template <typename Picture>
    Picture drawn(const PixelArea& area = {0, 0, width_px, height_px}) {
        Picture picture;
        maker_.draw_part(drawing_, area, picture);
        return picture;
    }

 private:
    Session session_;
    OffscreenContext context_;
    PictureMaker maker_;
    Drawing drawing_;
};

// The text's contribution to its background, summed over all components, of 65,535 levels each.
double ink_of(const std::string& theme, int samples) {
    TypeAlone type(theme, samples);
    const DeepImage with = type.drawn<DeepImage>();
    type.clear();
    const DeepImage without = type.drawn<DeepImage>();
    double sum = 0.0;
    for (std::size_t k = 0; k < with.samples().size(); ++k)
        sum += std::abs(1.0 * with.samples()[k] - without.samples()[k]);
    return sum;
}

TEST(TypeWeight, DoesNotDependOnTheNumberOfSamples) {
    for (const char* theme : {"light", "dark"}) {
        const double ink = ink_of(theme, 1);
        ASSERT_GT(ink, 1e7);
        for (const int samples : {2, 3, 4})
            EXPECT_NEAR(ink_of(theme, samples) / ink, 1.0, 1e-3) << theme << " " << samples;
    }
}

TEST(TypeWeight, IsEqualInEveryPixel) {
    for (const char* theme : {"light", "transparent"}) {
        const Image one = TypeAlone(theme, 1).drawn<Image>();
        for (const int samples : {2, 3, 4}) {
            const Image more = TypeAlone(theme, samples).drawn<Image>();
            int largest = 0;
            for (int y = 0; y < height_px; ++y) {
                for (int x = 0; x < width_px; ++x) {
                    // Straight alpha: colours are weighted with their opacity.
                    const Rgba8 p = one.at(x, y), q = more.at(x, y);
                    const auto seen = [&](int c, int d) {
                        return std::abs(c * p.a - d * q.a) / 255;
                    };
                    largest = std::max({largest, seen(p.r, q.r), seen(p.g, q.g), seen(p.b, q.b),
                                        std::abs(p.a - q.a)});
                }
            }
            EXPECT_LE(largest, 1) << theme << " " << samples;
        }
    }
}

TEST(TypeWeight, IsEqualInParts) {
    for (const int samples : {2, 3}) {
        TypeAlone type("light", samples);
        const Image whole = type.drawn<Image>();
        for (int y = 0; y < height_px; y += 96) {
            for (int x = 0; x < width_px; x += 160) {
                const PixelArea area{x, y, 160, std::min(96, height_px - y)};
                const Image part = type.drawn<Image>(area);
                for (int v = 0; v < area.height_px; ++v)
                    for (int u = 0; u < area.width_px; ++u)
                        ASSERT_EQ(part.at(u, v), whole.at(x + u, y + v)) << x + u << "," << y + v;
            }
        }
    }
}

}  // namespace
}  // namespace poinsot::testing
