// Conics on paper: exact outlines of ellipsoids and exact projections of circles.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "vector/fit.h"
#include "vector/occluders.h"

namespace poinsot::vector {

// The ellipse centre + a cos t + b sin t on paper.
struct PaperEllipse {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d a = Eigen::Vector2d::UnitX(), b = Eigen::Vector2d::UnitY();

    Eigen::Vector2d at(double t) const;
    // The map from axes in which the ellipse is the unit circle.
    Eigen::Affine2d paper_from_circle() const;
    // Less than 1 inside, 1 on the ellipse.
    double radius_of(const Eigen::Vector2d& point) const;
};

// The projection of a conic of the view: an ellipse, if all of the conic is in front of the eye and
// not seen edge-on; else nothing.
std::optional<PaperEllipse> picture_of(const Conic& conic, const Projection& projection);

// The circle of the ellipsoid along which lines of sight are tangent to it; nothing if the eye is
// inside.
std::optional<Conic> limb_of(const SphereSight& sphere);

// A whole ellipse as such Béziers. The deviation is at most `tolerance_pt`; `off_pt` is raised to
// its bound: for a circle of radius 1 and an arc θ the deviation is (4/27)·sin⁶(θ/4)/cos²(θ/4), and
// an affine map stretches it by at most the ellipse's longest half-axis.
std::vector<Bezier> beziers_of(const PaperEllipse& ellipse, double tolerance_pt, double& off_pt);

// The ellipse nearest to points on paper: the conic xᵀAx + b·x = 1 about their mean, by least
// squares. Nothing if they lie on no ellipse: on one point, on a line, or on another conic.
std::optional<PaperEllipse> ellipse_through(std::span<const Eigen::Vector2d> points);

// The part of an ellipse between two parameters as n Béziers whose ends lie on the ellipse and have
// its tangents.
std::vector<Bezier> arc_of(const PaperEllipse& ellipse, double from, double to, int n);

// The track along a conic from one parameter to another.
Track track_of(const Conic& conic, double first, double last);

}  // namespace poinsot::vector
