// Looping films: the options of a scene's loop, and their solution.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace poinsot {

// The picture is periodic with repeat_s of motion.
struct Loop {
    double repeat_s = 0.0;
    std::string in_words;  // "5 turns about L in 3 polhode periods"
    std::string change;    // changes of the start, with their size; empty: none
};

// Makes a scene that loops of the scene to be drawn: adjusts its start and sets the film's length
// to one loop, and adds notes about it. Scenes without a loop are unchanged. Throws SceneError at
// film.loop if there is no loop nearby.
std::optional<Loop> resolve_loop(Scene& scene, std::vector<std::string>& notes);

// Adds notes about elements that jump when the film repeats: a camera or an opacity that differs
// between the film's end and start.
void note_jumps(const Scene& scene, std::vector<std::string>& notes);

}  // namespace poinsot
