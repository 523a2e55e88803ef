// The separation of the arrows of a picture, to find the instant at which none hides another.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "shapes/views.h"

namespace poinsot {

// An arrow as the picture shows it.
struct PlacedArrow {
    int view = 0;   // index of its view
    int index = 0;  // of the arrow in its view
    Eigen::Vector2d tail_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d tip_px = Eigen::Vector2d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // in the view, of unit length
};

// Appends the visible arrows of a view in front of its camera; a dashed arrow is one arrow here.
void append_arrows(const View& view, int index_of_view, std::vector<PlacedArrow>& arrows);

// The smaller distance in the picture from the tip of one arrow to the other arrow: 0 if one lies
// along the other, however long they are.
double separation_px(const PlacedArrow& a, const PlacedArrow& b);

// The index of the picture whose closest two arrows are farthest apart, the last of equals.
// Distances count in whole steps of `step_px` up to `enough_px`, beyond which arrows are clearly
// apart. Arrows that are parallel in every picture, as ρ and ω, do not count. Precondition: there
// is a picture.
std::size_t clearest_picture(std::span<const std::vector<PlacedArrow>> pictures, double step_px,
                             double enough_px);

}  // namespace poinsot
