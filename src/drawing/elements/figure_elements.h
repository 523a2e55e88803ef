// Elements that explain the construction as a textbook's figure does: radius vector, gradient,
// dimension line, half-axes, rates. Rows of the table in elements.cpp; picture axes, z along L.
#pragma once

#include "drawing/panel.h"

namespace poinsot {

// The axes x, y, z that the scene's numbers are given in.
Drawer make_given_axes(Panel& panel);
// From the centre to the surface along e1, e2, e3, named 1/√I.
Drawer make_half_axes(Panel& panel);
// ρ = ω/√(2T): where ω pierces the ellipsoid, F(ρ) = 1.
Drawer make_radius(Panel& panel);
// The plane that touches the ellipsoid at ρ.
Drawer make_tangent(Panel& panel);
// ∇F at ρ: it points along L, as ∇F = 2 I ρ.
Drawer make_gradient(Panel& panel);
// The plane's distance √(2T)/L from the centre, as a dimension line beside the ellipsoid.
Drawer make_distance(Panel& panel);
// Ω about the axis of symmetry, at which ω runs round in the body, and L/I₁ about L, at which that
// axis runs round in space. Throws InputError for a body without two equal moments.
Drawer make_precession(Panel& panel);
// The body itself, inside its ellipsoid.
Drawer make_body(Panel& panel);

}  // namespace poinsot
