#include "shapes/outlines.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "numerics/smooth_step.h"
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

Outline closed_outline(const Projection& projection, const std::vector<Eigen::Vector3d>& points,
                       const Hiders& hiders) {
    Outline outline;
    const auto is_near = [&projection](const Eigen::Vector3d& at) {
        return projection.depth(at) <= projection.near_depth;
    };
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Vector3d& at = points[k];
        const Eigen::Vector3d& before = points[k > 0 ? k - 1 : points.size() - 1];
        if (is_near(at) || is_near(before) || hiders.hide(at)) continue;
        const Eigen::Vector2d px = projection.place(at), before_px = projection.place(before);
        outline.push_back({at, px, before_px, (px - before_px).norm()});
    }
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
    Eigen::Matrix3d to_sphere = Eigen::Matrix3d::Identity();
    if (surface != nullptr) to_sphere = surface->half_axes.inverse();
    // How much of a point on the surface faces the eye: 0 behind the limb, and 1 a little before
    // it.
    const auto facing = [&](const Eigen::Vector3d& at) {
        const Eigen::Vector3d normal = to_sphere.transpose() * (to_sphere * (at - surface->centre));
        const double cosine = normal.normalized().dot(projection.towards_eye(at).normalized());
        return smooth_step(cosine / 0.2);
    };
    const auto n = static_cast<double>(points.size());
    const double first = std::max(curve.first, 0.0);
    const double last = std::min(curve.last, curve.geometry->closed ? n : n - 1.0);
    if (points.empty() || !(first <= last)) return {};
    const auto point_at = [&](double index) -> Eigen::Vector3d {
        const double whole = std::min(std::floor(index), n - 1.0);
        const auto i = static_cast<std::size_t>(whole);
        const Eigen::Vector3d& from = points[i];
        return curve.placement *
               (from + (index - whole) * (points[(i + 1) % points.size()] - from));
    };
    // Whole steps of the geometry, and both ends of the range; a short range has shorter steps, and
    // a straight line inner points.
    const double shortest = n > 2.0 ? 1.0 : (last - first) / 32.0;
    const double step = std::max(shortest, std::min(std::ceil(n / most), (last - first) / 8.0));
    Outline outline;
    Eigen::Vector2d before_px = Eigen::Vector2d::Zero();
    bool is_joined = false;  // to the point before
    const auto add = [&](double index) {
        const Eigen::Vector3d at = point_at(index);
        if (projection.depth(at) <= projection.near_depth) {
            is_joined = false;
            return;
        }
        const Eigen::Vector2d px = projection.place(at);
        const Eigen::Vector2d from_px = is_joined ? before_px : px;
        before_px = px;
        is_joined = true;
        double seen = std::clamp(curve.opacity, 0.0, 1.0);
        if (curve.fade_points > 0.0)
            seen *= std::clamp(1.0 - (last - index) / curve.fade_points, 0.0, 1.0);
        if (surface != nullptr) seen *= facing(at);
        if (!(seen > 0.0) || hiders.hide(at)) return;
        outline.push_back({at, px, from_px, seen * (px - from_px).norm()});
    };
    add(first);
    for (double index = step * (std::floor(first / step) + 1.0); index < last; index += step)
        add(index);
    add(last);
    return outline;
}

Outline outline_of(const View& view, const Ellipsoid& ellipsoid, int most) {
    const Projection projection(view);
    std::vector<Eigen::Vector3d> points;
    points.reserve(static_cast<std::size_t>(most));
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

Outline outline_of(const View& view, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                   double radius, int most) {
    const Projection projection(view);
    const Eigen::Vector3d across = axis.unitOrthogonal();
    const Eigen::Vector3d other = axis.cross(across);
    std::vector<Eigen::Vector3d> points;
    points.reserve(static_cast<std::size_t>(most));
    for (int k = 0; k < most; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / most;
        points.emplace_back(centre + radius * (std::cos(angle) * across + std::sin(angle) * other));
    }
    return closed_outline(projection, points, Hiders(view, projection, -1));
}

Outline outline_of(const View& view, const Cone& cone, int most) {
    return outline_of(view, cone.apex + cone.length * cone.axis, cone.axis,
                      cone.length * std::tan(cone.half_angle_rad), most);
}

std::optional<OutermostPoint> outermost(const Outline& outline, const Eigen::Vector2d& direction,
                                        double blur_px) {
    double farthest = -1e300;
    for (const VisiblePoint& point : outline)
        if (point.weight_px > 0.0) farthest = std::max(farthest, direction.dot(point.px));
    OutermostPoint mean{Eigen::Vector3d::Zero(), Eigen::Vector2d::Zero()};
    double sum = 0.0, squares = 0.0;
    for (const VisiblePoint& point : outline) {
        const double behind = (farthest - direction.dot(point.px)) / blur_px;
        if (behind > 12.0 || !(point.weight_px > 0.0)) continue;
        const double weight = point.weight_px * std::exp(-behind);
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

double nearness_to_cone(const View& view, const Cone& cone, const Eigen::Vector2d& px) {
    constexpr double beyond = std::numeric_limits<double>::infinity();
    const Projection projection(view);
    const Eigen::Vector3d rim = cone.apex + cone.length * cone.axis;
    if (projection.depth(cone.apex) <= projection.near_depth ||
        projection.depth(rim) <= projection.near_depth)
        return beyond;
    const Eigen::Vector2d apex_px = projection.place(cone.apex);
    const Eigen::Vector2d way = projection.place(rim) - apex_px;
    const double length = way.norm();
    if (!(length > 0.0)) return beyond;
    const Eigen::Vector2d along = way / length;
    const double share = along.dot(px - apex_px) / length;
    const double radius_px =
        projection.scale(projection.depth(rim)) * cone.length * std::tan(cone.half_angle_rad);
    // The rim's ellipse reaches beyond the middle of the rim.
    const double most = 1.0 + radius_px / length;
    if (share <= 0.0 || share >= most) return beyond;
    const double aside = std::abs(along.x() * (px - apex_px).y() - along.y() * (px - apex_px).x());
    return aside / (std::min(share, 1.0) * radius_px);
}

}  // namespace poinsot
