// The accuracy that a scene requests for its pictures, converted to radians and pixels. Computed
// once per session and passed down.
#pragma once

#include "scene/scene.h"

namespace poinsot {

struct Accuracy {
    double asked_px = 0.1;  // accuracy_px, in pixels of the output
    // Displacement in pixels of the tip of the longest rotating arrow per radian of attitude error
    // (small errors), in a space panel that fills the film's picture, for a camera aimed at the
    // fixed centre; a framed camera aims slightly beside it, which adds about 1e-3.
    double px_per_rad = 1.0;

    // Largest allowed attitude error of the motion, radians.
    double motion_rad() const { return asked_px / px_per_rad; }
    // Largest allowed distance of a polyline from its curve, in pixels of a picture that is
    // `factor` times as large or as coarse: half of the requested accuracy.
    double curve_px(double factor = 1.0) const { return 0.5 * asked_px * factor; }
};

Accuracy accuracy_of(const Scene& scene);

}  // namespace poinsot
