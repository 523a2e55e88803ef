// The kind of a motion in words, as `check` prints it.
#pragma once

#include <string>

#include "mechanics/motion.h"

namespace poinsot {

// "polhode about e1, the axis of the smallest moment (elliptic)", or the kind of a heavy symmetric
// top with its meaning; for other motions under a torque, the name of the regime.
std::string regime_sentence(const Motion& motion);
std::string regime_sentence(const HeavyTop& top);

}  // namespace poinsot
