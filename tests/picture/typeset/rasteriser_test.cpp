// The rasteriser's coverage equals the area, compared with closed forms.
#include "typeset/rasteriser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace poinsot::rasteriser_tests {
namespace {

using Kind = OutlineStep::Kind;

GlyphOutline polygon(const std::vector<OutlinePoint>& corners) {
    std::vector<OutlineStep> steps;
    for (const OutlinePoint& corner : corners) {
        steps.push_back({steps.empty() ? Kind::move : Kind::line, {}, {}, corner});
    }
    return make_outline(std::move(steps));
}

// Four cubics around a circle, anticlockwise, with the usual constant.
GlyphOutline round(double radius) {
    const double k = 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0) * radius;
    const double r = radius;
    return make_outline({{Kind::move, {}, {}, {r, 0}},
                         {Kind::cubic, {r, k}, {k, r}, {0, r}},
                         {Kind::cubic, {-k, r}, {-r, k}, {-r, 0}},
                         {Kind::cubic, {-r, -k}, {-k, -r}, {0, -r}},
                         {Kind::cubic, {k, -r}, {r, -k}, {r, 0}}});
}

// ∮ x dy of a cubic segment, exact: products of Bernstein polynomials have rational integrals.
double cubic_area(OutlinePoint a, OutlinePoint b, OutlinePoint c, OutlinePoint d) {
    const double x[] = {a.x, b.x, c.x, d.x};
    const double dy[] = {3 * (b.y - a.y), 3 * (c.y - b.y), 3 * (d.y - c.y)};
    const double choose3[] = {1, 3, 3, 1}, choose2[] = {1, 2, 1};
    const double choose5[] = {1, 5, 10, 10, 5, 1};
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 3; ++j) {
            sum += x[i] * dy[j] * choose3[i] * choose2[j] / choose5[i + j] / 6.0;
        }
    }
    return sum;
}

double area(const GlyphOutline& outline) {
    double sum = 0.0;
    OutlinePoint start, at;
    const auto line = [](OutlinePoint p, OutlinePoint q) {
        return 0.5 * (p.x + q.x) * (q.y - p.y);
    };
    for (const OutlineStep& step : outline.steps) {
        if (step.kind == Kind::move) {
            sum += line(at, start);
            start = step.to;
        } else if (step.kind == Kind::line) {
            sum += line(at, step.to);
        } else {
            sum += cubic_area(at, step.control_1, step.control_2, step.to);
        }
        at = step.to;
    }
    return sum + line(at, start);
}

double total(const std::vector<double>& coverage) {
    return std::accumulate(coverage.begin(), coverage.end(), 0.0);
}

std::vector<double> covered(const GlyphOutline& outline, double x, double y, double scale,
                            int width, int height) {
    Rasteriser rasteriser(width, 0, height);
    rasteriser.add(outline, x, y, scale);
    return rasteriser.coverage();
}

TEST(Rasteriser, RectangleCoversExactlyItsArea) {
    Rasteriser rasteriser(8, 0, 6);
    rasteriser.add_rectangle(1.25, 0.5, 6.75, 4.125);
    const std::vector<double> coverage = rasteriser.coverage();
    const double column[] = {0, 0.75, 1, 1, 1, 1, 0.75, 0};
    const double row[] = {0.5, 1, 1, 1, 0.125, 0};
    for (std::size_t y = 0; y < 6; ++y) {
        for (std::size_t x = 0; x < 8; ++x) EXPECT_EQ(coverage[8 * y + x], column[x] * row[y]);
    }
}

TEST(Rasteriser, TriangleCoverageAgreesWithHandCalculation) {
    // Below the diagonal of a 2×2 square: half of each diagonal pixel, all of one pixel.
    const auto coverage = covered(polygon({{0, 0}, {2, 0}, {0, 2}}), 0, 2, 1, 2, 2);
    EXPECT_DOUBLE_EQ(coverage[0], 0.5);
    EXPECT_DOUBLE_EQ(coverage[1], 0.0);
    EXPECT_DOUBLE_EQ(coverage[2], 1.0);
    EXPECT_DOUBLE_EQ(coverage[3], 0.5);
    // A shallow edge, y = x/4 over one row: coverages 1/8, 3/8, 5/8, 7/8.
    const auto shallow = covered(polygon({{0, 0}, {4, 0}, {4, 1}}), 0, 1, 1, 4, 1);
    for (std::size_t x = 0; x < 4; ++x) EXPECT_DOUBLE_EQ(shallow[x], (2.0 * double(x) + 1.0) / 8.0);
}

TEST(Rasteriser, RandomTrianglesHaveExactArea) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> at(0.0, 64.0);
    for (int i = 0; i < 1000; ++i) {
        const auto shape =
            polygon({{at(random), at(random)}, {at(random), at(random)}, {at(random), at(random)}});
        // Only rounding errors; measured 1.4e-12 of at most 2048.
        EXPECT_NEAR(total(covered(shape, 0, 64, 1, 64, 64)), std::abs(area(shape)), 5e-12);
    }
}

