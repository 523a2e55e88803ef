// Strokes: width, uniformity, range and occlusion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pictures.h"

namespace poinsot::testing {
namespace {

Curve stroke(const CurveGeometry& geometry, double width_px) {
    Curve curve;
    curve.geometry = &geometry;
    curve.width_px = width_px;
    curve.colour = {0.0, 0.0, 0.0};
    return curve;
}

Image picture_of(const Curve& curve, int side_px = 100) {
    Drawing drawing = flat_drawing(side_px, side_px, side_px);
    drawing.views[0].curves.push_back(curve);
    return renderer().render(drawing);
}

TEST(CurvePicture, AreaIsLengthTimesWidthPlusCaps) {
    const CurveGeometry line = curve_of(9101, 7, false, [](double t) {
        return Eigen::Vector3d(-30.0 + 60.0 * t, -11.0 + 20.0 * t, 0.0);
    });
    const double length = std::hypot(60.0, 20.0);
    for (const double width : {0.4, 1.0, 3.0, 9.5}) {
        const double expected = length * width + std::numbers::pi * width * width / 4.0;
        // A hairline's profile is a ramp of one pixel: measured 2.1 % at 1 px, 0.6 % from 3 px on.
        EXPECT_NEAR(covered_px(picture_of(stroke(line, width))), expected,
                    (width < 3.0 ? 0.03 : 0.01) * expected)
            << width;
    }
}

TEST(CurvePicture, HasUniformOpacityAtJoins) {
    // Gentle and sharp turns, a hairpin and a crossing.
    const CurveGeometry zigzag = curve_of(9102, 6, false, [](double t) {
        const int k = static_cast<int>(std::lround(5.0 * t));
        return Eigen::Vector3d(-30.0 + 12.0 * k, k % 2 == 0 ? -20.0 : 20.0, 0.0);
    });
    const CurveGeometry arc = circle(9103, 25.0, 0.0, 40);
    for (const CurveGeometry* geometry : {&zigzag, &arc}) {
        Curve curve = stroke(*geometry, 8.0);
        curve.opacity = 0.4;
        const Image image = picture_of(curve);
        int highest = 0, n_full = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                highest = std::max<int>(highest, image.at(x, y).a);
                n_full += std::abs(image.at(x, y).a - 102) <= 1;
            }
        }
        EXPECT_LE(highest, 103);
        EXPECT_GT(n_full, 800);
    }
}

TEST(CurvePicture, ShowsAFractionalRange) {
    const CurveGeometry line = curve_of(
        9104, 11, false, [](double t) { return Eigen::Vector3d(-40.0 + 80.0 * t, 0.25, 0.0); });
    Curve curve = stroke(line, 4.0);
    curve.first = 2.25;
    curve.last = 6.75;
    const Image image = picture_of(curve);
    // From x = -22 to x = 14, with caps of radius 2.
    EXPECT_NEAR(middle_of(image).x(), 50.0 - 4.0, 0.02);
    EXPECT_NEAR(covered_px(image), 36.0 * 4.0 + 4.0 * std::numbers::pi, 1.0);
    curve.first = 7.0;
    EXPECT_EQ(covered_px(picture_of(curve)), 0.0);
}

TEST(CurvePicture, FadesTowardsItsBeginning) {
    const CurveGeometry line = curve_of(
        9105, 81, false, [](double t) { return Eigen::Vector3d(-40.0 + 80.0 * t, 0.5, 0.0); });
    Curve curve = stroke(line, 6.0);
    curve.fade_points = 80.0;
    const Image image = picture_of(curve);
    for (const int x : {20, 50, 80})
        EXPECT_NEAR(alpha_at(image, x, 49), (x + 0.5 - 10.0) / 80.0, 0.01) << x;
}

TEST(CurvePicture, DashesFillHalfOfAClosedCurve) {
    const CurveGeometry ring = circle(9106, 30.0, 0.0);
    Curve curve = stroke(ring, 4.0);
    const double solid = covered_px(picture_of(curve));
    curve.dash_px = 7.0;
    EXPECT_NEAR(covered_px(picture_of(curve)) / solid, 0.5, 0.01);
}

