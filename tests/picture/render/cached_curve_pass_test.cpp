// Lasting curves: the bytes of film frames, and a cost independent of the curve's length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "pictures.h"

namespace poinsot::testing {
namespace {

// Open loops on the plane of lecture_drawing, 40 points per turn.
const CurveGeometry& history() {
    static const CurveGeometry curve = curve_of(9301, 100'001, false, [](double t) {
        const double angle = 2.0 * std::numbers::pi * 2500.0 * t;
        const double r = 0.6 + 0.25 * std::cos(1.618034 * angle);
        return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), -0.8);
    });
    return curve;
}

const CurveGeometry& polhode() {
    static const CurveGeometry curve = circle(9302, 0.6, 0.5);
    return curve;
}

Drawing frame_of(double last, bool dashed = false) {
    Drawing drawing = lecture_drawing(320, 180, polhode(), history());
    Curve& curve = drawing.views[0].curves[1];
    curve.lasting = true;
    curve.last = last;
    if (dashed) curve.dash_px = 6.0;
    return drawing;
}

::testing::AssertionResult is_drawn_as_alone(Renderer& film, const Drawing& drawing) {
    const Image picture = film.render(drawing);
    Renderer alone(context());
    const std::size_t n = n_different(alone.render(drawing), picture);
    if (n == 0) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << n << " pixels differ";
}

// The largest difference of any component, in levels.
int largest_difference(const Image& a, const Image& b) {
    int largest = 0;
    for (std::size_t k = 0; k < a.bytes().size(); ++k)
        largest = std::max(largest, std::abs(a.bytes()[k] - b.bytes()[k]));
    return largest;
}

TEST(CachedCurve, EqualsASeparatelyDrawnPicture) {
    for (const bool dashed : {false, true}) {
        Renderer film(context());
        // Forwards inside a segment and over many, at a whole point, and back to before it was
        // cached.
        for (const double last :
             {0.0, 0.4, 3.0, 3.5, 40.25, 40.5, 300.0, 300.75, 120.5, 121.0, 0.2})
            EXPECT_TRUE(is_drawn_as_alone(film, frame_of(last, dashed))) << last << " " << dashed;
    }
}

TEST(CachedCurve, IsUpdatedAtEveryChangeOfItsInputs) {
    Renderer film(context());
    Drawing drawing = frame_of(200.5);
    const auto again = [&](const char* what) {
        // The second picture may cache content that the third uses.
        for (int k = 0; k < 3; ++k) {
            drawing.views[0].curves[1].last += 0.3;
            EXPECT_TRUE(is_drawn_as_alone(film, drawing)) << what << " " << k;
        }
    };
    again("first");
    Curve& curve = drawing.views[0].curves[1];
    curve.opacity = 0.5;
    again("opacity");
    curve.colour = {0.0, 0.5, 0.0};
    again("colour");
    curve.width_px = 1.5;
    again("width");
    curve.placement.translation() = Eigen::Vector3d(0.1, 0.0, 0.0);
    again("placement");
    curve.first = 20.5;
    again("first point");
    drawing.views[0].ellipsoids[0].centre = {0.3, -0.5, 0.1};
    again("what hides it");
    drawing.views[0].planes[0].opacity = 0.2;
    again("plane");
    drawing.views[0].camera.eye = {2.0, -4.0, 2.5};
    again("camera");
    drawing.views[0].curves.pop_back();
    again("gone");
}

TEST(CachedCurve, IsKeptBetweenMovingObjects) {
    // Two moving dots with the curve between them, for all widths of the gap.
    const CurveGeometry line = curve_of(
        9304, 40, false, [](double t) { return Eigen::Vector3d(-60.0 + 120.0 * t, 0.3, 0.0); });
    for (int gap_px = 20; gap_px <= 110; gap_px += 15) {
        Renderer film(context());
        for (int k = 0; k < 4; ++k) {
            Drawing drawing = flat_drawing(256, 128, 128.0);
            Curve curve;
            curve.geometry = &line;
            curve.lasting = true;
            drawing.views[0].curves.push_back(curve);
            for (const double side : {-0.5, 0.5}) {
                Dot dot;
                dot.at = {side * gap_px, 0.5 * k, 0.0};
                drawing.views[0].dots.push_back(dot);
            }
            EXPECT_TRUE(is_drawn_as_alone(film, drawing)) << gap_px << " " << k;
        }
    }
}

TEST(CachedCurve, LooksLikeARedrawnCurve) {
    // Where the curve meets itself, the cached curve has the larger coverage; redrawn, both blend.
    Drawing drawing = frame_of(38.5);
    const Image kept = renderer().render(drawing);
    drawing.views[0].curves[1].lasting = false;
    const Image drawn_anew = renderer().render(drawing);
    EXPECT_LE(largest_difference(drawn_anew, kept), 6);  // measured: 4 levels, 5 pixels
    EXPECT_LE(n_different(drawn_anew, kept), 12u);
}

TEST(CachedCurve, CostDoesNotDependOnItsLength) {
    Renderer film(context());
    std::vector<PictureCounts> counts;
    for (const double last : {400.0, 100'000.0 - 20.0}) {
        for (int k = 0; k < 4; ++k) film.render(frame_of(last + 2.0 * k));
        counts.push_back(film.counts());
    }
    for (const PictureCounts& count : counts) {
        EXPECT_EQ(count.n_lasting_segments, 2);
        EXPECT_EQ(count.n_points_uploaded, 0);
    }
    // Only the tiles of the ellipsoid, the arrows and the curve's end are redrawn.
    EXPECT_LE(counts[1].n_tiles, counts[0].n_tiles + 1);
}

TEST(CachedCurve, IsCachedOnEllipsoidsAndInFlatViews) {
    const CurveGeometry rising = curve_of(9303, 500, false, [](double t) {
        const double angle = 2.0 * std::numbers::pi * 2.0 * t, z = 0.3 + 0.4 * t;
        const double r = std::sqrt(1.0 - z * z);
        return Eigen::Vector3d(40.0 * r * std::cos(angle), 40.0 * r * std::sin(angle), 40.0 * z);
    });
    Drawing drawing = flat_drawing(128, 128, 100.0);
    Ellipsoid sphere = plain_ellipsoid(40.0 * Eigen::Matrix3d::Identity());
    sphere.opacity = 0.6;
    drawing.views[0].ellipsoids.push_back(sphere);
    drawing.views[0].camera.eye = {0.0, 10.0, 6.0};
    drawing.views[0].camera.up = {0.0, 0.0, 1.0};
    Curve curve;
    curve.geometry = &rising;
    curve.on_surface = 0;
    curve.lasting = true;
    drawing.views[0].curves.push_back(curve);
    Renderer film(context());
    for (const bool occluded : {true, false}) {
        drawing.views[0].curves[0].occlusion = occluded ? Occlusion::by_solids : Occlusion::none;
        for (int k = 1; k < 6; ++k) {
            drawing.views[0].curves[0].last = 70.3 * k;
            EXPECT_TRUE(is_drawn_as_alone(film, drawing)) << k;
        }
        const Image kept = film.render(drawing);
        Drawing anew = drawing;
        anew.views[0].curves[0].lasting = false;
        // Measured: 10 levels and 20 pixels, and 3 levels and 18 pixels.
        const Image drawn_anew = renderer().render(anew);
        EXPECT_LE(largest_difference(drawn_anew, kept), 12);
        EXPECT_LE(n_different(drawn_anew, kept), 30u);
    }
}

}  // namespace
}  // namespace poinsot::testing
