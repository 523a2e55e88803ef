// The comparison motion in panels: the same start integrated by another method, in the ghost's
// colour, so that its drift from the first motion is visible.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>

#include "construction/timed_path.h"
#include "drawing/stage/panel.h"

namespace poinsot {

// A path of the comparison motion, shown up to the instant drawn.
struct GhostPath {
    Curve curve;
    TimedPath path;
};

// The path point(state) over the stage's span in the panel's axes, `width_px` wide at 1080 rows. It
// ends where it leaves the picture: a diverging method draws no line to infinity. Precondition: the
// stage has a comparison motion.
GhostPath ghost_path(const Panel& panel, StageStore& store,
                     const std::function<Eigen::Vector3d(const RotationState&)>& point,
                     double width_px);

// Adds the path up to this instant.
void add_ghost_path(const GhostPath& ghost, const FrameInput& instant, ViewBuilder& builder);

// The method of the comparison motion as pictures name it: "Euler", "RK4", "midpoint".
// Precondition: the stage has a comparison motion.
std::string comparison_name(const StageContext& stage);

// Sets a symbol of the ghost with this name as its index: "ω" with "Euler".
TextBlock set_ghost_label(const Panel& panel, StageStore& store, std::string_view symbol,
                          double scale = 0.85);

// Adds an arrow of the ghost from the origin, and its label.
void add_ghost_arrow(const Panel& panel, const Eigen::Vector3d& tip, const TextBlock& type,
                     ViewBuilder& builder);

}  // namespace poinsot
