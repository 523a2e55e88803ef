#include "shapes/outlines.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes/projection.h"

namespace poinsot {

namespace {

// Ellipsoids paler than this do not hide a curve.
constexpr double least_hiding_opacity = 0.4;

// The ellipsoids of a view that hide what is behind them, as maps to the unit sphere.
class Hiders {
 public:
    Hiders(const View& view, const Projection& projection, int but) : projection_(projection) {
        for (int k = 0; k < static_cast<int>(view.ellipsoids.size()); ++k) {
            const Ellipsoid& ellipsoid = view.ellipsoids[static_cast<std::size_t>(k)];
            if (k == but || ellipsoid.opacity * ellipsoid.presence < least_hiding_opacity) continue;
            const Eigen::Matrix3d to_sphere = ellipsoid.half_axes.inverse();
            if (to_sphere.allFinite()) hiders_.push_back({ellipsoid.centre, to_sphere});
        }
    }

    bool hide(const Eigen::Vector3d& at) const {
        const Eigen::Vector3d way = projection_.towards_eye(at);
        return std::any_of(hiders_.begin(), hiders_.end(), [&](const Hider& hider) {
            // |p + s d|² = 1 for the point p and the way d on the unit sphere's scale.
            const Eigen::Vector3d p = hider.to_sphere * (at - hider.centre);
            const Eigen::Vector3d d = hider.to_sphere * way;
            const double half_b = p.dot(d), a = d.squaredNorm(), c = p.squaredNorm() - 1.0;
            if (c < 0.0) return true;
            return half_b < 0.0 && half_b * half_b > a * c;
        });
    }

 private:
    struct Hider {
        Eigen::Vector3d centre;
        Eigen::Matrix3d to_sphere;
    };
    const Projection& projection_;
    std::vector<Hider> hiders_;
};

// How much of a point on an ellipsoid faces the eye: 0 behind the limb, and 1 a little before it.
double facing(const Ellipsoid& ellipsoid, const Projection& projection, const Eigen::Vector3d& at) {
    const Eigen::Matrix3d to_sphere = ellipsoid.half_axes.inverse();
    const Eigen::Vector3d normal = to_sphere.transpose() * (to_sphere * (at - ellipsoid.centre));
    const double cosine = normal.normalized().dot(projection.towards_eye(at).normalized());
    const double share = std::clamp(cosine / 0.2, 0.0, 1.0);
    return share * share * (3.0 - 2.0 * share);
}

Outline closed_outline(const Projection& projection, const std::vector<Eigen::Vector3d>& points,
                       const Hiders& hiders) {
    Outline outline;
    for (const Eigen::Vector3d& at : points) {
        if (projection.depth(at) <= projection.near_depth || hiders.hide(at)) continue;
        outline.push_back({at, projection.place(at), 0.0});
    }
    for (VisiblePoint& point : outline)
        point.length_px = (outline.front().px - outline[outline.size() / 2].px).norm() *
                          std::numbers::pi / static_cast<double>(outline.size());
    return outline;
}

}  // namespace

Outline outline_of(const View& view, const Curve& curve, int most) {
    const Projection projection(view);
    const std::vector<Eigen::Vector3d>& points = curve.geometry->points;
    const Hiders hiders(view, projection, curve.on_surface);
    const Ellipsoid* const surface =
        curve.on_surface >= 0 && curve.on_surface < static_cast<int>(view.ellipsoids.size())
            ? &view.ellipsoids[static_cast<std::size_t>(curve.on_surface)]
            : nullptr;
    const std::size_t step =
        std::max<std::size_t>(1, points.size() / static_cast<std::size_t>(most));
    const double last = std::min(curve.last, static_cast<double>(points.size()));
    Outline outline;
    Eigen::Vector2d before = Eigen::Vector2d::Zero();
    bool is_joined = false;  // to the point before
    for (std::size_t i = 0; i < points.size(); i += step) {
        const auto index = static_cast<double>(i);
        if (index < curve.first || index > last) {
            is_joined = false;
            continue;
        }
        const Eigen::Vector3d at = curve.placement * points[i];
        if (projection.depth(at) <= projection.near_depth) continue;
        const Eigen::Vector2d px = projection.place(at);
        const double length = is_joined ? (px - before).norm() : 0.0;
        before = px;
        is_joined = true;
        double seen = std::clamp(curve.opacity, 0.0, 1.0);
        if (curve.fade_points > 0.0)
            seen *= std::clamp((last - index) / curve.fade_points, 0.0, 1.0);
        if (surface != nullptr) seen *= facing(*surface, projection, at);
        if (!(seen > 0.0) || hiders.hide(at)) continue;
        outline.push_back({at, px, seen * length});
    }
    return outline;
}

Outline outline_of(const View& view, const Ellipsoid& ellipsoid, int most) {
    const Projection projection(view);
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < most; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / most;
        // The farthest point in the direction d of the picture is A Aᵀd/|Aᵀd| for half-axes A.
        const Eigen::Vector3d d =
            std::cos(angle) * projection.right + std::sin(angle) * projection.down;
        const Eigen::Vector3d turned = ellipsoid.half_axes.transpose() * d;
        points.emplace_back(ellipsoid.centre + ellipsoid.half_axes * turned.stableNormalized());
    }
    const auto own = static_cast<int>(&ellipsoid - view.ellipsoids.data());
    return closed_outline(projection, points, Hiders(view, projection, own));
}

