#include "render/quadric.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot {
namespace {

// A polygon with its corners on the ellipse middle + cos·a + sin·b.
PixelPolygon polygon_in(const Eigen::Vector2d& middle, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
    constexpr int n = PixelPolygon::most_corners;
    PixelPolygon polygon;
    for (int k = 0; k < n; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n;
        polygon.add(middle + std::cos(angle) * a + std::sin(angle) * b);
    }
    return polygon;
}

}  // namespace

Quadric::Quadric(const Ellipsoid& ellipsoid, const Projection& projection)
    : UnitSphere(ellipsoid),
      depth(projection.depth(centre)),
      presence(ellipsoid.presence),
      hiding(ellipsoid.opacity * ellipsoid.presence),
      hiding_far(ellipsoid.hides_far_curves ? ellipsoid.presence : hiding) {
    const Projection& view = projection;
    const bool before_eye = !view.perspective || depth > view.near_depth;
    anchor_px = before_eye ? view.place(centre) : view.centre;
    gx = to_u * view.right / view.focal;
    gy = to_u * view.down / view.focal;
    depth_change = axes.transpose() * view.forward;
    const Eigen::Vector3d origin = to_u * (view.ray_origin(anchor_px) - centre);
    d0 = to_u * view.ray(anchor_px);
    m0 = origin.cross(d0);
    if (view.perspective) {
        dx = gx;
        dy = gy;
        mx = origin.cross(gx);
        my = origin.cross(gy);
        eye_u = origin;
    } else {
        dx = dy = Eigen::Vector3d::Zero();
        mx = gx.cross(d0);
        my = gy.cross(d0);
        eye_u = -d0.normalized();
    }
    const double scale = 1.0 / d0.norm();
    for (Eigen::Vector3d* v : {&d0, &dx, &dy, &m0, &mx, &my}) *v *= scale;

    // The outline: the conic |d|² - |m|² = c + 2 g·p + p·H p = 0.
    Eigen::Matrix2d h;
    h << dx.dot(dx) - mx.dot(mx), dx.dot(dy) - mx.dot(my), dx.dot(dy) - mx.dot(my),
        dy.dot(dy) - my.dot(my);
    const Eigen::Vector2d g(d0.dot(dx) - m0.dot(mx), d0.dot(dy) - m0.dot(my));
    const double c = d0.squaredNorm() - m0.squaredNorm();
    const double reach = depth_change.norm();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(h);
    const Eigen::Vector2d& values = solver.eigenvalues();
    if (view.perspective && depth + reach <= view.near_depth) {
        seen = false;
        return;
    }
    if (values.maxCoeff() >= 0.0 || (view.perspective && depth - reach <= view.near_depth)) {
        outline = polygon_of(box_of(view));
        return;
    }
    const Eigen::Vector2d middle = -h.inverse() * g;
    const double height = c + g.dot(middle);
    if (!(height > 0.0)) {
        seen = false;
        return;
    }
    const Eigen::Vector2d half_px = (height / -values.array()).sqrt();
    narrow = solver.eigenvectors().col(0);
    narrow_bend = 2.0 * values[0];
    narrow_px = half_px[0];
    wide_px = half_px[1];
    const Eigen::Vector2d wide = solver.eigenvectors().col(1);
    const double about = 1.0 / std::cos(std::numbers::pi / PixelPolygon::most_corners);
    constexpr double margin_px = 1.5;
    outline = polygon_in(anchor_px + middle, about * (half_px[0] + margin_px) * narrow,
                         about * (half_px[1] + margin_px) * wide);
    // Axes shorter by this amount move the edge inwards by at least 2 inset √(ab)/(a + b), here 0.9
    // px. The inset is three line widths, since the core computes a line's distance from the
    // derivatives of u.
    constexpr double least_inset_px = 3.0, narrowest_px = 24.0, longest = 40.0;
    // The contour lies outside of the core.
    const double per_inset = 2.0 * std::sqrt(half_px[0] * half_px[1]) / half_px.sum();
    const double contour_inset_px = (ellipsoid.contour_px + 0.9) / per_inset;
    const double inset_px = std::min(
        std::max({least_inset_px, 3.0 * ellipsoid.section_px, contour_inset_px}), 0.5 * half_px[0]);
    if (half_px[0] > narrowest_px && half_px[1] < longest * half_px[0])
        core = polygon_in(anchor_px + middle, (half_px[0] - inset_px) * narrow,
                          (half_px[1] - inset_px) * wide);
    seen = !outline.box.within(box_of(view)).empty();
}

double Quadric::limb_cosine() const {
    // The cosine grows as the square root of the distance from the limb.
    return std::clamp(std::sqrt(0.2 / std::max(narrow_px, 1e-6)), 1e-3, 0.5);
}

}  // namespace poinsot