TEST(CurvePicture, IsHiddenExactlyBehindTheLimb) {
    // A great circle on a sphere, turned about x by 60°: its front half is below (towards +z).
    const double tilt = std::numbers::pi / 3.0;
    const CurveGeometry ring = curve_of(9107, 400, true, [=](double t) {
        const double angle = 2.0 * std::numbers::pi * t;
        return Eigen::Vector3d(40.0 * std::cos(angle), 40.0 * std::sin(angle) * std::cos(tilt),
                               40.0 * std::sin(angle) * std::sin(tilt));
    });
    Drawing drawing = flat_drawing(100, 100, 100.0);
    View& view = drawing.views[0];
    Ellipsoid sphere = plain_ellipsoid(40.0 * Eigen::Matrix3d::Identity());
    sphere.colour = {1.0, 1.0, 1.0};
    view.ellipsoids.push_back(sphere);
    Curve curve = stroke(ring, 3.0);
    curve.on_surface = 0;
    curve.hidden = HiddenStyle::absent;
    view.curves.push_back(curve);
    const Image with = renderer().render(drawing);
    view.curves.clear();
    const Image without = renderer().render(drawing);
    // Wherever the curve was drawn, its depth is above that of the limb, except in one or two
    // pixels where it crosses.
    double darkest_behind = 0.0, lightest_before = 1.0;
    for (int k = 0; k < 400; ++k) {
        const Eigen::Vector3d& p = ring.points[static_cast<std::size_t>(k)];
        const int x = static_cast<int>(std::floor(50.0 + p.x()));
        const int y = static_cast<int>(std::floor(50.0 - p.y()));
        const double dark = 1.0 - static_cast<double>(with.at(x, y).g) / without.at(x, y).g;
        if (p.z() < -6.0) darkest_behind = std::max(darkest_behind, dark);
        if (p.z() > 6.0) lightest_before = std::min(lightest_before, dark);
    }
    EXPECT_EQ(darkest_behind, 0.0);
    EXPECT_GT(lightest_before, 0.7);
}

// A sphere as clear as glass hides little of a curve behind it, but the far parts of its own curves
// if it is told to.
TEST(CurvePicture, ClearSphereHidesTheFarPartsOfItsCurves) {
    // The lower half of a circle in a plane that is tilted by 30° lies on the front.
    const CurveGeometry ring = curve_of(9131, 400, true, [](double t) {
        const double angle = 2.0 * std::numbers::pi * t, tilt = std::numbers::pi / 6.0;
        return Eigen::Vector3d(40.0 * std::cos(angle), -40.0 * std::sin(angle) * std::cos(tilt),
                               40.0 * std::sin(angle) * std::sin(tilt));
    });
    const auto far_share = [&](bool hides) {
        Drawing drawing = flat_drawing(100, 100, 100.0);
        View& view = drawing.views[0];
        Ellipsoid sphere = plain_ellipsoid(40.0 * Eigen::Matrix3d::Identity());
        sphere.opacity = 0.1;
        sphere.hides_far_curves = hides;
        view.ellipsoids.push_back(sphere);
        Curve curve = stroke(ring, 6.0);
        curve.on_surface = 0;
        curve.hidden_opacity = 0.4;
        view.curves.push_back(curve);
        const Image with = renderer().render(drawing);
        view.curves.clear();
        const Image without = renderer().render(drawing);
        const auto darkness = [&](double y) {
            const int row = static_cast<int>(50.0 - y);
            return 1.0 - static_cast<double>(with.at(50, row).g) / without.at(50, row).g;
        };
        const double high = 40.0 * std::cos(std::numbers::pi / 6.0);
        return darkness(high) / darkness(-high);
    };
    EXPECT_GT(far_share(false), 0.9);
    EXPECT_LT(far_share(true), 0.75);
}

