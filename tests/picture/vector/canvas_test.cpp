// Inks of lines: on paper, where encoded colours blend, they give the colours of blended light.
#include "vector/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "vector/passes/ellipsoid.h"

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

// In full shade a share of 0.06 of the light is left.
TEST(Inks, ShadesDarkenOtherColoursAsInLight) {
    for (const double opacity : {0.1, 0.4, 0.8}) {
        const PaperInk ink = as_shade(grey(0.02), opacity, grey(0.9));
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
    SheetOfPaper paper;
    Track track;
};

// From white to dark, as from a lit plane into a shadow.
double ground(double s) { return 1.0 - 0.8 * s; }

TEST(Inks, TranslucentLinesHaveTheColourOfBlendedLight) {
    Line line;
    const Canvas canvas(line.drawing, line.view, 0.24, Shading::tone, line.paper);
    for (const double opacity : {0.25, 0.6, 0.95}) {
        for (const double own : {0.1, 0.5, 0.9}) {
            const auto parts = canvas.constant_colour_spans(line.track, 0.0, 1.0, [&](double s) {
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
                // Six levels, plus half the change of the background between samples, which is four
                // levels.
                EXPECT_NEAR(255.0 * over(part->ink, grey(ground(s))).g, level_of(light), 7.5)
                    << opacity << ' ' << own << " at " << s;
            }
        }
    }
}

TEST(Inks, LineOverAUniformBackgroundIsOneSpan) {
    Line line;
    const Canvas canvas(line.drawing, line.view, 0.24, Shading::tone, line.paper);
    const auto parts = canvas.constant_colour_spans(line.track, 0.0, 1.0, [&](double) {
        return Canvas::LineLook{grey(0.2), 0.3, grey(0.8)};
    });
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].from, 0.0);
    EXPECT_EQ(parts[0].to, 1.0);
}

TEST(Inks, FittedInkIsExactIfOneExists) {
    const PaperInk ink{{0.7, 0.3, 0.5}, 0.4};
    std::vector<ColourOver> places;
    for (const double g : {0.2, 0.5, 0.6, 0.95}) places.push_back({over(ink, grey(g)), grey(g)});
    const PaperInk found = ink_for(places);
    EXPECT_NEAR(found.alpha, ink.alpha, 1e-12);
    EXPECT_NEAR(found.colour.r, ink.colour.r, 1e-12);
    EXPECT_NEAR(found.colour.g, ink.colour.g, 1e-12);
    EXPECT_NEAR(found.colour.b, ink.colour.b, 1e-12);
}

TEST(Inks, FittedInkOverOneBackgroundGivesTheMean) {
    const std::vector<ColourOver> places{{{0.1, 0.9, 0.4}, grey(0.8)},
                                         {{0.3, 0.7, 0.6}, grey(0.8)}};
    const Colour made = over(ink_for(places), grey(0.8));
    EXPECT_NEAR(made.r, 0.2, 1e-12);
    EXPECT_NEAR(made.g, 0.8, 1e-12);
    EXPECT_NEAR(made.b, 0.5, 1e-12);
}

// A glass sphere, and a point of a body behind it, inside it and in front of it.
TEST(Inks, BodyUnderSheetsLooksAsSeenThroughTheSurfaces) {
    Line glass;
    Ellipsoid sphere;
    sphere.half_axes = Eigen::Matrix3d::Identity();
    sphere.opacity = 0.15;
    glass.view.ellipsoids.push_back(sphere);
    Canvas canvas(glass.drawing, glass.view, 0.24, Shading::tone, glass.paper);
    light_sheets(canvas, {0});
    ASSERT_EQ(canvas.sheets.size(), 1u);
    const ShadedDisc& disc = canvas.sheets[0].disc;
    const Colour body = grey(0.6);
    const auto seen = [&](double y) {
        const Eigen::Vector3d point(0.1, y, 0.2);
        const Eigen::Vector2d in_disc =
            disc.paper_from_disc.inverse() * canvas.projection.place(point);
        return over(PaperInk{disc.at(in_disc), disc.alpha}, under_sheets(canvas, point, body));
    };
    EXPECT_NEAR(seen(-2.0).g, body.g, 1e-9);
    // With the normal towards the eye, the surface has its nominal opacity. A point inside has one
    // surface in front of it, a point behind has both.
    const Layer front = outer_surface(sphere, canvas.lights,
                                      {-Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitY()}, 0.0);
    const double in_light = front.alpha * front.light.y() + (1.0 - front.alpha) * light_of(body.g);
    EXPECT_NEAR(255.0 * seen(0.0).g, level_of(in_light), 4.0);
    EXPECT_GT(std::abs(seen(2.0).g - seen(0.0).g), 0.01);
}

// Seen from the equator of the third axis: meridians are apart by the step of their longitudes,
// times the cosine of the longitude from the middle.
TEST(Projection, RulingSpacingIsTheProjectedOne) {
    View view;
    view.width_px = view.height_px = 1000;
    view.camera.eye = {0.0, -5.0, 0.0};
    view.camera.orthographic = true;
    const Projection projection(view, 0.24);
    const double unit_px = projection.scale(5.0) / 0.24;
    constexpr double step = 0.3;
    for (const double longitude : {0.0, 0.5, 1.2, 1.5}) {
        const Eigen::Vector3d at(std::sin(longitude), -std::cos(longitude), 0.0);
        const Eigen::Vector3d east(std::cos(longitude), std::sin(longitude), 0.0);
        EXPECT_NEAR(spacing_px(projection, at, Eigen::Vector3d::UnitZ(), step * east),
                    step * unit_px * std::cos(longitude), 1e-9 * unit_px);
    }
}

}  // namespace
}  // namespace poinsot::vector
