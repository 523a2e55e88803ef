// Fades: drawers whose shapes have the opacity that the film's timeline gives.
#pragma once

#include <string>

#include "drawing/stage/drawer.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/stage_store.h"

namespace poinsot {

// Returns the drawer itself if no fade uses this name. Otherwise returns a drawer that scales the
// opacity of every shape and draws nothing at opacity 0; the store then records that fades may use
// the name. If the scene says `labels = false` or lists this name among the unlabelled, its labels
// are omitted.
Drawer fading(const StageContext& stage, StageStore& store, const std::string& name, Drawer draw);

}  // namespace poinsot
