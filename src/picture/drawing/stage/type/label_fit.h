// Dropping text on paper, where text cannot shrink with the picture.
#pragma once

#include "shapes/views.h"

namespace poinsot {

// Drops labels that overlap others or extend beyond the page: of two overlapping labels, the one of
// higher rank, or else the later one. Adds their texts to those that the drawing left out. Throws
// InputError if both are names in the picture.
void leave_out_type(Drawing& drawing);

}  // namespace poinsot
