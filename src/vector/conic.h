// Conics on paper: outlines of ellipsoids and pictures of circles, exactly.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "vector/fit.h"
#include "vector/occluders.h"

namespace poinsot::vector {

// centre + a cos t + b sin t, points on paper.
struct PaperEllipse {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d a = Eigen::Vector2d::UnitX(), b = Eigen::Vector2d::UnitY();

    Eigen::Vector2d at(double t) const;
    // From axes in which it is the unit circle.
    Eigen::Affine2d page_from_circle() const;
    // Less than 1 inside, 1 on it.
    double radius_of(const Eigen::Vector2d& point) const;
};

// What a conic of the view looks like: an ellipse again, if all of it is before the eye and it is
// not seen edge-on.
std::optional<PaperEllipse> picture_of(const Conic& conic, const Projection& projection);

// The circle, on an ellipsoid, along which lines of sight touch it; none if the eye is inside.
std::optional<Conic> limb_of(const SphereSight& sphere);

// All of an ellipse as Béziers whose ends lie on it and have its tangents, no further from it than
// `tolerance_pt`; `off_pt` grows to the bound of their distance: for a circle of radius 1 and an
// arc θ it is (4/27)·sin⁶(θ/4)/cos²(θ/4), and an affine map of it stretches distances by no more
// than the ellipse's longest half axis.
std::vector<Bezier> beziers_of(const PaperEllipse& ellipse, double tolerance_pt, double& off_pt);

// A conic, or the part of one from one parameter to another, to be seen.
Track track_of(const Conic& conic, double first, double last);

}  // namespace poinsot::vector
