// Rules for all lines of a view, whichever element draws them: style of hidden lines, gaps at
// crossings, and least width.
#pragma once

#include "drawing/stage/stage_data.h"

namespace poinsot {

// Applies the scene's `hidden` and `crossings` and the stage's least width to a view's lines. When
// hidden lines are dashed, all other dashed lines become thin solid lines. The principal sections
// of an ellipsoid become curves on it. An arrow with a dashed shaft becomes one arrow per dash, the
// last of them with the head.
void follow_line_rules(const StageData& stage, View& view);

}  // namespace poinsot
