#include "vector/conic.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::vector {

namespace {

using std::numbers::pi;

}  // namespace

Eigen::Vector2d PaperEllipse::at(double t) const {
    return centre + a * std::cos(t) + b * std::sin(t);
}

Eigen::Affine2d PaperEllipse::paper_from_circle() const {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    map.linear() << a, b;
    map.translation() = centre;
    return map;
}

double PaperEllipse::radius_of(const Eigen::Vector2d& point) const {
    Eigen::Matrix2d axes;
    axes << a, b;
    return (axes.inverse() * (point - centre)).norm();
}

std::optional<PaperEllipse> picture_of(const Conic& conic, const Projection& projection) {
    // Homogeneous coordinates on paper, relative to the view's axis, are linear in (cos s, sin s,
    // 1).
    const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector2d {
        return projection.focal * Eigen::Vector2d(projection.right.dot(v), projection.down.dot(v));
    };
    const Eigen::Vector3d from_eye = conic.centre - projection.eye;
    const double cosine_depth =
        projection.perspective ? projection.forward.dot(conic.cosine_axis) : 0.0;
    const double sine_depth =
        projection.perspective ? projection.forward.dot(conic.sine_axis) : 0.0;
    const double depth = projection.perspective ? projection.forward.dot(from_eye) : 1.0;
    const double swing = std::hypot(cosine_depth, sine_depth);
    if (projection.perspective && depth - swing <= projection.near_depth) return std::nullopt;

    // Shift the angle so that the depth is depth + swing·cos s. Tangents at s = 0 and π are then
    // parallel on paper, so these points are the ends of a diameter, and the sine's axis is
    // conjugate to it.
    const double c = swing > 0.0 ? cosine_depth / swing : 1.0;
    const double s = swing > 0.0 ? sine_depth / swing : 0.0;
    const Eigen::Vector2d middle = across(from_eye);
    const Eigen::Vector2d ahead = across(c * conic.cosine_axis + s * conic.sine_axis);
    const Eigen::Vector2d aside = across(c * conic.sine_axis - s * conic.cosine_axis);
    const Eigen::Vector2d far = (middle + ahead) / (depth + swing);
    const Eigen::Vector2d near = (middle - ahead) / (depth - swing);
    const PaperEllipse ellipse{projection.centre + 0.5 * (far + near), 0.5 * (far - near),
                               aside / std::sqrt((depth - swing) * (depth + swing))};
    const double area = ellipse.a.x() * ellipse.b.y() - ellipse.a.y() * ellipse.b.x();
    if (std::abs(area) < 1e-12 * (ellipse.a.squaredNorm() + ellipse.b.squaredNorm()))
        return std::nullopt;
    return ellipse;
}

std::optional<Conic> limb_of(const SphereSight& sphere) {
    if (sphere.surrounds_eye) return std::nullopt;
    const double square = sphere.eye_u.squaredNorm();
    const Eigen::Vector3d towards = sphere.eye_u.normalized();
    const Eigen::Vector3d across = towards.unitOrthogonal();
    const Eigen::Vector3d middle =
        sphere.perspective ? Eigen::Vector3d(sphere.eye_u / square) : Eigen::Vector3d::Zero();
    const double radius = sphere.perspective ? std::sqrt(1.0 - 1.0 / square) : 1.0;
    return Conic{sphere.centre + sphere.axes * middle, radius * (sphere.axes * across),
                 radius * (sphere.axes * towards.cross(across))};
}

std::vector<Bezier> beziers_of(const PaperEllipse& ellipse, double tolerance_pt, double& off_pt) {
    Eigen::Matrix2d axes;
    axes << ellipse.a, ellipse.b;
    // The Frobenius norm bounds the longest half-axis.
    const double longest = axes.norm();
    const auto error = [longest](int n_arcs) {
        const double quarter = 0.25 * (2.0 * pi / n_arcs);
        return longest * 4.0 / 27.0 * std::pow(std::sin(quarter), 6) /
               (std::cos(quarter) * std::cos(quarter));
    };
    int n = 4;
    while (n < 4096 && error(n) > tolerance_pt) n += 2;
    off_pt = std::max(off_pt, error(n));
    std::vector<Bezier> beziers = arc_of(ellipse, 0.0, 2.0 * pi, n);
    beziers.back()[3] = beziers.front()[0];
    return beziers;
}

std::optional<PaperEllipse> ellipse_through(std::span<const Eigen::Vector2d> points) {
    const double n = static_cast<double>(points.size());
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points) middle += point / n;
    double square = 0.0;
    for (const Eigen::Vector2d& point : points) square += (point - middle).squaredNorm() / n;
    if (!(square > 0.0)) return {};
    const double size = std::sqrt(square);
    Eigen::Matrix<double, 5, 5> squares = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Matrix<double, 5, 1> sums = Eigen::Matrix<double, 5, 1>::Zero(), terms;
    for (const Eigen::Vector2d& point : points) {
        const Eigen::Vector2d p = (point - middle) / size;
        terms << p.x() * p.x(), 2.0 * p.x() * p.y(), p.y() * p.y(), p.x(), p.y();
        squares += terms * terms.transpose();
        sums += terms;
    }
    const Eigen::Matrix<double, 5, 1> conic = squares.ldlt().solve(sums);
    Eigen::Matrix2d A;
    A << conic[0], conic[1], conic[1], conic[2];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(A);
    constexpr double flattest = 1e-8;
    if (!(axes.eigenvalues().minCoeff() > flattest * axes.eigenvalues().maxCoeff())) return {};
    const Eigen::Vector2d centre = -0.5 * A.inverse() * conic.tail<2>();
    const Eigen::Matrix2d half_axes =
        size * std::sqrt(1.0 + centre.dot(A * centre)) * axes.operatorInverseSqrt();
    return PaperEllipse{middle + size * centre, half_axes.col(0), half_axes.col(1)};
}

std::vector<Bezier> arc_of(const PaperEllipse& ellipse, double from, double to, int n) {
    const double handle = 4.0 / 3.0 * std::tan(0.25 * (to - from) / n);
    const auto slope = [&](double t) -> Eigen::Vector2d {
        return ellipse.b * std::cos(t) - ellipse.a * std::sin(t);
    };
    std::vector<Bezier> beziers;
    for (int k = 0; k < n; ++k) {
        const double s = from + (to - from) * k / n, t = from + (to - from) * (k + 1) / n;
        beziers.push_back({ellipse.at(s), ellipse.at(s) + handle * slope(s),
                           ellipse.at(t) - handle * slope(t), ellipse.at(t)});
    }
    return beziers;
}

Track track_of(const Conic& conic, double first, double last) {
    Track track;
    track.flow = [conic](double s) {
        return CurveFlow{conic.at(s),
                         conic.sine_axis * std::cos(s) - conic.cosine_axis * std::sin(s)};
    };
    const int n = std::max(1, static_cast<int>(std::ceil((last - first) / (0.5 * pi) - 1e-9)));
    for (int k = 0; k <= n; ++k)
        track.knots.push_back(k == n ? last : first + (last - first) * k / n);
    return track;
}

}  // namespace poinsot::vector
