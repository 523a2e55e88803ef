// The height that charts need on a page whose text size is given in points.
#pragma once

#include "drawing/stage/type/least_sizes.h"
#include "scene/scene.h"

namespace poinsot {

// The rows that the charts of a panel need so that their numbers and names fit one above another;
// `px` and `least` as for rows_added_by_type. 0 for a panel without charts.
double rows_of_charts(const Scene& scene, const PanelSpec& panel, double px,
                      const LeastSizes& least);

// Number of rows that a page of several panels, `width_px` wide, needs beyond the `room_px` rows of
// its grid, so that the numbers and names of its charts fit one above another; `px` and `least` as
// for rows_added_by_type. 0 if there are no charts, if the rows suffice, or if the grid's height
// would exceed 5/3 of its width: on so narrow a page charts would have height but no width.
int rows_added_by_charts(const Scene& scene, int width_px, int room_px, double px,
                         const LeastSizes& least);

}  // namespace poinsot
