// Scene keys that are given and have no effect on the picture.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace poinsot {

struct IdleKey {
    std::string key;  // "camera.distance"
    std::string why;  // completes the sentence "camera.distance changes nothing: …", with advice
};

// Unused keys of the camera, trails, elements and panels: no panel of the scene uses them. Unused
// keys in a panel's own table are rejected when the panel is made.
std::vector<IdleKey> idle_keys(const Scene& scene);

}  // namespace poinsot
