// A scene as the text of a scene file.
#pragma once

#include <string>

#include "scene/scene.h"

namespace poinsot {

// Writes every key that the scene has a value for, defaults included, in the order of the key
// table; parse_scene reads exactly the same scene. Attitude matrices are written as quaternions.
std::string to_toml(const Scene& scene);

// The values of the scene `before` that differ in the scene `after`: "film.size = [1920, 1080];
// film.duration_s not given". The scenes have the same items in their arrays of tables.
std::string values_replaced(const Scene& before, const Scene& after);

}  // namespace poinsot
