// Curves on paper as few cubic Béziers as a tolerance allows.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "vector/paper_flow.h"

namespace poinsot::vector {

using Bezier = std::array<Eigen::Vector2d, 4>;

Eigen::Vector2d at(const Bezier& bezier, double t);

struct Fit {
    std::vector<Bezier> beziers;  // each begins where the one before ends
    double off_pt = 0.0;  // greatest distance found between curve and Béziers, half as much again
};

// Béziers that have the curve's positions and tangents at their ends, their handles' lengths those
// that lie nearest to it (least squares of the distances, Gauss and Newton): halved until each is
// within `tolerance_pt` of the curve. `knots` (ascending; at least two) are where the curve may
// have corners: a Bézier begins at each that is one. Precondition: the curve is smooth between
// them. At most 2^16 Béziers.
Fit fitted(const std::function<PaperFlow(double)>& curve, std::span<const double> knots,
           double tolerance_pt);

}  // namespace poinsot::vector
