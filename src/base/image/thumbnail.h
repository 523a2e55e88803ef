// Small copies of pictures for reports.
#pragma once

#include "image/image.h"

namespace poinsot {

// The picture, averaged over whole pixels until no side is longer than most_px. Rows and columns
// that do not fill a pixel are left out.
Image thumbnail(const Image& image, int most_px);

// The same for a layer of differences (see difference_layer): each pixel shows the strongest
// difference of those that it stands for, so that a single pixel stays visible.
Image layer_thumbnail(const Image& layer, int most_px);

}  // namespace poinsot
