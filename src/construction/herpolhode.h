// The herpolhode: the path of the contact point on the invariable plane, as a function of time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "construction/poinsot_construction.h"
#include "mechanics/motion.h"

namespace poinsot {

// A stretch of the herpolhode sampled to a tolerance, in space axes and the ellipsoid's lengths;
// `times_s` ascends and names the instant of each point, so that any part of it can be shown up to
// any instant. Points are measured from `foot`, the plane's point below the centre, so that the
// smallest loops keep their shape.
struct Herpolhode {
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();
    std::vector<double> times_s;
    std::vector<Eigen::Vector3d> points;
    std::int64_t n_evaluations = 0;  // of the motion that it took

    // Fractional index of an instant: how many points have been passed, 0 … n−1.
    double index_at(double time_s) const;
};

// The contact point on the plane at one instant, space axes.
Eigen::Vector3d herpolhode_point(const PoinsotConstruction& construction, const Motion& motion,
                                 double time_s);

// Samples [first_time_s, last_time_s] so that the polyline is within `tolerance` (the ellipsoid's
// lengths) of the curve. `shortest_feature_s` is a time over which the curve certainly does not
// turn by more than half a turn. It goes on beyond the last instant to the end of a piece of at
// most half that time, so that a shorter stretch is a part of a longer one, bit for bit.
Herpolhode sample_herpolhode(const PoinsotConstruction& construction, const Motion& motion,
                             double first_time_s, double last_time_s, double shortest_feature_s,
                             double tolerance, std::size_t max_points = 200'000);

}  // namespace poinsot