TEST(CurvePicture, IsDimmedInsideAndBehindAnEllipsoidAndAPlane) {
    Drawing drawing = flat_drawing(100, 100, 100.0);
    View& view = drawing.views[0];
    view.background.alpha = drawing.background.alpha = 1.0;
    view.background.top = view.background.bottom = {1.0, 1.0, 1.0};
    Ellipsoid sphere = plain_ellipsoid(30.0 * Eigen::Matrix3d::Identity());
    view.ellipsoids.push_back(sphere);
    const CurveGeometry inside = curve_of(
        9108, 2, false, [](double t) { return Eigen::Vector3d(-45.0 + 90.0 * t, 0.0, 0.0); });
    const CurveGeometry before = curve_of(
        9109, 2, false, [](double t) { return Eigen::Vector3d(-45.0 + 90.0 * t, 10.0, 35.0); });
    const Image bare = renderer().render(drawing);
    for (const CurveGeometry* geometry : {&inside, &before}) {
        Curve curve = stroke(*geometry, 5.0);
        curve.hidden_opacity = 0.25;
        view.curves = {curve};
        const Image image = renderer().render(drawing);
        const int y = geometry == &inside ? 50 : 40;
        const auto dark = [&](int x) {
            // In linear light: encoded values have approximately the power 1/2.2.
            return 1.0 - std::pow(static_cast<double>(image.at(x, y).g) / bare.at(x, y).g, 2.2);
        };
        EXPECT_NEAR(dark(10), 1.0, 0.02);
        EXPECT_NEAR(dark(50), geometry == &inside ? 0.25 : 1.0, 0.03);
    }
}

// As in PDF and SVG: behind a plane of opacity 0.6 alone, a line whose hidden parts are dashed or
// omitted is solid, and 0.4 + 0.6 · 0.75 = 0.85 of it is seen; a pale one is dimmed to its hidden
// opacity.
TEST(CurvePicture, PlanesAreGlassWhereHiddenLinesAreDashedOrOmitted) {
    const CurveGeometry line = curve_of(
        9121, 2, false, [](double t) { return Eigen::Vector3d(-40.0 + 80.0 * t, 0.0, -5.0); });
    Plane plane;
    plane.normal = Eigen::Vector3d::UnitZ();
    plane.centre = {0.0, 0.0, 0.0};
    plane.radius = 1000.0;
    plane.grid_px = 0.0;
    plane.opacity = 0.6;
    plane.colour = {1.0, 1.0, 1.0};
    const auto darkness_along = [&](HiddenStyle hidden) {
        Drawing drawing = flat_drawing(100, 100, 100.0);
        View& view = drawing.views[0];
        view.background.alpha = drawing.background.alpha = 1.0;
        view.background.top = view.background.bottom = {1.0, 1.0, 1.0};
        view.planes.push_back(plane);
        const Image without = renderer().render(drawing);
        Curve curve = stroke(line, 5.0);
        curve.hidden = hidden;
        curve.hidden_opacity = 0.3;
        view.curves.push_back(curve);
        const Image with = renderer().render(drawing);
        // Light in proportion to what the black line leaves.
        std::vector<double> found;
        for (int x = 15; x < 85; ++x) {
            const auto light = [x](const Image& image) {
                return std::pow(image.at(x, 50).g / 255.0, 2.2);
            };
            found.push_back(1.0 - light(with) / light(without));
        }
        return found;
    };
    for (const HiddenStyle style : {HiddenStyle::dashed, HiddenStyle::absent})
        for (const double dark : darkness_along(style)) EXPECT_NEAR(dark, 0.85, 0.03);
    for (const double dark : darkness_along(HiddenStyle::dimmed)) EXPECT_LT(dark, 0.75);
}

TEST(CurvePicture, NeedsNoUploadIfOnlyItsRangeChanges) {
    // Different points with the same id count as the same geometry, which shows that it was cached.
    CurveGeometry line = curve_of(
        9110, 2, false, [](double t) { return Eigen::Vector3d(-40.0 + 80.0 * t, 0.0, 0.0); });
    const Image first = picture_of(stroke(line, 3.0));
    line.points[1].y() = 40.0;
    EXPECT_EQ(picture_of(stroke(line, 3.0)), first);
}

TEST(CurvePicture, SurvivesPointsBehindTheEye) {
    const CurveGeometry line = curve_of(9111, 9, false, [](double t) {
        return Eigen::Vector3d(3.2 * (4.0 * t - 2.0), -4.6 * (4.0 * t - 2.0), 1.0);
    });
    const CurveGeometry none = circle(9112, 1.0, -0.8);
    Drawing drawing = lecture_drawing(200, 120, line, none);
    drawing.views[0].curves[0].on_surface = -1;
    const Image image = renderer().render(drawing);
    drawing.views[0].curves.erase(drawing.views[0].curves.begin());
    const Image without = renderer().render(drawing);
    // The line is visible, and only as a line: it covers a small part of the picture.
    const std::size_t n = n_different(image, without);
    EXPECT_GT(n, 20u);
    EXPECT_LT(n, 2000u);
}

}  // namespace
}  // namespace poinsot::testing
