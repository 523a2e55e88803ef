// Points of circles for tessellation. Inside of src/mesh only.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/solid_meshes.h"

namespace poinsot {

// Cosine and sine of i/n of a turn, 0 ≤ i ≤ n, n a multiple of 4; made from the first octant, so
// that mirror images are exact.
Eigen::Vector2d on_unit_circle(int i, int n);

// A regular polygon of n sides with this factor on its radius has the circle's area.
double equal_area_factor(int n);

// Closed profile of a tube with the area of its circle: n points, counter-clockwise.
std::vector<ProfilePoint> tube_profile(double centre_line_radius_m, double tube_radius_m, int n);

}  // namespace poinsot
