// A curve as smooth pieces instead of points, for outlines and vector output.
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

// A cubic on from ≤ s ≤ to, by its Bézier points.
struct CubicPiece {
    double from = 0.0, to = 1.0;
    std::array<Eigen::Vector3d, 4> points{};

    Eigen::Vector3d at(double s) const;
};

// The smooth form of a geometry, in the geometry's axes and lengths.
struct SmoothForm {
    // A conic for all s, or contiguous pieces.
    std::variant<Conic, std::vector<CubicPiece>> form;
    // The s of each of the geometry's points, ascending; for a closed geometry also the s at which
    // the first point is reached again.
    std::vector<double> parameters;
    // The largest distance of curve and form at the same s.
    double off = 0.0;

    Eigen::Vector3d at(double s) const;
    // The s of a Curve's `first` or `last`: fractional points, clamped to the existing ones.
    double parameter_at(double point) const;
};

// Makes the form within a tolerance, in the geometry's lengths, if that is possible.
using SmoothMaker = std::function<SmoothForm(double tolerance)>;

// A maker of the same form mapped by `map`. Precondition: `maker` is not empty, and the map does
// not collapse everything to a point.
SmoothMaker placed(SmoothMaker maker, const Eigen::Affine3d& map);

// A point of a curve and its velocity, per unit of s.
struct CurveFlow {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
};

// Cubics with the curve's positions and tangents at their ends: one between each two neighbours of
// `knots` (ascending), halved until each is within `tolerance` of the curve. `off` receives 5/4 of
// the largest distance found at the quarter points, where the error of the Hermite cubic,
// t²(1−t)²(x⁗ + …), is largest or nearly so; this is a bound for a curve that the pieces resolve.
// Makes at most 2^20 pieces.
std::vector<CubicPiece> cubics_through(const std::function<CurveFlow(double)>& curve,
                                       std::span<const double> knots, double tolerance,
                                       double& off);

}  // namespace poinsot
