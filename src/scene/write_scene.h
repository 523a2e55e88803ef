// A scene as the text of a scene file.
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot {

// Every key that the scene has a value for, defaults included, in the order of the key table;
// parse_scene gives the same scene back, bit for bit. Attitude matrices are written as quaternions.
std::string to_toml(const Scene& scene);

}  // namespace poinsot
