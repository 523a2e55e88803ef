// Where a function of one number passes zero.
#pragma once

#include <functional>

namespace poinsot {

// A root between two numbers, to the last place: of the two doubles that enclose the change of
// sign, the one with the smaller value. Precondition: low < high; the values there have different
// signs or one is 0. Method: Alefeld, Potra and Shi's algorithm 748, as in Boost.Math.
double bracketed_root(const std::function<double(double)>& function, double low, double high);

}  // namespace poinsot
