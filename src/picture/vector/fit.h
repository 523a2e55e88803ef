// Approximates curves on paper with few cubic Béziers, within a tolerance.
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
    std::vector<Bezier> beziers;  // each begins at the end of the previous one
    double off_pt = 0.0;          // 1.5 times the largest distance found between curve and Béziers
};

// Fits Béziers that match the curve's positions and tangents at their ends; the lengths of the
// handles minimise the squared distances (Gauss-Newton). Parts are halved until each is within
// `tolerance_pt` of the curve. `knots` (ascending; at least two) are the parameters of possible
// corners: at each corner a new Bézier begins. Precondition: the curve is smooth between knots.
// Makes at most 2^16 Béziers.
Fit fitted(const std::function<PaperFlow(double)>& curve, std::span<const double> knots,
           double tolerance_pt);

}  // namespace poinsot::vector
