#include "drawing/stage/smooth_paths.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace poinsot {

namespace {

// Number of points per initial cubic: the points resolve the curve, and cubics need fewer.
constexpr std::size_t points_a_piece = 8;

SmoothForm fitted(const std::function<CurveFlow(double)>& flow, std::vector<double> parameters,
                  double tolerance) {
    std::vector<double> knots;
    for (std::size_t i = 0; i < parameters.size(); i += points_a_piece)
        knots.push_back(parameters[i]);
    if (!parameters.empty() && knots.back() < parameters.back()) knots.push_back(parameters.back());
    SmoothForm smooth;
    smooth.form = cubics_through(flow, knots, tolerance, smooth.off);
    smooth.parameters = std::move(parameters);
    return smooth;
}

}  // namespace

SmoothMaker smooth_circle(const Eigen::Vector3d& centre, double radius, std::size_t n_points) {
    return [centre, radius, n_points](double) {
        SmoothForm smooth;
        smooth.form =
            Conic{centre, radius * Eigen::Vector3d::UnitX(), radius * Eigen::Vector3d::UnitY()};
        for (std::size_t k = 0; k <= n_points; ++k)
            smooth.parameters.push_back(2.0 * std::numbers::pi * static_cast<double>(k) /
                                        static_cast<double>(n_points));
        return smooth;
    };
}

SmoothMaker smooth_polhode(const Polhode& polhode, double points_tolerance) {
    return [polhode, points_tolerance](double tolerance) {
        std::vector<double> parameters;
        const SampledCurve sampled = polhode.samples(points_tolerance);
        for (const CurveSample& sample : sampled.samples) parameters.push_back(sample.parameter);
        if (const auto circle = polhode.circle())
            return SmoothForm{Conic{circle->centre, circle->cosine_axis, circle->sine_axis},
                              std::move(parameters)};
        return fitted(
            [&](double chi) {
                return CurveFlow{polhode.at(chi), polhode.tangent(chi)};
            },
            std::move(parameters), tolerance);
    };
}

SmoothMaker smooth_path(std::function<CurveFlow(double time_s)> flow, std::vector<double> times_s) {
    return [flow = std::move(flow), times_s = std::move(times_s)](double tolerance) {
        return fitted(flow, times_s, tolerance);
    };
}

}  // namespace poinsot