Outline outline_of(const View& view, const Cone& cone, int most) {
    const Projection projection(view);
    const Eigen::Vector3d across = cone.axis.unitOrthogonal();
    const Eigen::Vector3d other = cone.axis.cross(across);
    const double radius = cone.length * std::tan(cone.half_angle_rad);
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < most; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / most;
        points.emplace_back(cone.apex + cone.length * cone.axis +
                            radius * (std::cos(angle) * across + std::sin(angle) * other));
    }
    return closed_outline(projection, points, Hiders(view, projection, -1));
}

std::optional<OutermostPoint> outermost(const Outline& outline, const Eigen::Vector2d& direction,
                                        double blur_px) {
    double farthest = -1e300;
    for (const VisiblePoint& point : outline)
        if (point.length_px > 0.0) farthest = std::max(farthest, direction.dot(point.px));
    OutermostPoint mean{Eigen::Vector3d::Zero(), Eigen::Vector2d::Zero()};
    double sum = 0.0, squares = 0.0;
    for (const VisiblePoint& point : outline) {
        const double behind = (farthest - direction.dot(point.px)) / blur_px;
        if (behind > 12.0 || !(point.length_px > 0.0)) continue;
        const double weight = point.length_px * std::exp(-behind);
        sum += weight;
        mean.at += weight * point.at;
        mean.px += weight * point.px;
        squares += weight * point.px.squaredNorm();
    }
    if (!(sum > 0.0)) return std::nullopt;
    mean.at /= sum;
    mean.px /= sum;
    mean.spread_px = std::sqrt(std::max(0.0, squares / sum - mean.px.squaredNorm()));
    return mean;
}

double nearness_to_ellipsoid(const View& view, const Ellipsoid& ellipsoid,
                             const Eigen::Vector2d& px) {
    const Projection projection(view);
    const double depth = projection.depth(ellipsoid.centre);
    if (depth <= projection.near_depth) return 1e300;
    Eigen::Matrix<double, 2, 3> axes;
    axes << projection.right.transpose() * ellipsoid.half_axes,
        projection.down.transpose() * ellipsoid.half_axes;
    axes *= projection.scale(depth);
    const Eigen::Vector2d from = px - projection.place(ellipsoid.centre);
    const Eigen::Matrix2d form = axes * axes.transpose();
    return std::sqrt(std::max(0.0, from.dot(form.inverse() * from)));
}

}  // namespace poinsot
