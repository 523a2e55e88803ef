// Flights of a recording that are not of the same body as the others.
#pragma once

#include <cstddef>
#include <vector>

#include "measured/joint_fit.h"

namespace poinsot {

// The index of the flight whose ratios of moments lie nearest to the medians; 0 if no flight has a
// fit of its own.
std::size_t most_typical(const std::vector<JointFlight>& flights);

// Sets `left_out` of each flight that is far from the others, with the reason. Fewer than five
// flights have no outliers. `reference`: the most typical one.
void leave_outliers_out(std::vector<JointFlight>& flights, const FittedMotion& reference);

}  // namespace poinsot
