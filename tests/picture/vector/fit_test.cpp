// Béziers fitted to curves on paper.
#include "vector/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "random_views.h"

namespace poinsot::vector {
namespace {

// The largest distance of the Béziers from the curve, sampled densely on both.
double worst_distance(const std::function<PaperFlow(double)>& curve, double from, double to,
                      const std::vector<Bezier>& beziers) {
    std::vector<Eigen::Vector2d> line;
    constexpr int n = 200'000;
    for (int k = 0; k <= n; ++k) line.push_back(curve(from + (to - from) * k / n).position);
    double worst = 0.0;
    std::size_t near = 0;
    for (const Bezier& bezier : beziers) {
        for (int k = 0; k <= 64; ++k) {
            const Eigen::Vector2d p = at(bezier, k / 64.0);
            while (near + 1 < line.size() &&
                   (line[near + 1] - p).squaredNorm() <= (line[near] - p).squaredNorm())
                ++near;
            // The component perpendicular to the tangent at the nearest sample is the distance.
            const std::size_t other = near + 1 < line.size() ? near + 1 : near - 1;
            const Eigen::Vector2d run = (line[other] - line[near]).normalized();
            const Eigen::Vector2d off = p - line[near];
            worst = std::max(worst, std::abs(run.x() * off.y() - run.y() * off.x()));
        }
    }
    return worst;
}

PaperFlow spiral(double s) {
    const double r = 40.0 + 6.0 * s;
    return {{r * std::cos(s), r * std::sin(s)},
            {6.0 * std::cos(s) - r * std::sin(s), 6.0 * std::sin(s) + r * std::cos(s)}};
}

// A projected herpolhode: loops with varying curvature.
PaperFlow rosette(double s) {
    const double r = 60.0 + 15.0 * std::cos(3.7 * s), dr = -55.5 * std::sin(3.7 * s);
    return {{r * std::cos(s), 0.4 * r * std::sin(s)},
            {dr * std::cos(s) - r * std::sin(s), 0.4 * (dr * std::sin(s) + r * std::cos(s))}};
}

TEST(Fit, StaysWithinItsToleranceAndItsBound) {
    for (const auto& curve : {spiral, rosette}) {
        for (const double tolerance_um : {100.0, 10.0, 1.5, 0.1}) {
            const double tolerance_pt = tolerance_um / um(1.0);
            const std::vector<double> knots{0.0, 1.0, 4.0, 9.0};
            const Fit fit = fitted(curve, knots, tolerance_pt);
            EXPECT_LE(fit.off_pt, tolerance_pt);
            EXPECT_LE(worst_distance(curve, 0.0, 9.0, fit.beziers), fit.off_pt + 1e-7)
                << tolerance_um << " um";
        }
    }
}

// The error of the best handles falls with the sixth power of the length (de Boor, Höllig & Sabin
// 1987), so the number of Béziers grows with the sixth root of the accuracy, in steps due to
// halving.
TEST(Fit, NeedsFewBeziers) {
    const std::vector<double> knots{0.0, 9.0};
    const std::size_t coarse = fitted(rosette, knots, 64.0 / um(1.0)).beziers.size();
    const std::size_t fine = fitted(rosette, knots, 1.0 / um(1.0)).beziers.size();
    EXPECT_LE(fine, 3 * coarse);
    EXPECT_LE(fine, 64u);
}

TEST(Fit, JoinsSmoothlyAndKeepsCorners) {
    const auto corner = [](double s) {
        return s < 1.0 ? PaperFlow{{10.0 * s, 0.0}, {10.0, 0.0}}
                       : PaperFlow{{10.0, 10.0 * (s - 1.0)}, {0.0, 10.0}};
    };
    const Fit bent = fitted(corner, std::vector<double>{0.0, 1.0, 2.0}, 1e-4);
    ASSERT_EQ(bent.beziers.size(), 2u);
    EXPECT_NEAR((bent.beziers[0][3] - Eigen::Vector2d(10.0, 0.0)).norm(), 0.0, 1e-7);
    const Fit smooth = fitted(rosette, std::vector<double>{0.0, 2.0, 5.0}, 1e-3);
    for (std::size_t k = 1; k < smooth.beziers.size(); ++k) {
        const Bezier &before = smooth.beziers[k - 1], &after = smooth.beziers[k];
        EXPECT_LT((before[3] - after[0]).norm(), 1e-9);
        const Eigen::Vector2d arriving = (before[3] - before[2]).normalized();
        const Eigen::Vector2d leaving = (after[1] - after[0]).normalized();
        EXPECT_NEAR(arriving.dot(leaving), 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace poinsot::vector
