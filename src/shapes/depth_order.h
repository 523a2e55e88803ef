// Which arrows and dots of a view lie on top of which.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace poinsot {

// A point as a picture has it, in whatever unit the picture counts.
struct SeenPoint {
    Eigen::Vector2d at;
    double depth = 0.0;  // view units along the camera's axis
};

// The axis of an arrow.
struct SeenAxis {
    SeenPoint tail, tip;
};

// Numbers of arrows, then of dots, from the back to the front: each is put before the first that it
// is not in front of. Of two at one depth, as arrows on one line are, the later lies on top,
// whatever the last bits of their depths say.
std::vector<std::size_t> back_to_front(std::span<const SeenAxis> arrows,
                                       std::span<const SeenPoint> dots, bool perspective);

}  // namespace poinsot
