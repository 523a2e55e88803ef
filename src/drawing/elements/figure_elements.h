// How large a body is drawn inside its inertia ellipsoid.
#pragma once

#include "drawing/panel.h"

namespace poinsot {

// The reach with which a body stays within the ellipsoid in every direction.
double body_in_ellipsoid(const ConstructionPicture& picture);

}  // namespace poinsot
