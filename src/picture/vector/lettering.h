// Alternatives to fonts for the type of a sheet: outlines, or text for another program.
#pragma once

#include <vector>

#include "vector/sheet_of_paper.h"

namespace poinsot::vector {

// Replaces every letter by its outline, with its halo as strokes below. Throws EnvironmentError if
// a font cannot be read.
SheetOfPaper with_outlined_type(SheetOfPaper paper);

// Removes the type from the sheet and returns it, in order from back to front. Type that consists
// only of rules stays.
std::vector<Type> take_type(SheetOfPaper& paper);

}  // namespace poinsot::vector
