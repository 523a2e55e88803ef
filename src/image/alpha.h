// Questions and answers about transparency.
#pragma once

#include "image/image.h"

namespace poinsot {

// Whether alpha is 255 everywhere.
bool is_opaque(const Image& image);

// The picture on a white ground, for formats without alpha; flat is resized where it must be.
// Mixed as stored, in sRGB, which is how slides and pages lay a transparent PNG on their own
// ground.
void flatten_on_white(const Image& image, Image& flat);

}  // namespace poinsot
