// Parts of textbook figures of the body that several panels draw.
#pragma once

#include <array>

#include "drawing/stage/panel.h"

namespace poinsot {

// The largest reach at which a body stays inside the ellipsoid in every direction.
double body_in_ellipsoid(const ConstructionPicture& picture);

// Adds the half-axes of the ellipsoid (lengths in picture axes) along the principal axes, which are
// columns, with their names at their ends.
void add_half_axes(const Panel& panel, const Eigen::Matrix3d& principal_axes,
                   const Eigen::Vector3d& half_axes, const std::array<TextBlock, 3>& types,
                   ViewBuilder& builder);

}  // namespace poinsot
