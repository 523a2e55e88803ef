// The points and the track of a measured motion, [measured]: on the ellipsoid in any view of it,
// and on the invariable plane.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "drawing/stage/panel.h"
#include "measured/measured_motion.h"

namespace poinsot {

// ρ = ω/√(2T) of a measured row, body axes, in the lengths of the construction; T is that of the
// scene's motion at the row's time. A row whose own T differs lies off the ellipsoid.
Eigen::Vector3d measured_rho(const StageContext& stage, const MeasuredRow& row);

// Draws the rows up to the instant as dots joined by a thin line, which is interrupted where rows
// are missing. `point` gives the place of a row in axes that `placement` takes to those of the view
// at each instant. Precondition: the scene has a measured motion, and the stage a construction.
Drawer measured_track(const Panel& panel, StageStore& store,
                      const std::function<Eigen::Vector3d(const MeasuredRow&)>& point,
                      const std::function<Eigen::Affine3d(const FrameInput&)>& placement);

}  // namespace poinsot
