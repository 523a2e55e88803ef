// Elements of the rolling itself: the plane, and the paths of the contact point on it and on the
// ellipsoid. Rows of the table in elements.cpp; picture axes, z along L.
#pragma once

#include "drawing/panel.h"

namespace poinsot {

// The invariable plane, ruled in squares, or in circles for a camera that turns about L.
Drawer make_plane(Panel& panel);
// The contact point's path on the ellipsoid, and how much of it is shown.
Drawer make_polhode(Panel& panel);
// Its path on the plane, likewise.
Drawer make_herpolhode(Panel& panel);
// The circles on the plane between which that runs.
Drawer make_annulus(Panel& panel);

}  // namespace poinsot
