// The order in which arrows and dots of a view cover each other.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace poinsot {

// A projected point, in the picture's unit.
struct SeenPoint {
    Eigen::Vector2d at;
    double depth = 0.0;  // view units along the camera's axis
};

// The projected axis of an arrow.
struct SeenAxis {
    SeenPoint tail, tip;
};

// Returns numbers of arrows, then of dots, from back to front. Each one is inserted before the
// first that it is not in front of. Of two at equal depth, such as arrows on one line, the later
// one is in front, independent of rounding in their depths.
std::vector<std::size_t> back_to_front(std::span<const SeenAxis> arrows,
                                       std::span<const SeenPoint> dots, bool perspective);

}  // namespace poinsot
