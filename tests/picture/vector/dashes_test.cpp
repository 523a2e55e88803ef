// Dashes: whole ones only, at the ends, at corners and where lines become hidden.
#include "vector/dashes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "vector/picture.h"

namespace poinsot::vector {
namespace {

// The dashes of a stroke of this length by the rule of PDF (ISO 32000-1, 8.4.3.6) and SVG: from,
// to.
std::vector<std::pair<double, double>> drawn_dashes(const std::vector<double>& lengths,
                                                    double offset, double length) {
    std::vector<std::pair<double, double>> dashes;
    double period = 0.0;
    for (const double one : lengths) period += one;
    double at = -std::fmod(offset, period);
    for (std::size_t k = 0; at < length; at += lengths[k], k = (k + 1) % lengths.size()) {
        const double from = std::max(at, 0.0), to = std::min(at + lengths[k], length);
        if (k % 2 != 0 || to - from < 1e-9) continue;
        if (!dashes.empty() && from - dashes.back().second < 1e-9)
            dashes.back().second = to;
        else
            dashes.emplace_back(from, to);
    }
    return dashes;
}

TEST(Dashes, AreWholeAndEndAsAsked) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int k = 0; k < 500; ++k) {
        const Dash wanted{0.5 + 5.0 * part(random), 0.5 + 3.0 * part(random)};
        const double length = (2.0 + 40.0 * part(random)) * wanted.on_pt;
        const DashEnd begin = k % 2 == 0 ? DashEnd::dash : DashEnd::gap;
        const DashEnd end = k % 3 == 0 ? DashEnd::dash : DashEnd::gap;
        const DashPattern pattern = dashes_along(wanted, {{length}}, begin, end);
        const auto dashes = drawn_dashes(pattern.lengths_pt, pattern.offset_pt, length);
        ASSERT_FALSE(dashes.empty());
        const double on = pattern.lengths_pt[0], off = pattern.lengths_pt[1];
        EXPECT_NEAR(on / off, wanted.on_pt / wanted.off_pt, 1e-9);
        for (const auto& [from, to] : dashes) EXPECT_NEAR(to - from, on, 1e-7) << k;
        EXPECT_NEAR(dashes.front().first, begin == DashEnd::dash ? 0.0 : off, 1e-7) << k;
        EXPECT_NEAR(dashes.back().second, length - (end == DashEnd::dash ? 0.0 : off), 1e-7) << k;
        // The nearest number of dashes: half a period more or less on all of them together.
        const double n = static_cast<double>(dashes.size());
        if (n > 2.0) {
            EXPECT_NEAR(on / wanted.on_pt, 1.0, 0.5 / (n - 1.0)) << k;
        }
    }
}

TEST(Dashes, OnClosedLinesAreAWholeNumber) {
    for (const double length : {3.0, 10.0, 77.7}) {
        const Dash dash = fitted_dash({2.0, 1.0}, length);
        const double n = length / (dash.on_pt + dash.off_pt);
        EXPECT_NEAR(n, std::round(length / 3.0), 1e-9);
        EXPECT_NEAR(dash.on_pt, 2.0 * dash.off_pt, 1e-12);
    }
}

TEST(Dashes, MeetAtCorners) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int k = 0; k < 200; ++k) {
        const std::vector<double> pieces{6.0 + 30.0 * part(random), 6.0 + 30.0 * part(random),
                                         6.0 + 30.0 * part(random)};
        const DashEnd begin = k % 2 == 0 ? DashEnd::dash : DashEnd::gap;
        const DashEnd end = k % 3 == 0 ? DashEnd::dash : DashEnd::gap;
        const Dash wanted{3.0, 1.5};
        const DashPattern pattern = dashes_along(wanted, pieces, begin, end);
        const double length = pieces[0] + pieces[1] + pieces[2];
        const auto dashes = drawn_dashes(pattern.lengths_pt, pattern.offset_pt, length);
        for (const double corner : {pieces[0], pieces[0] + pieces[1]}) {
            // A dash extends to both sides of the corner by a whole dash.
            const bool covered = std::any_of(dashes.begin(), dashes.end(), [&](const auto& dash) {
                return dash.first < corner - 0.6 * wanted.on_pt &&
                       dash.second > corner + 0.6 * wanted.on_pt;
            });
            EXPECT_TRUE(covered) << k;
        }
        EXPECT_NEAR(dashes.front().first > 1e-7, begin == DashEnd::gap, 0.0) << k;
        EXPECT_NEAR(dashes.back().second < length - 1e-7, end == DashEnd::gap, 0.0) << k;
    }
}

View flat_view() {
    View view;
    view.width_px = 1000;
    view.height_px = 1000;
    view.camera.eye = {0.0, 0.0, 10.0};
    view.camera.up = Eigen::Vector3d::UnitY();
    view.camera.orthographic = true;
    view.camera.height_units = 4.0;
    return view;
}

TEST(Dashes, LengthsOnPaperAreThoseOfEllipses) {
    const Projection projection(flat_view(), 0.24);
    const double pt_per_unit = 240.0 / 4.0;
    for (const double flattening : {1.0, 0.6, 0.1}) {
        const Conic ellipse{{}, {1.0, 0.0, 0.0}, {0.0, flattening, 0.3}};
        const Track track = track_of(ellipse, 0.0, 2.0 * std::numbers::pi);
        // The perimeter is 4 E(k).
        const double k = std::sqrt(1.0 - flattening * flattening);
        EXPECT_NEAR(length_on_paper(projection, track, 0.0, 2.0 * std::numbers::pi),
                    4.0 * std::comp_ellint_2(k) * pt_per_unit, 2e-3);
    }
}

