#include "construction/timed_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "construction/adaptive_curve.h"
#include "mechanics/motion_problem.h"

namespace poinsot {

double TimedPath::index_at(double time_s) const {
    if (times_s.size() < 2) return 0.0;
    const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
    if (after == times_s.begin()) return 0.0;
    if (after == times_s.end()) return static_cast<double>(times_s.size() - 1);
    const auto i = after - times_s.begin() - 1;
    const double from = times_s[static_cast<std::size_t>(i)];
    return static_cast<double>(i) + (time_s - from) / (*after - from);
}

TimedPath sample_path(const std::function<Eigen::Vector3d(double)>& point, double first_time_s,
                      double last_time_s, double shortest_feature_s, double tolerance,
                      std::size_t max_points) {
    // Pieces of one length from the first instant on, a power of two so that their ends do not
    // depend on how many follow.
    const double span = last_time_s - first_time_s;
    // If the motion is so slow that the span is a small part of a piece, the piece is shorter: a
    // stepped motion is not stepped far beyond its end.
    const double longest_s = span > 0.0 ? longest_piece_spans * span : HUGE_VAL;
    const double piece_s =
        std::exp2(std::floor(std::log2(std::min(0.5 * shortest_feature_s, longest_s))));
    const double n_pieces = std::max(0.0, std::ceil(span / piece_s));

    TimedPath path;
    const auto counted = [&](double t) {
        ++path.n_evaluations;
        return point(t);
    };
    if (!(n_pieces <= static_cast<double>(max_points) / 4.0)) {
        // In longer pieces, the tested points might all lie at the same phase of the path.
        path.times_s = {first_time_s};
        path.points = {counted(first_time_s)};
        path.offs = {0.0};
        path.off = std::numeric_limits<double>::infinity();
        return path;
    }
    const auto [samples, off] =
        sample_adaptively(counted, {.first = first_time_s,
                                    .last = first_time_s + piece_s * n_pieces,
                                    .n_pieces = static_cast<int>(n_pieces),
                                    .tolerance = tolerance,
                                    .max_points = max_points});
    path.off = off;

    path.times_s.reserve(samples.size());
    path.points.reserve(samples.size());
    path.offs.reserve(samples.size());
    for (const CurveSample& sample : samples) {
        path.times_s.push_back(sample.parameter);
        path.points.push_back(sample.point);
        path.offs.push_back(sample.off);
    }
    return path;
}

}  // namespace poinsot
