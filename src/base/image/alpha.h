// Functions for transparency.
#pragma once

#include "image/image.h"

namespace poinsot {

// Whether alpha is 255 in every pixel.
bool is_opaque(const Image& image);

// Draws the picture on a white background, for formats without alpha. `flat` is resized if
// necessary. Blends the stored sRGB values, as slides and pages blend a transparent PNG with their
// background.
void flatten_on_white(const Image& image, Image& flat);

}  // namespace poinsot
