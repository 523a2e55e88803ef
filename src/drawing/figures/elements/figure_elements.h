// The size of a body drawn inside its inertia ellipsoid.
#pragma once

#include "drawing/stage/panel.h"

namespace poinsot {

// The largest reach at which a body stays inside the ellipsoid in every direction.
double body_in_ellipsoid(const ConstructionPicture& picture);

}  // namespace poinsot
