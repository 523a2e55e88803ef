// What charts ask of a page whose type has its size in points.
#pragma once

#include "drawing/type/least_sizes.h"
#include "scene/scene.h"

namespace poinsot {

// Rows that a page of several panels, `width_px` wide, needs beyond `room_px`, those that its grid
// has, for the numbers and names of its charts to stand one above another; `px` and `least` as for
// rows_added_by_type. 0 where there are no charts or room enough, and where the grid would be over
// five thirds as high as it is wide: on so narrow a page charts would have height and no width.
int rows_added_by_charts(const Scene& scene, int width_px, int room_px, double px,
                         const LeastSizes& least);

}  // namespace poinsot
