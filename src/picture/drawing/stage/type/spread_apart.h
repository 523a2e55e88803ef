// Placing the names of a column without overlap.
#pragma once

#include <vector>

namespace poinsot {

// Middles of items of these heights, in the order of their requested middles and as near to them as
// possible (least squares) with a gap between, and within [least, most]; if they do not fit,
// stacked from `least` on.
std::vector<double> spread_apart(const std::vector<double>& wished,
                                 const std::vector<double>& heights, double gap, double least,
                                 double most);

}  // namespace poinsot
