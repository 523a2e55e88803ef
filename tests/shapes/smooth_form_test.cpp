// Smooth forms are as near to their curves as they say, and parts of them are parts of them.
#include "shapes/smooth_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace poinsot {
namespace {

using std::numbers::pi;

// A helix on a cone: no conic, and with derivatives of every order.
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

TEST(SmoothForm, IsWithinItsBoundAndItsBoundWithinTheTolerance) {
    const std::vector<double> knots{0.0, 0.7, 2.0};
    for (const double tolerance : {1e-2, 1e-4, 1e-8, 1e-11}) {
        SmoothForm smooth;
        smooth.form = cubics_through(spiral, knots, tolerance, smooth.off);
        EXPECT_LE(smooth.off, tolerance);
        EXPECT_LE(worst_distance(smooth, 0.0, 2.0, spiral), smooth.off) << tolerance;
    }
}

// The error falls as the fourth power of a piece's length, so its number as the fourth root.
TEST(SmoothForm, TakesAsManyPiecesAsTheFourthRootOfTheTolerance) {
    const std::vector<double> knots{0.0, 2.0};
    double off = 0.0;
    const std::size_t coarse = cubics_through(spiral, knots, 1e-4, off).size();
    const std::size_t fine = cubics_through(spiral, knots, 1e-8, off).size();
    EXPECT_NEAR(static_cast<double>(fine) / static_cast<double>(coarse), 10.0, 3.0);
}

TEST(SmoothForm, PiecesJoinWithOneTangent) {
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

TEST(SmoothForm, APartOfAPieceIsThePieceThere) {
    const CubicPiece piece{1.0, 3.0, {{{0, 0, 0}, {1, 2, 0}, {3, -1, 2}, {4, 0, 1}}}};
    const CubicPiece part = piece.part(1.3, 2.2);
    EXPECT_EQ(part.from, 1.3);
    EXPECT_EQ(part.to, 2.2);
    for (const double s : {1.3, 1.5, 1.9, 2.2}) EXPECT_LT((part.at(s) - piece.at(s)).norm(), 4e-15);
}

// A point of a Bézier arc is off the circle by how far its distance from the middle is off 1.
TEST(SmoothForm, ArcsAreWithinTheToleranceOfTheConic) {
    SmoothForm smooth;
    smooth.form = Conic{{1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    for (const double tolerance : {1e-2, 1e-5, 1e-10}) {
        const auto arcs = cubics_between(smooth, -1.0, 4.5, tolerance);
        EXPECT_EQ(arcs.front().from, -1.0);
        EXPECT_EQ(arcs.back().to, 4.5);
        double worst = 0.0;
        for (const CubicPiece& arc : arcs) {
            for (int k = 0; k <= 1000; ++k) {
                const double s = arc.from + (arc.to - arc.from) * k / 1000.0;
                const Eigen::Vector3d at = arc.at(s) - Eigen::Vector3d(1.0, 2.0, 3.0);
                worst = std::max(worst, std::abs(at.norm() - 1.0));
                EXPECT_LT(std::abs(at.x()), 1e-15);  // four roundings of 1
            }
        }
        EXPECT_LE(worst, tolerance);
    }
    // Rough enough, no arc is longer than a quarter turn.
    EXPECT_EQ(cubics_between(smooth, 0.0, 2.0 * pi, 1.0).size(), 4u);
}

TEST(SmoothForm, BetweenTwoParametersIsTheFormThere) {
    const std::vector<double> knots{0.0, 1.0, 2.0};
    SmoothForm smooth;
    smooth.form = cubics_through(spiral, knots, 1e-6, smooth.off);
    const auto cut = cubics_between(smooth, 0.25, 1.77, 1e-6);
    EXPECT_EQ(cut.front().from, 0.25);
    EXPECT_EQ(cut.back().to, 1.77);
    for (const CubicPiece& piece : cut) {
        const double middle = 0.5 * (piece.from + piece.to);
        EXPECT_LT((piece.at(middle) - smooth.at(middle)).norm(), 1e-14);
    }
    EXPECT_TRUE(cubics_between(smooth, 1.0, 1.0, 1e-6).empty());
}

TEST(SmoothForm, CountsPointsInFractionsAsCurvesDo) {
    SmoothForm smooth;
    smooth.parameters = {0.0, 1.0, 4.0};
    EXPECT_EQ(smooth.parameter_at(-1.0), 0.0);
    EXPECT_EQ(smooth.parameter_at(0.5), 0.5);
    EXPECT_EQ(smooth.parameter_at(1.5), 2.5);
    EXPECT_EQ(smooth.parameter_at(1e300), 4.0);
}

}  // namespace
}  // namespace poinsot
