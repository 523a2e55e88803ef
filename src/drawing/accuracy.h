// How close to the truth a scene asks its pictures to be, in the units that each part of them
// counts in. Made once for a session and passed down.
#pragma once

#include "scene/scene.h"

namespace poinsot {

struct Accuracy {
    double asked_px = 0.1;  // accuracy_px, of the picture that is made
    // Pixels by which the tip of the longest thing that turns moves for an attitude wrong by one
    // radian (small errors), in a space panel that fills the film's picture, for a camera that
    // looks at the fixed centre; a framed one looks a little beside it, which adds about 1e-3.
    double px_per_rad = 1.0;

    // What the motion may be off by.
    double motion_rad() const { return asked_px / px_per_rad; }
    // What a polyline may leave its curve by, in pixels of a picture drawn so many times as large
    // or as coarse: half of what is asked.
    double curve_px(double factor = 1.0) const { return 0.5 * asked_px * factor; }
};

Accuracy accuracy_of(const Scene& scene);

}  // namespace poinsot
