// Sampling of a smooth curve so that its polyline stays within a tolerance of it.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace poinsot {

inline constexpr std::size_t most_curve_points = 1'000'000;

struct CurveSample {
    double parameter = 0.0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double off = 0.0;  // largest distance found between the curve and the segment that ends here
};

// Distance of a point from the segment between two others.
double distance_from_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                             const Eigen::Vector3d& to);

// Samples point(parameter) over [first, last], starting from n_pieces equal pieces and halving each
// until the curve at its quarter points, and where it might be farther off between them, is within
// `tolerance` of the chord. Returns ascending
// parameters, both ends included; at most max_points of them (the tolerance is then not reached
// everywhere). Where no double lies between two parameters, the segment's length is taken as the
// distance. After a segment that misses the tolerance it halves no others. `off` receives the
// largest distance of all samples.
std::vector<CurveSample> sample_adaptively(const std::function<Eigen::Vector3d(double)>& point,
                                           double first, double last, int n_pieces,
                                           double tolerance,
                                           std::size_t max_points = most_curve_points,
                                           double* off = nullptr);

}  // namespace poinsot
