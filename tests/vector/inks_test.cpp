// Inks of lines: what they make on paper, where encoded colours mix, is what light makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "vector/canvas.h"

namespace poinsot::vector {
namespace {

double level_of(double light) {
    return 255.0 *
           (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055);
}
double light_of(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
Colour grey(double c) { return {c, c, c}; }

// A share of 0.06 of the light is left of what is in full shade.
TEST(Inks, AShadeDarkensWhatElseLiesThereAsLightWould) {
    for (const double opacity : {0.1, 0.4, 0.8}) {
        const Ink ink = as_shade(grey(0.02), opacity, grey(0.9));
        for (const double other : {0.45, 0.6, 0.75, 0.9}) {
            const double light = opacity * light_of(0.02) + (1.0 - opacity) * light_of(other);
            EXPECT_NEAR(255.0 * over(ink, grey(other)).g, level_of(light), 3.0)
                << opacity << " over " << other;
        }
    }
}

struct Line {
    Line() {
        drawing.width_px = view.width_px = 1000;
        drawing.height_px = view.height_px = 750;
        view.camera.eye = {0.0, -5.0, 0.0};
        view.camera.target = {0.0, 0.0, 0.0};
        track.flow = [](double s) { return CurveFlow{{s, 0.0, 0.0}, Eigen::Vector3d::UnitX()}; };
        track.knots = {0.0, 1.0};
    }
    Drawing drawing;
    View view;
    Page page;
    Track track;
};

// From white into the dark, as from a lit plane into a shadow.
double ground(double s) { return 1.0 - 0.8 * s; }

TEST(Inks, APaleLineIsEverywhereWhatLightMakesIt) {
    Line line;
    const Canvas canvas(line.drawing, line.view, 0.24, Shading::tone, line.page);
    for (const double opacity : {0.25, 0.6, 0.95}) {
        for (const double own : {0.1, 0.5, 0.9}) {
            const auto parts = canvas.even_parts(line.track, 0.0, 1.0, [&](double s) {
                return Canvas::LineLook{grey(own), opacity, grey(ground(s))};
            });
            for (int k = 0; k <= 200; ++k) {
                const double s = k / 200.0;
                const auto part = std::find_if(parts.begin(), parts.end(),
                                               [s](const auto& p) { return s <= p.to; });
                ASSERT_NE(part, parts.end());
                EXPECT_LE(part->from, s);
                const double light =
                    opacity * light_of(own) + (1.0 - opacity) * light_of(ground(s));
                // Five levels, and the ground changes by four from sample to sample.
                EXPECT_NEAR(255.0 * over(part->ink, grey(ground(s))).g, level_of(light), 7.5)
                    << opacity << ' ' << own << " at " << s;
            }
        }
    }
}

TEST(Inks, ALineOverAnEvenGroundIsOnePart) {
    Line line;
    const Canvas canvas(line.drawing, line.view, 0.24, Shading::tone, line.page);
    const auto parts = canvas.even_parts(line.track, 0.0, 1.0, [&](double) {
        return Canvas::LineLook{grey(0.2), 0.3, grey(0.8)};
    });
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].from, 0.0);
    EXPECT_EQ(parts[0].to, 1.0);
}

}  // namespace
}  // namespace poinsot::vector
