// Labels: letters, rules and halos.
#pragma once

#include "vector/canvas.h"

namespace poinsot::vector {

void draw_label(const Canvas& canvas, const Label& label);
// Whether the label is omitted together with the hidden point that it names.
bool is_omitted(const Canvas& canvas, const Label& label);

}  // namespace poinsot::vector
