// A curve as smooth pieces instead of points: what outlines and vectors are made from.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <span>
#include <variant>
#include <vector>

namespace poinsot {

// centre + cosine_axis·cos s + sine_axis·sin s: an ellipse, or a circle.
struct Conic {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d cosine_axis = Eigen::Vector3d::UnitX();
    Eigen::Vector3d sine_axis = Eigen::Vector3d::UnitY();

    Eigen::Vector3d at(double s) const;
};

// A cubic over from ≤ s ≤ to, by its Bézier points.
struct CubicPiece {
    double from = 0.0, to = 1.0;
    std::array<Eigen::Vector3d, 4> points{};

    Eigen::Vector3d at(double s) const;
};

// The form of a whole geometry, in its axes and lengths.
struct SmoothForm {
    // A conic for all s, or pieces that follow each other without a gap.
    std::variant<Conic, std::vector<CubicPiece>> form;
    // The s of each of the geometry's points, ascending; of a closed one also that at which its
    // first point comes again.
    std::vector<double> parameters;
    // The curve is no further than this from the form at the same s.
    double off = 0.0;

    Eigen::Vector3d at(double s) const;
    // Where a Curve's `first` or `last` cuts: points counted in fractions, clamped to those there
    // are.
    double parameter_at(double point) const;
};

// Makes the form, no further off than a tolerance in the geometry's lengths where that can be had.
using SmoothMaker = std::function<SmoothForm(double tolerance)>;

// The maker of the same form in the axes and lengths that `map` takes it to. Precondition: the
// maker makes something, and the map does not flatten everything to a point.
SmoothMaker placed(SmoothMaker maker, const Eigen::Affine3d& map);

// A point of a curve and how fast the curve runs there, per unit of s.
struct CurveFlow {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
};

// Cubics that have the curve's positions and tangents at their ends: one between every two
// neighbours of `knots` (ascending), halved until each is within `tolerance` of the curve. `off`
// receives five quarters of the largest distance found at the quarter points, where the error of
// Hermite's cubic, t²(1−t)²(x⁗ + …), is greatest or nearly so: the bound for a curve that the
// pieces resolve. At most 2^20 pieces.
std::vector<CubicPiece> cubics_through(const std::function<CurveFlow(double)>& curve,
                                       std::span<const double> knots, double tolerance,
                                       double& off);

}  // namespace poinsot
