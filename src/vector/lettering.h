// Alternatives to fonts for the type of a page: outlines, or text for another program.
#pragma once

#include <vector>

#include "vector/page.h"

namespace poinsot::vector {

// Replaces every letter by its outline, with its halo as strokes below. Throws EnvironmentError if
// a font cannot be read.
Page with_outlined_type(Page page);

// Removes the type from the page and returns it, in order from back to front. Type that consists
// only of rules stays.
std::vector<Type> take_type(Page& page);

}  // namespace poinsot::vector
