// The scene's [symbols] in formulas and titles.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace poinsot {

// Replaces the built-in names of quantities in a formula by the scene's [symbols]:
// \boldsymbol{\omega}, \mathbf{L}, \boldsymbol{\rho}, \mathbf{e}_1 … and the components \omega_…
// and L_…, in exactly this spelling. L alone is the length of the vector that \mathbf{L} names.
std::string named_by_scene(const Scene& scene, std::string_view formula);
// The same for a title in words with formulas between dollars: a word L is the vector.
std::string title_named_by_scene(const Scene& scene, std::string_view title);

}  // namespace poinsot
