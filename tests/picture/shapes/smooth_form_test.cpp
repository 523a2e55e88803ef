// Smooth forms are within their stated deviation of the curve.
#include "shapes/smooth_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace poinsot {
namespace {

// A helix on a cone: not a conic, and with derivatives of every order.
CurveFlow spiral(double s) {
    return {{s * std::cos(3.0 * s), s * std::sin(3.0 * s), std::exp(-s)},
            {std::cos(3.0 * s) - 3.0 * s * std::sin(3.0 * s),
             std::sin(3.0 * s) + 3.0 * s * std::cos(3.0 * s), -std::exp(-s)}};
}

double worst_distance(const SmoothForm& smooth, double first, double last,
                      const std::function<CurveFlow(double)>& curve) {
    double worst = 0.0;
    for (int k = 0; k <= 20'000; ++k) {
        const double s = first + (last - first) * k / 20'000.0;
        worst = std::max(worst, (smooth.at(s) - curve(s).position).norm());
    }
    return worst;
}

TEST(SmoothForm, ErrorIsWithinBoundAndTolerance) {
    const std::vector<double> knots{0.0, 0.7, 2.0};
    for (const double tolerance : {1e-2, 1e-4, 1e-8, 1e-11}) {
        SmoothForm smooth;
        smooth.form = cubics_through(spiral, knots, tolerance, smooth.off);
        EXPECT_LE(smooth.off, tolerance);
        EXPECT_LE(worst_distance(smooth, 0.0, 2.0, spiral), smooth.off) << tolerance;
    }
}

// The error is of fourth order in a piece's length, so the number of pieces grows with the fourth
// root.
TEST(SmoothForm, NumberOfPiecesFollowsTheFourthRootOfTheTolerance) {
    const std::vector<double> knots{0.0, 2.0};
    double off = 0.0;
    const std::size_t coarse = cubics_through(spiral, knots, 1e-4, off).size();
    const std::size_t fine = cubics_through(spiral, knots, 1e-8, off).size();
    EXPECT_NEAR(static_cast<double>(fine) / static_cast<double>(coarse), 10.0, 3.0);
}

TEST(SmoothForm, PiecesJoinSmoothly) {
    const std::vector<double> knots{0.0, 0.7, 2.0};
    double off = 0.0;
    const auto pieces = cubics_through(spiral, knots, 1e-5, off);
    ASSERT_GT(pieces.size(), 3u);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const CubicPiece &before = pieces[i - 1], &after = pieces[i];
        EXPECT_EQ(before.to, after.from);
        EXPECT_EQ(before.points[3], after.points[0]);
        const Eigen::Vector3d arriving = (before.points[3] - before.points[2]).normalized();
        const Eigen::Vector3d leaving = (after.points[1] - after.points[0]).normalized();
        EXPECT_LT((arriving - leaving).norm(), 1e-12);
    }
}

TEST(SmoothForm, AcceptsFractionalPoints) {
    SmoothForm smooth;
    smooth.parameters = {0.0, 1.0, 4.0};
    EXPECT_EQ(smooth.parameter_at(-1.0), 0.0);
    EXPECT_EQ(smooth.parameter_at(0.5), 0.5);
    EXPECT_EQ(smooth.parameter_at(1.5), 2.5);
    EXPECT_EQ(smooth.parameter_at(1e300), 4.0);
}

}  // namespace
}  // namespace poinsot
