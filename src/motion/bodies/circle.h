// Points on circles, for tessellation. Included only inside src/motion/bodies.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bodies/solid_meshes.h"

namespace poinsot {

// Cosine and sine of i/n of a turn. All points are mirrored from the first octant, so that mirror
// images are exact. Precondition: 0 ≤ i ≤ n; n is a multiple of 4.
Eigen::Vector2d on_unit_circle(int i, int n);

// The factor on its radius that gives a regular polygon of n sides the area of the circle.
double equal_area_factor(int n);

// The closed profile of a tube whose polygon has the area of its circle: n points,
// counter-clockwise.
std::vector<ProfilePoint> tube_profile(double centre_line_radius_m, double tube_radius_m, int n);

}  // namespace poinsot
