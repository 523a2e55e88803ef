// Whether a theme changed by a scene's [style] still has visible and distinguishable colours.
#pragma once

#include <string>
#include <vector>

#include "drawing/style/theme.h"
#include "scene/scene.h"

namespace poinsot {

// Violations of the rules that the built-in themes follow (docs/guide.md, "Your own theme"):
// one line each, with the position of the key. `theme`: the scene's. Empty if the scene
// has no style.
std::vector<std::string> contrast_notes(const Scene& scene, const Theme& theme);

}  // namespace poinsot
