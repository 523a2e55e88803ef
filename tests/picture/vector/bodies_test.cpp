// Shaded bodies: the colours of a smooth surface continue across the sides of its triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "random_views.h"
#include "vector/gradients.h"
#include "vector/picture.h"

namespace poinsot::vector {
namespace {

// A ball in `n` meridians and n/2 parallels, with the ball's normals.
MeshGeometry ball(int n) {
    MeshGeometry geometry;
    const auto at = [n](int i, int j) {
        const double longitude = 2.0 * std::numbers::pi * (i % n) / n;
        const double colatitude = std::numbers::pi * j / (n / 2);
        return Eigen::Vector3d(std::sin(colatitude) * std::cos(longitude),
                               std::sin(colatitude) * std::sin(longitude), std::cos(colatitude))
            .cast<float>()
            .eval();
    };
    const auto add = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                         const Eigen::Vector3f& c) {
        if ((b - a).cross(c - a).norm() < 1e-5f) return;
        geometry.positions.insert(geometry.positions.end(), {a, b, c});
        geometry.normals.insert(geometry.normals.end(), {a, b, c});
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n / 2; ++j) {
            add(at(i, j), at(i, j + 1), at(i + 1, j + 1));
            add(at(i, j), at(i + 1, j + 1), at(i + 1, j));
        }
    return geometry;
}

SheetOfPaper paper_of_body(const MeshGeometry& geometry) {
    Drawing drawing;
    drawing.width_px = drawing.height_px = 800;
    View& view = drawing.views.emplace_back();
    view.width_px = view.height_px = 800;
    drawing.background.alpha = view.background.alpha = 0.0;
    view.meshes.emplace_back().geometry = &geometry;
    return paper_of(drawing, {.pt_per_px = print_pt_per_px});
}

double largest_difference(const Colour& a, const Colour& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// The colour of a fill at a point of the paper.
Colour colour_of_fill(const Fill& fill, const Eigen::Vector2d& at) {
    if (const auto* ink = std::get_if<PaperInk>(&fill.paint)) return ink->colour;
    const auto& fade = std::get<LinearFade>(fill.paint);
    const Eigen::Vector2d run = fade.to - fade.from;
    const double t = std::clamp(run.dot(at - fade.from) / run.squaredNorm(), 0.0, 1.0);
    const Colour &a = fade.stops.front().ink.colour, &b = fade.stops.back().ink.colour;
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

std::vector<Fill> fills_of(const SheetOfPaper& paper) {
    std::vector<Fill> fills;
    for (const Item& item : paper.items)
        if (const auto* fill = std::get_if<Fill>(&item)) fills.push_back(*fill);
    return fills;
}

// Whether a path of straight lines contains a point.
bool contains(const Path& path, const Eigen::Vector2d& p) {
    bool inside = false;
    Eigen::Vector2d start = Eigen::Vector2d::Zero(), last = start;
    const auto cross_line = [&](const Eigen::Vector2d& to) {
        if ((last.y() > p.y()) != (to.y() > p.y()) &&
            p.x() < last.x() + (p.y() - last.y()) / (to.y() - last.y()) * (to.x() - last.x()))
            inside = !inside;
        last = to;
    };
    for (const Step& step : path.steps) {
        if (step.kind == Step::Kind::move)
            start = last = step.to;
        else
            cross_line(step.kind == Step::Kind::close ? start : step.to);
    }
    return inside;
}

// The fill that is visible at a point: the last one there. Null if there is none.
const Fill* seen_at(const std::vector<Fill>& fills, const Eigen::Vector2d& at) {
    const auto found = std::find_if(fills.rbegin(), fills.rend(),
                                    [&](const Fill& fill) { return contains(fill.path, at); });
    return found == fills.rend() ? nullptr : &*found;
}

// Each visible fill has the colours of its triangles' corners, so that fills agree where they meet:
// a fill of one tone for each triangle would differ by all of the change across it.
TEST(Bodies, ShadesAgreeAtSharedSides) {
    // A patch with a colour that changes in all directions.
    constexpr int n = 30;
    const auto place = [](int i, int j) { return Eigen::Vector2d(8.0 * i, 8.0 * j); };
    const auto tone = [](int i, int j) {
        const double x = (i - 0.5 * n) / n, y = (j - 0.4 * n) / n;
        const double c = 0.8 - 0.9 * x * x - 0.7 * y * y + 0.3 * x * y;
        return Colour{c, 0.8 * c, 0.5 * c};
    };
    std::vector<ShadedTriangle> triangles;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            triangles.push_back({{place(i, j), place(i + 1, j), place(i + 1, j + 1)},
                                 {tone(i, j), tone(i + 1, j), tone(i + 1, j + 1)}});
            triangles.push_back({{place(i, j), place(i + 1, j + 1), place(i, j + 1)},
                                 {tone(i, j), tone(i + 1, j + 1), tone(i, j + 1)}});
        }
    const std::vector<Fill> fills = gradient_fills(triangles, least_shade, 500);
    EXPECT_LT(fills.size(), triangles.size() / 6);
    for (const ShadedTriangle& triangle : triangles) {
        const Eigen::Vector2d middle =
            (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
        const Fill* fill = seen_at(fills, middle);
        ASSERT_NE(fill, nullptr);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LE(
                largest_difference(colour_of_fill(*fill, triangle.corners[k]), triangle.colours[k]),
                least_shade + 1e-9);
    }
}

// The picture of a coarse ball has the colours of that of a fine one, away from the outline.
TEST(Bodies, ShadesFollowTheLight) {
    const MeshGeometry coarse = ball(48), fine = ball(120);
    const std::vector<Fill> fills = fills_of(paper_of_body(coarse));
    const std::vector<Fill> reference = fills_of(paper_of_body(fine));
    EXPECT_LT(fills.size(), coarse.positions.size() / 3 / 4);
    Eigen::Vector2d low(1e9, 1e9), high = -low;
    for (const Fill& fill : fills)
        for (const Step& step : fill.path.steps)
            if (step.kind != Step::Kind::close) {
                low = low.cwiseMin(step.to);
                high = high.cwiseMax(step.to);
            }
    const Eigen::Vector2d centre = 0.5 * (low + high), size = 0.5 * (high - low);
    int n = 0;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j) {
            const Eigen::Vector2d u(i / 20.0 + 0.003, j / 20.0 + 0.007);
            if (u.norm() > 0.85) continue;
            const Eigen::Vector2d at = centre + size.cwiseProduct(u);
            const Fill *is = seen_at(fills, at), *should = seen_at(reference, at);
            ASSERT_TRUE(is != nullptr && should != nullptr);
            ++n;
            EXPECT_LT(largest_difference(colour_of_fill(*is, at), colour_of_fill(*should, at)),
                      5.0 / 255.0)
                << u.transpose();
        }
    EXPECT_GT(n, 500);
}

TEST(Bodies, AGradientFitsItsTriangles) {
    // Colours that change along x only: one fill. With a jump between two halves: two.
    std::vector<ShadedTriangle> triangles;
    const auto add = [&](double x, double step) {
        const auto tone = [&](double at) {
            const double c = 0.2 + 0.05 * at + step;
            return Colour{c, 0.5 * c, 0.1};
        };
        const Eigen::Vector2d a(x, 0.0), b(x + 1.0, 0.0), c(x + 1.0, 1.0), d(x, 1.0);
        triangles.push_back({{a, b, c}, {tone(x), tone(x + 1.0), tone(x + 1.0)}});
        triangles.push_back({{a, c, d}, {tone(x), tone(x + 1.0), tone(x)}});
    };
    for (int k = 0; k < 6; ++k) add(k, 0.0);
    EXPECT_EQ(gradient_fills(triangles, least_shade, 500).size(), 1u);
    const Fill fill = gradient_fills(triangles, least_shade, 500).front();
    EXPECT_NEAR(colour_of_fill(fill, {1.5, 0.7}).r, 0.2 + 0.05 * 1.5, 1e-9);
    EXPECT_NEAR(colour_of_fill(fill, {4.5, 0.1}).g, 0.5 * (0.2 + 0.05 * 4.5), 1e-9);
    triangles.clear();
    for (int k = 0; k < 6; ++k) add(k, k < 3 ? 0.0 : 0.2);
    EXPECT_EQ(gradient_fills(triangles, least_shade, 500).size(), 2u);
}

}  // namespace
}  // namespace poinsot::vector
