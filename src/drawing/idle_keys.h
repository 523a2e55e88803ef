// Keys that a scene gives and that change nothing of what it shows.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace poinsot {

struct IdleKey {
    std::string key;  // "camera.distance"
    std::string why;  // finishes the sentence "camera.distance changes nothing: …", with what to do
};

// Those of the camera, the trails, the elements and the panels that no panel of the scene takes
// anything of. What a panel's own table says in vain is refused when the panel is made.
std::vector<IdleKey> idle_keys(const Scene& scene);

}  // namespace poinsot
