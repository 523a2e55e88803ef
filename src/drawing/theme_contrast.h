// Whether what a scene's [style] made of its theme can still be seen and told apart.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace poinsot {

// What the themes of ours keep (docs/guide.md, "Themes of one's own") and this one's [style] does
// not: one line each, with the place of the key. Empty where the scene has no style.
std::vector<std::string> contrast_notes(const Scene& scene);

}  // namespace poinsot
