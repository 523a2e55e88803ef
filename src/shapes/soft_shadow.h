// The soft shadow of an ellipsoid on a plane. Sky: most where they touch; key light: as from a wide
// lamp. Both are smooth but at the touch.
#pragma once

#include <Eigen/Core>

#include "shapes/camera.h"
#include "shapes/solids.h"
#include "shapes/unit_sphere.h"

namespace poinsot {

// 3t² − 2t³ from 0 at `from` to 1 at `to`.
double smoothstep(double from, double to, double x);

// The opacity of a plane at a distance from its centre, where it fades away.
double opacity_at(const Plane& plane, double distance);

// What an ellipsoid takes from the light of a plane. The plane must outlive it.
class SoftShadow {
 public:
    SoftShadow(const Plane& on, const UnitSphere& caster, double presence, const Light& light);

    // Share of the light that is taken at a point of the plane, times the plane's opacity there,
    // less what cannot be seen (0.4 levels of white): 0 from a limit on.
    double darkness(const Eigen::Vector3d& point) const;
    // Along a direction of the plane (unit) from the hub, how far it may be seen at most; may be
    // negative.
    double limit(const Eigen::Vector3d& direction) const;
    // The point of the plane nearest to the ellipsoid.
    const Eigen::Vector3d& hub() const { return hub_; }

 private:
    const Plane* plane_;
    double presence_;         // of the ellipsoid
    Eigen::Matrix3d to_u_;    // into the axes where it is the unit sphere about the origin
    Eigen::Vector3d centre_;  // of the ellipsoid
    Eigen::Vector3d hub_;
    Eigen::Vector3d middle_;    // of a circle in the plane beyond which nothing is seen
    double radius_ = 0.0;       // of the circle
    Eigen::Vector3d normal_u_;  // of the plane, towards the ellipsoid, in its axes, unit
    Eigen::Vector3d lamp_u_;    // towards the middle of the lamp, likewise
    double key_, sky_;          // strengths
};

}  // namespace poinsot
