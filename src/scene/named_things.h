// The curves, surfaces and arrows of the picture whose names a scene can choose, rename and move.
#pragma once

#include <array>
#include <string_view>

namespace poinsot {

// The values of `names`, and keys of [symbols] and [labels].
inline constexpr std::array<std::string_view, 8> named_things{
    "polhode",   "herpolhode", "invariable-plane", "inertia-ellipsoid",
    "body-cone", "space-cone", "separatrix",       "unit-sphere"};

// The quantities of [symbols], which are also keys of [labels].
inline constexpr std::array<std::string_view, 6> named_quantities{"omega", "momentum", "rho",
                                                                  "e1",    "e2",       "e3"};

}  // namespace poinsot
