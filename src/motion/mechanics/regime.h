// The kinds of motion, as the literature names them.
#pragma once

#include <string_view>

namespace poinsot {

// The kind of motion, chosen once when the motion is made.
enum class Regime {
    at_rest,                 // ω = 0
    permanent,               // steady spin about a principal axis (or any axis of a sphere)
    symmetric,               // two equal moments: trigonometric
    elliptic_about_lowest,   // the polhode encircles the axis of the lowest moment
    elliptic_about_highest,  // … of the highest moment
    separatrix,              // L² = 2T·I₂ exactly: hyperbolic
    heavy_top,               // Lagrange's top: see HeavyTop for its finer regimes
    integrated,              // stepped by a named method
};

std::string_view name_of(Regime regime);

}  // namespace poinsot
