// The definition of the inertia ellipsoid as it is drawn: an axis n takes all directions in turn,
// and the tip of ρ = n/√I(n) leaves a trace on the ellipsoid. For the sweep panel and the elements
// "direction" and "direction-trace".
#pragma once

#include <Eigen/Core>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

class AxisSweep {
 public:
    // Length of the arrow along n beyond the ellipsoid, in units of the largest half-axis.
    static constexpr double beyond = 0.3;

    // `half_axes`: 1/√I in units of the largest.
    AxisSweep(const Panel& panel, StageStore& store, const Eigen::Vector3d& half_axes);

    // At a fraction of the sweep, 0…1. `picture_from_principal`: the body's attitude, a rotation.
    // add_trace: ρ = n/√I(n) and the path of its tip so far; add_direction: n and the number I(n).
    void add_trace(const Eigen::Matrix3d& picture_from_principal, double share,
                   ViewBuilder& builder) const;
    void add_direction(const Eigen::Matrix3d& picture_from_principal, double share,
                       ViewBuilder& builder) const;

 private:
    // Index of a fraction of the sweep among the points of the trace.
    double index_at(double share) const;

    const Panel* panel_;
    const TextCache* text_;
    Eigen::Vector3d half_axes_;
    Curve trace_;
    std::vector<double> shares_;  // fraction of the sweep at each point of the trace
    TextBlock n_type_, rho_type_;
};

}  // namespace poinsot
