#include "shapes/smooth_form.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

namespace poinsot {

namespace {

constexpr std::size_t most_pieces = std::size_t{1} << 20U;

// The Hermite cubic by its Bézier points.
CubicPiece hermite(double from, const CurveFlow& begin, double to, const CurveFlow& end) {
    const double third = (to - from) / 3.0;
    return {from,
            to,
            {begin.position, begin.position + third * begin.velocity,
             end.position - third * end.velocity, end.position}};
}

// Appends the cubics of a curve one after the other, and records their largest deviation.
class CubicFitter {
 public:
    CubicFitter(const std::function<CurveFlow(double)>& curve, double tolerance)
        : curve_(curve), tolerance_(tolerance) {}

    void fit(double from, const CurveFlow& begin, double to, const CurveFlow& end, int depth) {
        const CubicPiece piece = hermite(from, begin, to, end);
        const double middle = 0.5 * (from + to);
        const CurveFlow at_middle = curve_(middle);
        double off = (at_middle.position - piece.at(middle)).norm();
        for (const double s : {0.75 * from + 0.25 * to, 0.25 * from + 0.75 * to})
            off = std::max(off, (curve_(s).position - piece.at(s)).norm());
        off *= 1.25;
        if (off <= tolerance_ || depth == 0 || pieces.size() >= most_pieces) {
            worst_off = std::max(worst_off, off);
            pieces.push_back(piece);
            return;
        }
        fit(from, begin, middle, at_middle, depth - 1);
        fit(middle, at_middle, to, end, depth - 1);
    }

    std::vector<CubicPiece> pieces;
    double worst_off = 0.0;

 private:
    const std::function<CurveFlow(double)>& curve_;
    double tolerance_;
};

}  // namespace

Eigen::Vector3d Conic::at(double s) const {
    return centre + cosine_axis * std::cos(s) + sine_axis * std::sin(s);
}

Eigen::Vector3d CubicPiece::at(double s) const {
    const double t = to > from ? (s - from) / (to - from) : 0.0;
    const double u = 1.0 - t;
    return u * u * u * points[0] + 3.0 * u * u * t * points[1] + 3.0 * u * t * t * points[2] +
           t * t * t * points[3];
}

Eigen::Vector3d SmoothForm::at(double s) const {
    if (const Conic* conic = std::get_if<Conic>(&form)) return conic->at(s);
    const auto& pieces = std::get<std::vector<CubicPiece>>(form);
    if (pieces.empty()) return Eigen::Vector3d::Zero();
    const auto after = std::upper_bound(pieces.begin(), pieces.end(), s,
                                        [](double x, const CubicPiece& p) { return x < p.from; });
    return (after == pieces.begin() ? *after : *std::prev(after)).at(s);
}

double SmoothForm::parameter_at(double point) const {
    if (parameters.empty()) return 0.0;
    const double last = static_cast<double>(parameters.size() - 1);
    const double clamped = std::clamp(point, 0.0, last);
    const double whole = std::floor(clamped);
    const auto i = static_cast<std::size_t>(whole);
    if (i + 1 >= parameters.size()) return parameters.back();
    return parameters[i] + (clamped - whole) * (parameters[i + 1] - parameters[i]);
}

SmoothMaker placed(SmoothMaker maker, const Eigen::Affine3d& map) {
    return [maker = std::move(maker), map](double tolerance) {
        // The largest stretch of the map.
        const double stretch = map.linear().jacobiSvd().singularValues()[0];
        SmoothForm smooth = maker(tolerance / stretch);
        smooth.off *= stretch;
        if (Conic* conic = std::get_if<Conic>(&smooth.form)) {
            conic->centre = map * conic->centre;
            conic->cosine_axis = map.linear() * conic->cosine_axis;
            conic->sine_axis = map.linear() * conic->sine_axis;
            return smooth;
        }
        for (CubicPiece& piece : std::get<std::vector<CubicPiece>>(smooth.form))
            for (Eigen::Vector3d& point : piece.points) point = map * point;
        return smooth;
    };
}

std::vector<CubicPiece> cubics_through(const std::function<CurveFlow(double)>& curve,
                                       std::span<const double> knots, double tolerance,
                                       double& off) {
    CubicFitter fitter(curve, tolerance);
    constexpr int deepest = 20;
    if (!knots.empty()) {
        CurveFlow begin = curve(knots.front());
        for (std::size_t k = 1; k < knots.size(); ++k) {
            const CurveFlow end = curve(knots[k]);
            fitter.fit(knots[k - 1], begin, knots[k], end, deepest);
            begin = end;
        }
    }
    off = fitter.worst_off;
    return std::move(fitter.pieces);
}

}  // namespace poinsot
