// The panels of a stage in the cells of their grid, with their cameras and headings.
#pragma once

#include <deque>
#include <set>
#include <string>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

struct PanelKind;

// The panels that the scene lists; if it lists none, the default one for its motion.
std::vector<PanelSpec> panels_of(const StageContext& stage);

// The kinds of these panels. Throws SceneError for an unknown kind.
std::vector<const PanelKind*> kinds_of(const Scene& scene, const std::vector<PanelSpec>& panels);

// Throws SceneError if the panel cannot show the motion.
void check_possible(const StageContext& stage, const PanelKind& kind);

// Throws SceneError if a fade or an unlabelled name concerns none of these.
void check_named_elements(const Scene& scene, const std::set<std::string, std::less<>>& names);

// Makes the panels that the scene lists, or the default one for its motion, and after them their
// insets. Throws SceneError for a panel or an inset that the motion cannot show, or for a panel
// that has no space.
std::deque<Panel> make_panels(const StageContext& stage, StageStore& store);

// Throws SceneError for a fade, an unlabelled name or a keyframe of the camera that concerns
// nothing in the picture. Call it when everything is made.
void check_targets(const StageContext& stage, const StageStore& store,
                   const std::deque<Panel>& panels);

}  // namespace poinsot
