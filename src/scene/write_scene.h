// A scene as the text of a scene file.
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot {

// Writes every key that the scene has a value for, defaults included, in the order of the key
// table; parse_scene reads exactly the same scene. Attitude matrices are written as quaternions.
std::string to_toml(const Scene& scene);

}  // namespace poinsot
