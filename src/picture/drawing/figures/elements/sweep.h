// The region that the rolling ellipsoid and its arrows pass through over all time.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "drawing/stage/stage_context.h"

namespace poinsot {

// Shapes besides the ellipsoid and the tips of ω, e1, e2, e3.
struct SweptShapes {
    bool spin_axis = true;              // on the side away from the contact
    std::vector<Eigen::Vector3d> tips;  // of further arrows fixed in the body, principal axes
};

// Points that bound the space panel's figure over all time, picture axes: L's arrow; the circles
// about L that the ellipsoid's outline and the tips describe, for attitudes all along the polhode;
// and a disc of the plane about the foot of L. Tips extend `beyond` further, for their labels.
// `azimuth_rad`: one point of every circle lies in this direction.
std::vector<Eigen::Vector3d> swept_points(const ConstructionPicture& picture,
                                          const SweptShapes& shapes, double azimuth_rad,
                                          double beyond);

}  // namespace poinsot
