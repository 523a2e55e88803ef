// Films that run into themselves: what a scene's loop asks for, and what it takes.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace poinsot {

// After loop_s of motion the picture is the same.
struct Loop {
    double loop_s = 0.0;
    std::string in_words;  // "5 turns about L in 3 polhode periods"
    std::string change;    // what was changed in the start and by how much, empty for nothing
};

// Makes the scene the one that is shown: its start closes, and its film lasts one loop. Scenes
// without a loop are left alone. Throws SceneError at film.loop where none is near by.
std::optional<Loop> resolve_loop(Scene& scene);

// Says in the scene's notes what makes the film jump all the same where it begins again: a camera
// or an element that ends otherwise than it began.
void note_jumps(Scene& scene);

}  // namespace poinsot
