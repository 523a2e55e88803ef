#include "drawing/stage/type/name_spots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/smooth_step.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

// The end of the axis of rotation away from the contact, where names crowd.
void keep_free_end(const Curve& axis, Outline& outline) {
    const Eigen::Vector3d end = axis.placement * axis.geometry->points.front();
    const double length = axis.placement.linear().col(0).norm();
    std::erase_if(
        outline, [&](const VisiblePoint& point) { return (point.at - end).norm() > 0.4 * length; });
}

// The rim of a cone, where it is far from the other cones of the view: a name at the generator
// that two cones share would name either.
Outline away_from_others(const View& view, const Cone& cone) {
    const Outline rim = outline_of(view, cone, 96);
    const auto apart_rad = [&](const VisiblePoint& point) {
        double least = std::numbers::pi;
        for (const Cone& other : view.cones) {
            if (&other == &cone) continue;
            const Eigen::Vector3d way = (point.at - other.apex).stableNormalized();
            const double angle = std::acos(std::clamp(way.dot(other.axis), -1.0, 1.0));
            least = std::min(least, std::abs(angle - other.half_angle_rad));
        }
        return least;
    };
    double most = 0.0;
    for (const VisiblePoint& point : rim) most = std::max(most, apart_rad(point));
    Outline kept;
    for (VisiblePoint point : rim) {
        point.weight_px *= smooth_step(4.0 * apart_rad(point) / most - 2.4);
        if (point.weight_px > 0.0) kept.push_back(point);
    }
    return kept;
}

}  // namespace

double leader_share(double away_px, double em_px) {
    return smooth_step((away_px - 0.8 * em_px) / (0.45 * em_px));
}

Spots::Spots(const View& view, const ThingName& name)
    : view_(view),
      half_(0.5 * Eigen::Vector2d(name.type.width_px(), name.type.height_px())),
      em_px_(name.em_px) {
    const NamedThing& thing = *name.thing;
    const auto is_own = [&thing](const auto& shape) {
        return shape.name.element == thing.element && shape.name.part == thing.part;
    };
    const auto add = [this](const Outline& outline, double opacity) {
        outline_.insert(outline_.end(), outline.begin(), outline.end());
        opacity_ = std::max(opacity_, opacity);
    };
    constexpr int n_points = 512;
    for (const Curve& curve : view.curves) {
        if (!is_own(curve)) continue;
        Outline outline = outline_of(view, curve, n_points);
        // A name does not stand where a trail has faded.
        if (curve.fade_points > 0.0)
            for (VisiblePoint& point : outline) {
                const double whole = curve.opacity * (point.px - point.before_px).norm();
                if (whole > 0.0)
                    point.weight_px *= smooth_step(4.0 * point.weight_px / whole - 2.0);
            }
        if (thing.name == "rotation-axis") keep_free_end(curve, outline);
        grows_ = grows_ || thing.name != "rotation-axis";
        add(outline, curve.opacity);
    }
    for (const Ellipsoid& ellipsoid : view.ellipsoids)
        if (is_own(ellipsoid)) add(outline_of(view, ellipsoid, 96), ellipsoid.presence);
    for (const Cone& cone : view.cones)
        if (is_own(cone)) add(away_from_others(view, cone), cone.presence);
    for (const Plane& plane : view.planes)
        if (is_own(plane)) {
            plane_ = &plane;
            opacity_ = std::clamp(2.0 * plane.opacity, 0.0, 1.0);  // as whole as its letters
        }
    double length_px = 0.0;
    for (const VisiblePoint& point : outline_) length_px += point.weight_px;
    is_shown_ = opacity_ > 0.0;
    // The name of a curve that grows appears with it.
    if (grows_) opacity_ *= smooth_step(length_px / (1.2 * em_px_));
}

const VisiblePoint* Spots::nearest(const LabelBox& box) const {
    const auto far = [&box](const VisiblePoint& point) {
        return (box.nearest(point.px) - point.px).squaredNorm();
    };
    const auto found = std::min_element(
        outline_.begin(), outline_.end(),
        [&far](const VisiblePoint& a, const VisiblePoint& b) { return far(a) < far(b); });
    return found == outline_.end() ? nullptr : &*found;
}

std::optional<Spot> Spots::at(double angle_rad, double level) const {
    const Eigen::Vector2d way(std::cos(angle_rad), std::sin(angle_rad));
    if (plane_ != nullptr) return on_plane(way, level);
    const auto point = outermost(outline_, way, 0.06 * em_px_);
    if (!point) return std::nullopt;
    // Beyond the line through the point across the way.
    const double reach = half_.dot(way.cwiseAbs());
    const double gap = (0.35 + 1.3 * level) * em_px_;
    const LabelBox box{point->px + (gap + reach) * way, half_};
    return Spot{point->at, point->px, box, point->spread_px,
                leader_share(box.distance(point->px), em_px_)};
}

// On the plane, around its centre.
std::optional<Spot> Spots::on_plane(const Eigen::Vector2d& way, double level) const {
    const Projection projection(view_);
    Eigen::Vector3d along =
        projection.right - projection.right.dot(plane_->normal) * plane_->normal;
    if (along.norm() < 1e-6) along = plane_->normal.unitOrthogonal();
    along.normalize();
    Eigen::Vector3d down = plane_->normal.cross(along);
    if (down.dot(projection.down) < 0.0) down = -down;
    // The second place is outside of the first, where the plane begins to fade; the last one
    // is under the body.
    const double share = level > 1.0 ? 0.95 - 0.22 * (level - 1.0) : 0.95 + 0.3 * level;
    const double radius = plane_->radius * plane_->fade_from * share;
    const Eigen::Vector3d at = plane_->centre + radius * (way.x() * along + way.y() * down);
    if (projection.depth(at) <= projection.near_depth) return std::nullopt;
    const Eigen::Vector2d px = projection.place(at);
    return Spot{at, px, {px, half_}};
}

}  // namespace poinsot
