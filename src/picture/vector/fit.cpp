#include "vector/fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace poinsot::vector {

namespace {

constexpr std::size_t most_beziers = std::size_t{1} << 16U;
constexpr int deepest = 24;

Eigen::Vector2d slope(const Bezier& b, double t) {
    const double u = 1.0 - t;
    return 3.0 * (u * u * (b[1] - b[0]) + 2.0 * u * t * (b[2] - b[1]) + t * t * (b[3] - b[2]));
}

// The parameter of the nearest point of the Bézier, from a first guess: there the difference is
// perpendicular to the tangent.
double beside(const Bezier& bezier, const Eigen::Vector2d& point, double t) {
    for (int k = 0; k < 4; ++k) {
        const Eigen::Vector2d along = slope(bezier, t);
        const double square = along.squaredNorm();
        if (!(square > 0.0)) break;
        t = std::clamp(t + (point - at(bezier, t)).dot(along) / square, 0.0, 1.0);
    }
    return t;
}

// Fits parts of a curve.
class Fitter {
 public:
    Fitter(const std::function<PaperFlow(double)>& curve, double tolerance_pt)
        : curve_(curve), tolerance_pt_(tolerance_pt) {}

    void fit(double from, const PaperFlow& begin, double to, const PaperFlow& end, int depth) {
        const auto [bezier, off_pt] = nearest(from, begin, to, end);
        if (off_pt <= tolerance_pt_ || depth == 0 || fit_.beziers.size() >= most_beziers) {
            fit_.off_pt = std::max(fit_.off_pt, off_pt);
            fit_.beziers.push_back(bezier);
            return;
        }
        const double middle = 0.5 * (from + to);
        const PaperFlow at_middle = curve_(middle);
        fit(from, begin, middle, at_middle, depth - 1);
        fit(middle, at_middle, to, end, depth - 1);
    }

    Fit take() { return std::move(fit_); }

 private:
    static constexpr int n_samples = 15;

    struct Nearest {
        Bezier bezier;
        double off_pt;
    };

    Nearest nearest(double from, const PaperFlow& begin, double to, const PaperFlow& end) const {
        std::array<Eigen::Vector2d, n_samples> points;
        std::array<double, n_samples> places;
        for (std::size_t k = 0; k < n_samples; ++k) {
            places[k] = (static_cast<double>(k) + 1.0) / (n_samples + 1.0);
            points[k] = curve_(from + places[k] * (to - from)).position;
        }
        const double third = (to - from) / 3.0;
        const Eigen::Vector2d leaving = third * begin.velocity, arriving = third * end.velocity;
        // The lengths of both handles, in units of the Hermite handles.
        Eigen::Vector2d lengths(1.0, 1.0);
        const auto bezier_of = [&](const Eigen::Vector2d& l) {
            return Bezier{begin.position, begin.position + l.x() * leaving,
                          end.position - l.y() * arriving, end.position};
        };
        Bezier bezier = bezier_of(lengths);
        for (int round = 0; round < 5; ++round) {
            Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
            Eigen::Vector2d sums = Eigen::Vector2d::Zero();
            for (std::size_t k = 0; k < n_samples; ++k) {
                const double t = places[k] = beside(bezier, points[k], places[k]);
                const Eigen::Vector2d along = slope(bezier, t).normalized();
                const Eigen::Vector2d across(-along.y(), along.x());
                const double u = 1.0 - t;
                const Eigen::Vector2d change(3.0 * u * u * t * across.dot(leaving),
                                             -3.0 * u * t * t * across.dot(arriving));
                squares += change * change.transpose();
                sums += change * across.dot(points[k] - at(bezier, t));
            }
            // For a straight piece the lengths are undetermined: keep them.
            const double trace = squares.trace();
            if (!(trace > 0.0) || squares.determinant() < 1e-12 * trace * trace) break;
            const Eigen::Vector2d better = lengths + squares.inverse() * sums;
            // Handles that point backwards or are too long would make loops.
            if (!(better.minCoeff() > 0.1 && better.maxCoeff() < 5.0)) break;
            lengths = better;
            bezier = bezier_of(lengths);
        }
        double worst = 0.0;
        for (std::size_t k = 0; k < n_samples; ++k) {
            places[k] = beside(bezier, points[k], places[k]);
            worst = std::max(worst, (points[k] - at(bezier, places[k])).norm());
        }
        return {bezier, 1.5 * worst};
    }

    const std::function<PaperFlow(double)>& curve_;
    double tolerance_pt_;
    Fit fit_;
};

// Whether two tangents have the same direction.
bool is_smooth(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const double cross = a.x() * b.y() - a.y() * b.x();
    return a.dot(b) > 0.0 && std::abs(cross) < 1e-5 * a.norm() * b.norm();
}

}  // namespace

Eigen::Vector2d at(const Bezier& b, double t) {
    const double u = 1.0 - t;
    return u * u * u * b[0] + 3.0 * u * u * t * b[1] + 3.0 * u * t * t * b[2] + t * t * t * b[3];
}

Fit fitted(const std::function<PaperFlow(double)>& curve, std::span<const double> knots,
           double tolerance_pt) {
    Fitter fitter(curve, tolerance_pt);
    if (knots.size() < 2) return {};
    // At a corner, the tangents a tiny step before and after the knot differ.
    const auto beside_knot = [&](double knot, double other) {
        return curve(knot + 1e-9 * (other - knot));
    };
    double from = knots.front();
    for (std::size_t k = 1; k < knots.size(); ++k) {
        const bool last = k + 1 == knots.size();
        if (!last) {
            const PaperFlow before = beside_knot(knots[k], knots[k - 1]);
            const PaperFlow after = beside_knot(knots[k], knots[k + 1]);
            if (is_smooth(before.velocity, after.velocity)) continue;
        }
        fitter.fit(from, beside_knot(from, knots[k]), knots[k], beside_knot(knots[k], from),
                   deepest);
        from = knots[k];
    }
    return fitter.take();
}

}  // namespace poinsot::vector