// The strokes of a view.
std::vector<Stroke> strokes_of(const View& view) {
    Drawing drawing;
    drawing.width_px = view.width_px;
    drawing.height_px = view.height_px;
    drawing.views.push_back(view);
    const SheetOfPaper paper = paper_of(drawing, {.pt_per_px = 0.24, .shading = Shading::none});
    std::vector<Stroke> strokes;
    for (const Item& item : paper.items)
        if (const auto* stroke = std::get_if<Stroke>(&item);
            stroke != nullptr && stroke->width_pt > 0.0)
            strokes.push_back(*stroke);
    return strokes;
}

// A line along x at a height, between −1.5 and 1.5.
struct LevelLine {
    explicit LevelLine(double z) {
        geometry.points = {{-1.5, 0.0, z}, {1.5, 0.0, z}};
        curve.geometry = &geometry;
        curve.colour = {0.8, 0.1, 0.1};
        curve.width_px = 8.0;
        curve.hidden = HiddenStyle::dashed;
        curve.hidden_opacity = 1.0;
    }
    CurveGeometry geometry;
    Curve curve;
};

TEST(Dashes, BeginAndEndInGapsWhereTheLineGoesOn) {
    View view = flat_view();
    Ellipsoid& sphere = view.ellipsoids.emplace_back();
    sphere.section_px = sphere.ruling_px = 0.0;
    sphere.opacity = 1.0;
    const LevelLine line(-1.2);
    view.curves.push_back(line.curve);
    std::vector<Stroke> strokes = strokes_of(view);
    ASSERT_EQ(strokes.size(), 4u);
    strokes.erase(strokes.begin());  // the sphere's contour
    EXPECT_TRUE(strokes[0].dashes_pt.empty());
    EXPECT_TRUE(strokes[2].dashes_pt.empty());
    ASSERT_EQ(strokes[1].dashes_pt.size(), 2u);
    // Behind the sphere's outline the line is 2 units long, 120 points.
    const auto dashes = drawn_dashes(strokes[1].dashes_pt, strokes[1].dash_offset_pt, 120.0);
    EXPECT_NEAR(dashes.front().first, strokes[1].dashes_pt[1], 1e-6);
    EXPECT_NEAR(dashes.back().second, 120.0 - strokes[1].dashes_pt[1], 1e-6);
    EXPECT_LT(strokes[1].width_pt, strokes[0].width_pt);
    EXPECT_GT(strokes[1].dashes_pt[0], 2.0 * strokes[1].width_pt);
}

TEST(Dashes, AreShorterOnShortCurves) {
    View view = flat_view();
    Ellipsoid& sphere = view.ellipsoids.emplace_back();
    sphere.section_px = sphere.ruling_px = 0.0;
    sphere.opacity = 1.0;
    LevelLine line(-1.2);
    const auto dash_of_scaled = [&](double scale) {
        line.curve.placement.linear() = Eigen::Vector3d(scale, 1.0, 1.0).asDiagonal();
        view.curves = {line.curve};
        const std::vector<Stroke> strokes = strokes_of(view);
        return strokes.at(strokes.size() / 2).dashes_pt.at(0);
    };
    EXPECT_LT(dash_of_scaled(0.3), 0.8 * dash_of_scaled(1.0));
}

TEST(Dashes, APlaneHidesNothing) {
    View view = flat_view();
    Plane& plane = view.planes.emplace_back();
    plane.opacity = 0.9;
    plane.grid_px = 0.0;
    const LevelLine line(-1.2);
    view.curves.push_back(line.curve);
    view.curves.back().hidden = HiddenStyle::absent;
    Arrow& arrow = view.arrows.emplace_back();
    arrow.tail = {-1.0, 0.5, -0.5};
    arrow.tip = {1.0, 0.5, -0.5};
    arrow.colour = {0.1, 0.2, 0.7};
    arrow.shaft_px = 4.0;
    arrow.head_px = 16.0;
    arrow.head_length_px = 26.0;
    arrow.hidden_opacity = -1.0;
    for (const HiddenStyle hidden : {HiddenStyle::dashed, HiddenStyle::absent}) {
        view.curves.back().hidden = hidden;
        const std::vector<Stroke> strokes = strokes_of(view);
        ASSERT_FALSE(strokes.empty());
        for (const Stroke& stroke : strokes) {
            EXPECT_TRUE(stroke.dashes_pt.empty());
            EXPECT_GT(stroke.ink.alpha, 0.5);
        }
    }
    Drawing drawing;
    drawing.width_px = drawing.height_px = 1000;
    drawing.views.push_back(view);
    const SheetOfPaper paper = paper_of(drawing, {.pt_per_px = 0.24, .shading = Shading::none});
    int n_fills = 0;
    for (const Item& item : paper.items)
        if (const auto* fill = std::get_if<Fill>(&item))
            if (const auto* ink = std::get_if<PaperInk>(&fill->paint);
                ink != nullptr && ink->colour == arrow.colour) {
                ++n_fills;
                EXPECT_GT(ink->alpha, 0.5);
            }
    EXPECT_GE(n_fills, 2);  // shaft and head
}

}  // namespace
}  // namespace poinsot::vector
