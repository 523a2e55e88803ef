#include "construction/herpolhode.h"

#include <algorithm>
#include <cmath>

#include "construction/adaptive_curve.h"

namespace poinsot {

double Herpolhode::index_at(double time_s) const {
    if (times_s.size() < 2) return 0.0;
    const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
    if (after == times_s.begin()) return 0.0;
    if (after == times_s.end()) return static_cast<double>(times_s.size() - 1);
    const auto i = after - times_s.begin() - 1;
    const double from = times_s[static_cast<std::size_t>(i)];
    return static_cast<double>(i) + (time_s - from) / (*after - from);
}

namespace {

Eigen::Vector3d foot_of(const PoinsotConstruction& construction) {
    return -construction.plane_distance() * construction.vertical_space();
}

Eigen::Vector3d point_from_foot(const PoinsotConstruction& construction, const Motion& motion,
                                double time_s) {
    const MotionSample sample =
        motion.sample(time_s, {.attitude = false, .herpolhode = true, .euler_angles = false});
    return construction.contact_in_plane(sample.herpolhode_space);
}

}  // namespace

Eigen::Vector3d herpolhode_point(const PoinsotConstruction& construction, const Motion& motion,
                                 double time_s) {
    return point_from_foot(construction, motion, time_s) + foot_of(construction);
}

Herpolhode sample_herpolhode(const PoinsotConstruction& construction, const Motion& motion,
                             double first_time_s, double last_time_s, double shortest_feature_s,
                             double tolerance, std::size_t max_points) {
    // Pieces of one length from the first instant on, a power of two so that their ends do not
    // depend on how many follow; too many of them for max_points share the stretch instead.
    const double span = last_time_s - first_time_s;
    const double piece_s = std::exp2(std::floor(std::log2(0.5 * shortest_feature_s)));
    const double wanted = std::ceil(span / piece_s);
    const double n_pieces = std::clamp(wanted, 0.0, static_cast<double>(max_points) / 4.0);
    const double end_s = wanted <= n_pieces ? first_time_s + piece_s * n_pieces : last_time_s;

    Herpolhode curve;
    curve.foot = foot_of(construction);
    const auto samples = sample_adaptively(
        [&](double t) {
            ++curve.n_evaluations;
            return point_from_foot(construction, motion, t);
        },
        first_time_s, end_s, static_cast<int>(n_pieces), tolerance, max_points);

    curve.times_s.reserve(samples.size());
    curve.points.reserve(samples.size());
    for (const CurveSample& sample : samples) {
        curve.times_s.push_back(sample.parameter);
        curve.points.push_back(sample.point);
    }
    return curve;
}

}  // namespace poinsot
