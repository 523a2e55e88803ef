// A drawing's part as a drawing of its own: how pictures larger than a framebuffer are drawn.
#pragma once

#include "shapes/views.h"

namespace poinsot {

// Pixels of a picture, y down.
struct PixelArea {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

// What the area shows, in pixels from its corner. It refers to the whole's geometry and masks,
// which must outlive it; masks much larger than the area are cut to it.
Drawing part_of(const Drawing& whole, const PixelArea& area);

}  // namespace poinsot
