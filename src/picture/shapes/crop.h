// A rectangle of a drawing as a separate drawing, for pictures larger than a framebuffer.
#pragma once

#include "shapes/views.h"

namespace poinsot {

// Pixels of a picture, y down.
struct PixelArea {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

// Returns the drawing inside this area, in pixels from the area's corner. It refers to the
// geometry and masks of the whole, which must outlive it; masks much larger than the area are
// cropped.
Drawing cropped(const Drawing& whole, const PixelArea& area);

}  // namespace poinsot
