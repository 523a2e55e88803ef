// Things that come and go: a drawer whose shapes are as present as the film's timeline says.
#pragma once

#include <string>

#include "drawing/stage_data.h"

namespace poinsot {

// The drawer itself if nothing fades what goes by this name. Otherwise one that draws nothing at
// opacity 0 and scales every shape's opacity; and the stage notes that the name means something.
// Where the scene says `labels = false`, or has it among the unlabelled, the names beside it stay
// away.
Drawer fading(StageData& stage, const std::string& name, Drawer draw);

}  // namespace poinsot
