// What all lines of a view have in common, whatever drew them: how they are drawn where something
// hides them, where they pass under others, and how thin they may be.
#pragma once

#include "drawing/stage_data.h"

namespace poinsot {

// Makes a view's lines as the scene's `hidden` and `crossings` say, and none thinner than the
// stage's options allow. With hidden lines dashed no other line is: those that were broken to be
// told apart become thinner. An ellipsoid's principal sections become curves on it. Arrows of
// broken shafts become their dashes, the last of them with the head.
void follow_line_rules(const StageData& stage, View& view);

}  // namespace poinsot
