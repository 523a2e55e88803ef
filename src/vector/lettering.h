// The type of a page by other means than fonts: as paths.
#pragma once

#include "vector/page.h"

namespace poinsot::vector {

// The same page with every letter as its outline, its halo as strokes below it.
// Throws EnvironmentError where a font cannot be read.
Page with_outlined_type(Page page);

}  // namespace poinsot::vector
