// Smooth (exact) forms of curves that elements and panels draw as points; made when a renderer
// requests them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "construction/polhode.h"
#include "shapes/lines.h"

namespace poinsot {

// A circle about z, from x towards y, of `n_points` points.
SmoothMaker smooth_circle(const Eigen::Vector3d& centre, double radius, std::size_t n_points);

// A polhode in body axes and the ellipsoid's lengths; its points are sampled(points_tolerance).
SmoothMaker smooth_polhode(const Polhode& polhode, double points_tolerance);

// A path with its velocity; its points are at these instants.
SmoothMaker smooth_path(std::function<CurveFlow(double time_s)> flow, std::vector<double> times_s);

}  // namespace poinsot
