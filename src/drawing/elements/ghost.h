// What panels show of the motion beside: the same start carried on by another method, in the
// ghost's colour, so that its drift is seen against the first.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string_view>

#include "construction/timed_path.h"
#include "drawing/panel.h"

namespace poinsot {

// A path of the motion beside, shown up to the instant drawn.
struct GhostPath {
    Curve curve;
    TimedPath path;
};

// point(state) over the stage's span in the panel's axes, `width_px` wide at 1080 rows. It ends
// where it has left the picture: a method that blows up draws no line to infinity.
// Precondition: the stage has a motion beside.
GhostPath ghost_path(Panel& panel,
                     const std::function<Eigen::Vector3d(const RotationState&)>& point,
                     double width_px);

// Adds what has been run along so far.
void add_ghost_path(const GhostPath& ghost, const Instant& instant, Sheet& sheet);

// Type for a symbol of the ghost's, the method's name as its index: "ω" with "euler".
SetType set_ghost_label(const Panel& panel, std::string_view symbol, double scale = 0.85);

// An arrow of the ghost's from the origin, and its label.
void add_ghost_arrow(const Panel& panel, const Eigen::Vector3d& tip, const SetType& type,
                     Sheet& sheet);

}  // namespace poinsot
