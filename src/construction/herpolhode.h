// The herpolhode: the path of the contact point on the invariable plane, as a function of time.
#pragma once

#include <Eigen/Core>

#include "construction/poinsot_construction.h"
#include "construction/timed_path.h"
#include "mechanics/motion.h"

namespace poinsot {

// A stretch of the herpolhode sampled to a tolerance, in space axes and the ellipsoid's lengths.
// Points are measured from `foot`, the plane's point on L, so that the smallest loops
// keep their shape.
struct Herpolhode : TimedPath {
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();
};

// The contact point on the plane at one instant, space axes.
Eigen::Vector3d herpolhode_point(const PoinsotConstruction& construction, const Motion& motion,
                                 double time_s);

// Samples a stretch as sample_path does, to a tolerance in the ellipsoid's lengths.
Herpolhode sample_herpolhode(const PoinsotConstruction& construction, const Motion& motion,
                             double first_time_s, double last_time_s, double shortest_feature_s,
                             double tolerance, std::size_t max_points = 200'000);

}  // namespace poinsot
