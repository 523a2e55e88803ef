// Type on paper, where it cannot shrink with the picture.
#pragma once

#include "shapes/views.h"

namespace poinsot {

// Leaves out labels that cover others or stand off the page: of two that cover each other the one
// of the higher rank, or the later. Throws InputError where names in the picture do.
void leave_out_type(Drawing& drawing);

}  // namespace poinsot
