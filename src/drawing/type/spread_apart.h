// Names in a column that keep off each other.
#pragma once

#include <vector>

namespace poinsot {

// Middles of things of these heights, in their wished order, as near their wished middles as they
// can stand with a gap between (least squares), and within [least, most]; from `least` on where
// that has no room for them.
std::vector<double> spread_apart(const std::vector<double>& wished,
                                 const std::vector<double>& heights, double gap, double least,
                                 double most);

}  // namespace poinsot
