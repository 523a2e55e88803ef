// Text is drawn at the final size, for any number of samples per pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "drawing/scenes_by_hand.h"
#include "production/jobs/picture.h"
#include "render/pictures.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::testing {
namespace {

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
