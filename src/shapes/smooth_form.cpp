#include "shapes/smooth_form.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace poinsot {

namespace {

constexpr std::size_t most_pieces = std::size_t{1} << 20U;

// Hermite's cubic by its Bézier points.
CubicPiece hermite(double from, const CurveFlow& begin, double to, const CurveFlow& end) {
    const double third = (to - from) / 3.0;
    return {from,
            to,
            {begin.position, begin.position + third * begin.velocity,
             end.position - third * end.velocity, end.position}};
}

// Appends the cubics of a curve from the end of one to the next, and notes how far off they are.
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

// The arc of a conic by Bézier points whose tangents are the conic's. On a unit circle it is
// outside by (4/27)·sin⁶(θ/4)/cos²(θ/4) at most, θ being the arc's angle.
CubicPiece arc_of(const Conic& conic, double first, double last) {
    const double handle = 4.0 / 3.0 * std::tan(0.25 * (last - first));
    const auto velocity = [&](double s) -> Eigen::Vector3d {
        return conic.sine_axis * std::cos(s) - conic.cosine_axis * std::sin(s);
    };
    const Eigen::Vector3d begin = conic.at(first), end = conic.at(last);
    return {
        first, last, {begin, begin + handle * velocity(first), end - handle * velocity(last), end}};
}

// How far those Bézier points' cubic is from the arc, for a circle of radius 1.
double arc_error(double angle) {
    const double sine = std::sin(0.25 * angle), cosine = std::cos(0.25 * angle);
    return 4.0 / 27.0 * std::pow(sine, 6) / (cosine * cosine);
}

std::vector<CubicPiece> arcs_between(const Conic& conic, double first, double last,
                                     double tolerance) {
    const double size = std::hypot(conic.cosine_axis.norm(), conic.sine_axis.norm());
    // No arc is longer than a quarter turn, so that a cubic has its shape.
    std::size_t n = static_cast<std::size_t>(
        std::max(1.0, std::ceil((last - first) / (0.5 * std::numbers::pi) - 1e-9)));
    while (n < most_pieces && size * arc_error((last - first) / static_cast<double>(n)) > tolerance)
        n *= 2;
    std::vector<CubicPiece> arcs;
    for (std::size_t k = 0; k < n; ++k) {
        const auto at = [&](std::size_t i) {
            return i == n
                       ? last
                       : first + (last - first) * static_cast<double>(i) / static_cast<double>(n);
        };
        arcs.push_back(arc_of(conic, at(k), at(k + 1)));
    }
    return arcs;
}

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

CubicPiece CubicPiece::part(double first, double last) const {
    // The blossom of the cubic at (first, first, first) … (last, last, last), by de Casteljau.
    const auto blossom = [&](double s0, double s1, double s2) {
        std::array<Eigen::Vector3d, 4> p = points;
        int n = 3;
        for (const double s : {s0, s1, s2}) {
            const double t = to > from ? (s - from) / (to - from) : 0.0;
            for (int i = 0; i < n; ++i) {
                const auto k = static_cast<std::size_t>(i);
                p[k] = (1.0 - t) * p[k] + t * p[k + 1];
            }
            --n;
        }
        return p[0];
    };
    return {first,
            last,
            {blossom(first, first, first), blossom(first, first, last), blossom(first, last, last),
             blossom(last, last, last)}};
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
        // The largest factor by which the map stretches anything.
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

std::vector<CubicPiece> cubics_between(const SmoothForm& smooth, double first, double last,
                                       double tolerance) {
    if (!(first < last)) return {};
    if (const Conic* conic = std::get_if<Conic>(&smooth.form))
        return arcs_between(*conic, first, last, tolerance);
    std::vector<CubicPiece> cut;
    for (const CubicPiece& piece : std::get<std::vector<CubicPiece>>(smooth.form)) {
        const double from = std::max(piece.from, first), to = std::min(piece.to, last);
        if (from >= to) continue;
        cut.push_back(from == piece.from && to == piece.to ? piece : piece.part(from, to));
    }
    return cut;
}

}  // namespace poinsot