TEST(Rasteriser, CircleAreaIsPiRSquared) {
    // A polygon of 4096 corners loses 2π³r²/(3·4096²) = 1.2e-6 r²; the radius is 30.
    std::vector<OutlinePoint> corners;
    constexpr int n = 4096;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        corners.push_back({30.0 * std::cos(angle), 30.0 * std::sin(angle)});
    }
    const double expected = 0.5 * n * std::sin(2.0 * std::numbers::pi / n) * 900.0;
    EXPECT_NEAR(total(covered(polygon(corners), 32.3, 31.8, 1, 64, 64)), expected,
                1e-11);  // measured 5e-13
    EXPECT_NEAR(expected, std::numbers::pi * 900.0, 2e-6 * 900.0);
}

TEST(Rasteriser, CurvedShapesHaveTheirAreaAtEverySize) {
    // Chords deviate by at most 0.002 px, so that a circle loses at most two thirds of that along
    // its circumference 2πr; total areas agree to 1e-4 unless the circle is tiny.
    for (const double radius : {0.4, 1.0, 5.0, 30.0, 200.0}) {
        const GlyphOutline shape = round(radius);
        const int side = static_cast<int>(2.0 * radius) + 3;
        const double sum =
            total(covered(shape, side / 2.0 + 0.21, side / 2.0 - 0.37, 1, side, side));
        EXPECT_NEAR(sum, area(shape), 2.0 / 3.0 * 0.002 * 2.0 * std::numbers::pi * radius)
            << radius;
        if (radius >= 30.0) {
            EXPECT_NEAR(sum / area(shape), 1.0, 1e-4) << radius;  // measured 8e-5 at 30
        }
    }
}

TEST(Rasteriser, MirroredOutlineGivesMirroredMask) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> at(0.0, 20.0);
    for (int i = 0; i < 100; ++i) {
        const auto p = [&] { return OutlinePoint{at(random), at(random)}; };
        const GlyphOutline shape = make_outline({{Kind::move, {}, {}, p()},
                                                 {Kind::cubic, p(), p(), p()},
                                                 {Kind::line, {}, {}, p()},
                                                 {Kind::cubic, p(), p(), p()}});
        GlyphOutline mirrored = shape;
        for (OutlineStep& step : mirrored.steps) {
            for (OutlinePoint* q : {&step.control_1, &step.control_2, &step.to}) q->x = 20.0 - q->x;
        }
        const auto a = covered(shape, 0, 20, 1, 20, 20);
        const auto b = covered(make_outline(mirrored.steps), 0, 20, 1, 20, 20);
        for (std::size_t y = 0; y < 20; ++y) {
            for (std::size_t x = 0; x < 20; ++x) {
                EXPECT_NEAR(a[20 * y + x], b[20 * y + 19 - x], 1e-13);  // measured 5e-15
            }
        }
    }
}

TEST(Rasteriser, ShiftByWholePixelsShiftsTheMask) {
    const GlyphOutline shape = round(4.25);
    const auto a = covered(shape, 6.25, 6.5, 1, 20, 20);
    const auto b = covered(shape, 9.25, 11.5, 1, 20, 20);
    for (std::size_t y = 0; y < 15; ++y) {
        for (std::size_t x = 0; x < 17; ++x) {
            EXPECT_NEAR(a[20 * y + x], b[20 * (y + 5) + x + 3], 1e-13);
        }
    }
}

TEST(Rasteriser, OverlapsCountOnceAndHolesStayOpen) {
    Rasteriser twice(10, 0, 10);
    twice.add_rectangle(1, 1, 7, 7);
    twice.add_rectangle(3, 3, 9, 9);
    EXPECT_DOUBLE_EQ(total(twice.coverage()), 36.0 + 36.0 - 16.0);

    // The inner square has the opposite direction.
    const GlyphOutline ring = make_outline({{Kind::move, {}, {}, {0, 0}},
                                            {Kind::line, {}, {}, {6, 0}},
                                            {Kind::line, {}, {}, {6, 6}},
                                            {Kind::line, {}, {}, {0, 6}},
                                            {Kind::move, {}, {}, {2, 2}},
                                            {Kind::line, {}, {}, {2, 4}},
                                            {Kind::line, {}, {}, {4, 4}},
                                            {Kind::line, {}, {}, {4, 2}}});
    EXPECT_DOUBLE_EQ(total(covered(ring, 1, 7, 1, 8, 8)), 32.0);
}

TEST(Rasteriser, BandsOfRowsEqualTheWhole) {
    const GlyphOutline shape = round(20.0);
    std::vector<std::uint8_t> whole(50 * 50), banded(50 * 50);
    Rasteriser all(50, 0, 50);
    all.add(shape, 25.3, 24.8, 1);
    all.write(whole.data());
    for (int first = 0; first < 50; first += 7) {
        Rasteriser band(50, first, std::min(7, 50 - first));
        band.add(shape, 25.3, 24.8, 1);
        band.write(banded.data() + 50 * static_cast<std::size_t>(first));
    }
    EXPECT_EQ(whole, banded);
}

}  // namespace
}  // namespace poinsot::rasteriser_tests
