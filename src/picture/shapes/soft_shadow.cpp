#include "shapes/soft_shadow.h"

#include <algorithm>
#include <cmath>

#include "numerics/smooth_step.h"

namespace poinsot {
namespace {

// Subtracted everywhere, so that the shadow's rim is invisible: 0.4 levels of white.
constexpr double unseen = 1.0 / 256.0;

}  // namespace

double smoothstep(double from, double to, double x) {
    return smooth_step((x - from) / (to - from));
}

double opacity_at(const Plane& plane, double distance) {
    return plane.opacity * (1.0 - smoothstep(plane.fade_from, 1.0, distance / plane.radius));
}

SoftShadow::SoftShadow(const Plane& on, const UnitSphere& caster, double presence,
                       const Light& light)
    : plane_(&on),
      presence_(presence),
      to_u_(caster.to_u),
      centre_(caster.centre),
      key_(light.key),
      sky_(light.sky) {
    const double height = plane_->normal.dot(centre_ - plane_->centre);
    const Eigen::Vector3d up = (height < 0.0 ? -1.0 : 1.0) * plane_->normal;
    const Eigen::Vector3d lean = caster.axes.transpose() * up;
    const Eigen::Vector3d lowest = centre_ - caster.axes * lean / std::max(lean.norm(), 1e-12);
    const auto foot = [&](const Eigen::Vector3d& x) {
        return (x - plane_->normal.dot(x - plane_->centre) * plane_->normal).eval();
    };
    hub_ = foot(lowest);
    // The core fades as the ellipsoid leaves the plane.
    constexpr double core_share = 0.12, core_darkness = 0.5, apart_share = 0.05;
    const double largest = caster.axes.colwise().norm().maxCoeff();
    core_radius_ = core_share * largest;
    const double gap = std::abs(std::abs(height) - lean.norm());
    core_ = core_darkness * (1.0 - smoothstep(0.0, apart_share, gap / std::max(largest, 1e-12)));
    // The lamp is higher than the key light: a shadow near the point of contact looks calmer than a
    // long one.
    constexpr double raised = 0.8;
    const Eigen::Vector3d towards_key = light.towards.normalized();
    const Eigen::Vector3d towards =
        (towards_key + (raised + std::max(0.0, -towards_key.dot(up))) * up).normalized();
    const Eigen::Vector3d lee =
        foot(centre_ - towards * (std::abs(height) / std::max(towards.dot(up), 0.3)));
    // Beyond two radii, a sphere on the plane blocks at most two levels.
    middle_ = 0.5 * (foot(centre_) + lee);
    radius_ =
        std::max(2.0 * caster.axes.colwise().norm().maxCoeff(), 1.2 * (middle_ - hub_).norm());
    normal_u_ = lean.normalized();
    lamp_u_ = (to_u_ * towards).normalized();
}

double SoftShadow::darkness(const Eigen::Vector3d& point) const {
    constexpr double lamp = 0.33;  // sine of half the angle of the lamp that represents the key
                                   // light
    constexpr double far_sky = 0.07;
    const Eigen::Vector3d u = to_u_ * (point - centre_);
    const double nearness = std::min(1.0 / u.norm(), 1.0);
    const Eigen::Vector3d towards = -nearness * u;
    // Cosine-weighted share of the sky that a sphere blocks, reduced to zero at a few radii.
    const double hidden = std::max(normal_u_.dot(towards), 0.0) * nearness * nearness;
    const double sky_taken = std::max(hidden - far_sky, 0.0) / (1.0 - far_sky);
    // Overlap of the discs of lamp and sphere, by the sine of the sphere's angular radius minus the
    // angle to the lamp, continued beyond a right angle.
    const double towards_lamp = lamp_u_.dot(towards);
    double beside_lamp = std::sqrt(std::max(1.0 - towards_lamp * towards_lamp, 0.0));
    if (towards_lamp < 0.0) beside_lamp = 2.0 - beside_lamp;
    const double cosine = std::sqrt(1.0 - nearness * nearness);
    const double overlap = nearness * towards_lamp - cosine * beside_lamp;
    const double largest = std::min(nearness / lamp, 1.0);
    const double key_taken = 0.75 * smoothstep(-lamp, lamp, overlap) * largest * largest;
    const double lit = 1.0 - (key_ * key_taken + sky_ * sky_taken) / std::max(key_ + sky_, 1e-6);
    const double core = core_ * (1.0 - smoothstep(0.0, 2.0, (point - hub_).norm() / core_radius_));
    const double taken = 1.0 - lit * (1.0 - core);

    const double distance = (point - plane_->centre).norm();
    return std::max(presence_ * taken * opacity_at(*plane_, distance) - unseen, 0.0);
}

double SoftShadow::limit(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d off = middle_ - hub_;
    const double inward = direction.dot(off);
    const double beside_square = off.squaredNorm() - inward * inward;
    return inward + std::sqrt(std::max(radius_ * radius_ - beside_square, 0.0));
}

}  // namespace poinsot
