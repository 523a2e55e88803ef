// What all lines of a view have in common, whatever drew them.
#pragma once

#include "drawing/stage_data.h"

namespace poinsot {

// Makes no line thinner than the stage's options allow.
void follow_line_rules(const StageData& stage, View& view);

}  // namespace poinsot
