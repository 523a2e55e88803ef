#include "drawing/figures/elements/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/framing.h"

namespace poinsot {

namespace {

// A point's circle about L: its radius and height.
using Circle = Eigen::Vector2d;

// Adds the circles that reach farthest in some direction of the half-plane (radius, height): those
// inside their convex hull cannot be seen outside of it.
void add_outermost(const std::vector<Circle>& circles, std::vector<Circle>& to) {
    constexpr int n_directions = 24;
    for (int k = 0; k <= n_directions; ++k) {
        const double angle = std::numbers::pi * (1.0 * k / n_directions - 0.5);
        const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
        to.push_back(*std::max_element(
            circles.begin(), circles.end(),
            [&](const auto& a, const auto& b) { return a.dot(direction) < b.dot(direction); }));
    }
}

}  // namespace

std::vector<Eigen::Vector3d> swept_points(const ConstructionPicture& picture,
                                          const SweptShapes& shapes, double azimuth_rad,
                                          double beyond) {
    const InertiaTensor& inertia = picture.construction.inertia();
    const Eigen::Vector3d moments = inertia.moments_kg_m2() / inertia.moments_kg_m2().maxCoeff();
    const std::vector<Eigen::Vector3d> surface =
        points_of_ellipsoid(picture.half_axes.asDiagonal().toDenseMatrix());

    // Up to a rotation about L, the attitude is determined by the direction of L in the body.
    std::vector<Circle> circles;
    const Polhode& polhode = picture.polhode;
    constexpr int n_attitudes = 24;
    for (int k = 0; k <= n_attitudes; ++k) {
        const double chi = polhode.first_chi_rad() +
                           (polhode.last_chi_rad() - polhode.first_chi_rad()) * k / n_attitudes;
        const Eigen::Vector3d rho =
            (inertia.body_from_principal().transpose() * polhode.at(chi)) * picture.picture_per_rho;
        const Eigen::Vector3d normal = moments.cwiseProduct(rho).stableNormalized();
        const auto circle_of = [&](const Eigen::Vector3d& point) {
            const double along = point.dot(normal);
            return Circle((point - along * normal).norm(), along * picture.normal.z());
        };
        std::vector<Circle> outline;
        outline.reserve(surface.size());
        for (const Eigen::Vector3d& point : surface) outline.push_back(circle_of(point));
        add_outermost(outline, circles);
        for (int i = 0; i < 3; ++i) {
            const double length = picture.half_axes[i] + axis_overhang + beyond;
            circles.push_back(circle_of(length * Eigen::Vector3d::Unit(i)));
        }
        for (const Eigen::Vector3d& tip : shapes.tips)
            circles.push_back(circle_of(tip + beyond * tip.stableNormalized()));
        // The axis of rotation, outside of the ellipsoid.
        if (shapes.spin_axis) circles.push_back(circle_of(-spin_axis_end(rho)));
        circles.push_back(circle_of(past_contact(rho) + beyond * rho.stableNormalized()));
    }

    // The part of the plane with the shadow and the herpolhode.
    circles.emplace_back(std::max(1.25, 1.2 * picture.herpolhode_radius), picture.foot().z());

    std::vector<Eigen::Vector3d> points{momentum_tip(picture) + beyond * picture.normal};
    constexpr int n_around = 8;
    for (const Circle& circle : circles) {
        for (int k = 0; k < n_around; ++k) {
            const double angle = azimuth_rad + 2.0 * std::numbers::pi * k / n_around;
            points.emplace_back(circle.x() * std::cos(angle), circle.x() * std::sin(angle),
                                circle.y());
        }
    }
    return points;
}

}  // namespace poinsot
