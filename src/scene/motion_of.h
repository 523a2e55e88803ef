// The motion of a scene.
#pragma once

#include "mechanics/motion.h"
#include "scene/scene.h"

namespace poinsot {

// Makes the motion of problem_of(scene). Throws SceneError at the scene's [motion] for what cannot
// be computed: a step longer than the film, a phase that overflows.
Motion motion_of(const Scene& scene);

}  // namespace poinsot
