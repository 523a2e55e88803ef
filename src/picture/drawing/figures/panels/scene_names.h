// The check that a scene names only things of its picture, before its motion is stepped.
#pragma once

#include "drawing/style/theme.h"
#include "mechanics/motion.h"
#include "scene/scene.h"

namespace poinsot {

// Throws SceneError for an unknown panel, element or quantity, for a panel or quantity that cannot
// show this kind of motion, and for a fade or an unlabelled name that concerns nothing shown.
// `motion`: of the scene; it need only cover the start. Making a stage checks more.
void check_scene_names(const Scene& scene, const Theme& theme, const Motion& motion);

}  // namespace poinsot
