// The names of the motions of Lagrange's top.
#pragma once

#include "mechanics/top/heavy_top.h"
#include "mechanics/top/heavy_top_cubic.h"

namespace poinsot::top_setup {

// Names the motion. Cases that depend on the rounding of the input are told apart to 1e-12.
TopRegime regime_of(const Cubic& c);

}  // namespace poinsot::top_setup
