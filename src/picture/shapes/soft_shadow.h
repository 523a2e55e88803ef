// The soft shadow of an ellipsoid on a plane: the sky light is darkest where they touch, and the
// key light is that of a wide lamp. Both are smooth except at the point of contact, where a small
// dark core shows that they touch.
#pragma once

#include <Eigen/Core>

#include "shapes/camera.h"
#include "shapes/solids.h"
#include "shapes/unit_sphere.h"

namespace poinsot {

// 3t² − 2t³ from 0 at `from` to 1 at `to`.
double smoothstep(double from, double to, double x);

// The opacity of a plane at a distance from its centre; it fades towards the rim.
double opacity_at(const Plane& plane, double distance);

// The light that an ellipsoid blocks from a plane. The plane must outlive this object.
class SoftShadow {
 public:
    SoftShadow(const Plane& on, const UnitSphere& caster, double presence, const Light& light);

    // The share of light blocked at a point of the plane, times the plane's opacity there, minus an
    // invisible amount (0.4 levels of white): it is 0 beyond a limit.
    double darkness(const Eigen::Vector3d& point) const;
    // An upper bound of the distance from the hub, along a unit direction of the plane, up to which
    // the shadow is visible; may be negative.
    double limit(const Eigen::Vector3d& direction) const;
    // The point of the plane nearest to the ellipsoid.
    const Eigen::Vector3d& hub() const { return hub_; }

 private:
    const Plane* plane_;
    double presence_;         // of the ellipsoid
    Eigen::Matrix3d to_u_;    // to the axes in which the ellipsoid is the unit sphere about the
                              // origin
    Eigen::Vector3d centre_;  // of the ellipsoid
    Eigen::Vector3d hub_;
    Eigen::Vector3d middle_;    // of a circle in the plane outside of which the shadow is invisible
    double radius_ = 0.0;       // of the circle
    Eigen::Vector3d normal_u_;  // of the plane, towards the ellipsoid, in the ellipsoid's axes,
                                // unit
    Eigen::Vector3d lamp_u_;    // towards the middle of the lamp, in the ellipsoid's axes, unit
    double key_, sky_;          // strengths
    double core_radius_ = 0.0;  // of the core at half its darkness
    double core_ = 0.0;         // its darkness in the middle; 0 if they do not touch
};

}  // namespace poinsot
