// The panels of a stage in the cells of their grid, with their cameras and headings.
#pragma once

#include <deque>

#include "drawing/stage/panel.h"

namespace poinsot {

// Makes the panels that the scene lists, or the default one for its motion. Throws SceneError for a
// panel that the motion cannot show, or that has no space.
std::deque<Panel> make_panels(const StageContext& stage, StageStore& store);

// Throws SceneError for a fade, an unlabelled name or a keyframe of the camera that concerns
// nothing in the picture. Call it when everything is made.
void check_targets(const StageContext& stage, const StageStore& store,
                   const std::deque<Panel>& panels);

}  // namespace poinsot
