// The scene of a fitted motion, as `poinsot fit -o` writes it.
#pragma once

#include <string>
#include <string_view>

#include "measured/fit.h"
#include "measured/measured_motion.h"

namespace poinsot {

// A scene of the fitted motion, without its drag, with the table beside it. Its times are those
// of the table: the motion is followed back to t = 0. ω(t) tells moments up to a common factor
// only: I1 = 1 kg m² unless they were given. `name`:
// what was fitted, for the first comment. `table`: the table of these rows, as the scene names it.
std::string fitted_scene(const FittedMotion& fit, const MeasuredMotion& measured,
                         std::string_view name, const std::string& table);

}  // namespace poinsot
