// A path as a function of time: sampled once, drawn up to any instant.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace poinsot {

// `times_s` ascends and holds the time of each point.
struct TimedPath {
    std::vector<double> times_s;
    std::vector<Eigen::Vector3d> points;
    std::vector<double> offs;        // CurveSample::off of each point
    std::int64_t n_evaluations = 0;  // that were needed
    double off = 0.0;  // largest distance found between path and polyline; infinite where the path
                       // has more turns than there may be points, and was not followed

    // Fractional index of an instant: the number of points passed so far, 0 … n−1.
    double index_at(double time_s) const;
};

// Samples [first_time_s, last_time_s] so that the polyline is within `tolerance` of the path.
// `shortest_feature_s` is a time over which the path certainly does not turn by more than half a
// turn. Sampling continues beyond the last instant to the end of a piece of at most half that time,
// so that the samples of a shorter stretch are bit-identical to those of a longer one. A path of
// more than max_points / 4 such pieces is not sampled: only its first point is returned.
TimedPath sample_path(const std::function<Eigen::Vector3d(double)>& point, double first_time_s,
                      double last_time_s, double shortest_feature_s, double tolerance,
                      std::size_t max_points = 200'000);

}  // namespace poinsot
