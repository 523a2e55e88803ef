#include "construction/adaptive_curve.h"

#include <algorithm>

namespace poinsot {

double distance_from_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                             const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from;
    const double length2 = along.squaredNorm();
    if (length2 == 0.0) return (point - from).norm();
    const double s = std::clamp((point - from).dot(along) / length2, 0.0, 1.0);
    return (point - (from + s * along)).norm();
}

namespace {

class AdaptiveSampler {
 public:
    AdaptiveSampler(const std::function<Eigen::Vector3d(double)>& point, double tolerance,
                    std::size_t max_points)
        : point_(point), tolerance_(tolerance), max_points_(max_points) {}

    CurveSample at(double parameter) const { return {parameter, point_(parameter), 0.0}; }

    // Appends the samples after `from` up to and including `to`; the caller's test has already
    // computed the middle.
    void subdivide(const CurveSample& from, const CurveSample& to, int depth) {
        const double half = 0.5 * (to.parameter - from.parameter);
        const CurveSample middle = at(from.parameter + half);
        const CurveSample first_quarter = at(from.parameter + 0.5 * half);
        const CurveSample last_quarter = at(from.parameter + 1.5 * half);
        const bool is_resolved = from.parameter < first_quarter.parameter &&
                                 first_quarter.parameter < middle.parameter &&
                                 middle.parameter < last_quarter.parameter &&
                                 last_quarter.parameter < to.parameter;
        double off = std::max({distance_from_segment(middle.point, from.point, to.point),
                               distance_from_segment(first_quarter.point, from.point, to.point),
                               distance_from_segment(last_quarter.point, from.point, to.point)});
        // Between its quarter points a cubic may be farther off by at most 9.4 % of that, near 3/8
        // or 5/8; these points are tested if this could exceed the tolerance.
        constexpr double hidden = 1.0 / 1.094;
        if (is_resolved && off <= tolerance_ && off > hidden * tolerance_)
            for (const double eighths : {0.75, 1.25})
                off = std::max(off, distance_from_segment(point_(from.parameter + eighths * half),
                                                          from.point, to.point));
        if (!is_resolved) off = std::max(off, (to.point - from.point).norm());
        // Where one segment has missed the tolerance the curve is lost, and halving others, for
        // instance of rounding noise, is work for nothing.
        const bool is_lost = !(curve.off <= tolerance_);
        if (off <= tolerance_ || !is_resolved || depth == 0 || is_lost ||
            curve.samples.size() >= max_points_) {
            // NaN does not count as within the tolerance.
            if (!(off <= curve.off)) curve.off = off;
            curve.samples.push_back({to.parameter, to.point, off});
            return;
        }
        subdivide(from, middle, depth - 1);
        subdivide(middle, to, depth - 1);
    }

    SampledCurve curve;

 private:
    const std::function<Eigen::Vector3d(double)>& point_;
    double tolerance_;
    std::size_t max_points_;
};

}  // namespace

SampledCurve sample_adaptively(const std::function<Eigen::Vector3d(double)>& point,
                               const SamplingChoices& choices) {
    const auto& [first, last, n_pieces, tolerance, max_points] = choices;
    AdaptiveSampler sampler(point, tolerance, max_points);
    CurveSample from = sampler.at(first);
    sampler.curve.samples.push_back(from);
    if (!(last > first)) return sampler.curve;

    constexpr int deepest = 24;
    for (int k = 1; k <= n_pieces; ++k) {
        const double parameter = k == n_pieces ? last : first + (last - first) * k / n_pieces;
        const CurveSample to = sampler.at(parameter);
        sampler.subdivide(from, to, deepest);
        from = to;
    }
    return sampler.curve;
}

}  // namespace poinsot
