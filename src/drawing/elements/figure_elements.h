// Elements that explain the body and its rates as a textbook's figure does: axes, half-axes, rates
// of precession. Rows of the table in elements.cpp; picture axes.
#pragma once

#include "drawing/panel.h"

namespace poinsot {

// The axes x, y, z that the scene's numbers are given in.
Drawer make_given_axes(Panel& panel);
// The turn from x, y, z to e1, e2, e3, about its axis, with its angle.
Drawer make_turn(Panel& panel);
// From the centre to the surface along e1, e2, e3, named 1/√I.
Drawer make_half_axes(Panel& panel);
// Ω about the axis of symmetry, at which ω runs round in the body, and L/I₁ about L, at which that
// axis runs round in space. Throws InputError for a body without two equal moments.
Drawer make_precession(Panel& panel);
// The reach with which a body stays within the ellipsoid in every direction.
double body_in_ellipsoid(const ConstructionPicture& picture);
// The body itself, inside its ellipsoid.
Drawer make_body(Panel& panel);

}  // namespace poinsot
