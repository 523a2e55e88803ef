// The type of a page by other means than fonts: as paths, or left to another program.
#pragma once

#include <vector>

#include "vector/page.h"

namespace poinsot::vector {

// The same page with every letter as its outline, its halo as strokes below it.
// Throws EnvironmentError where a font cannot be read.
Page with_outlined_type(Page page);

// The page's type, taken off it, from the back to the front; what has rules alone stays.
std::vector<Type> take_type(Page& page);

}  // namespace poinsot::vector
