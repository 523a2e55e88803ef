// What the rolling ellipsoid and its arrows pass through, whatever the instant.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "drawing/stage_data.h"

namespace poinsot {

// Points of the space that the space panel's figure fills over all time, picture axes: L's arrow,
// and the circles about L on which the ellipsoid's outline and the tips of ω, e1, e2, e3 run, for
// attitudes all along the polhode; and of the plane a disc about the foot of L. Tips reach `beyond`
// further, for their labels. `azimuth_rad`: one point of every circle lies in this direction.
std::vector<Eigen::Vector3d> swept_points(const ConstructionPicture& picture, double azimuth_rad,
                                          double beyond);

}  // namespace poinsot
