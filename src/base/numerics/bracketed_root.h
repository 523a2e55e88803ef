// Root of a function of one variable within a bracket.
#pragma once

#include <functional>

namespace poinsot {

// Returns a root between low and high, to the last place: of the two neighbouring doubles that
// enclose the sign change, the one with the smaller |function|. Precondition: low < high;
// function(low) and function(high) have opposite signs, or one of them is 0. Method: Alefeld, Potra
// and Shi's algorithm 748, as in Boost.Math.
double bracketed_root(const std::function<double(double)>& function, double low, double high);

}  // namespace poinsot
