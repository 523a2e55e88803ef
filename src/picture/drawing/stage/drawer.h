// A drawer adds the shapes of one instant to a view. Panels, elements and overlays are made into
// drawers once; every video frame calls them.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "mechanics/motion.h"
#include "shapes/views.h"

namespace poinsot {

// The motion's state at one instant, as the panels use it, and the film's second. The attitude is
// the identity unless a panel needs it.
struct FrameInput : MotionSample {
    double time_s = 0.0;
    double film_s = 0.0;
    std::optional<RotationState>
        comparison{};  // state of the comparison motion, if a panel shows it
};

// A view under construction: its shapes, and the labels that are not placed yet.
struct ViewBuilder {
    View view;
    std::vector<LabelRequest> requests;
};

// Adds the shapes of one instant to a builder; refers to the stage's geometry and owns none.
using Drawer = std::function<void(const FrameInput&, ViewBuilder&)>;

}  // namespace poinsot
