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

struct SampledCurve {
    std::vector<CurveSample> samples;  // in ascending order of their parameters, with both ends
    double off = 0.0;                  // the largest distance of all samples
};

struct SamplingChoices {
    double first = 0.0, last = 1.0;  // of the parameter
    int n_pieces = 16;               // equal pieces to begin with
    double tolerance = 1e-3;
    std::size_t max_points = most_curve_points;
};

// Samples point(parameter) over [first, last]. Halves each piece until the curve at its quarter
// points, and where it might be farther off between them, is within `tolerance` of the chord. With
// max_points samples the tolerance may not be reached everywhere. Where no double lies between two
// parameters, the segment's length is taken as the distance. After a segment that misses the
// tolerance it halves no others.
SampledCurve sample_adaptively(const std::function<Eigen::Vector3d(double)>& point,
                               const SamplingChoices& choices);

}  // namespace poinsot
