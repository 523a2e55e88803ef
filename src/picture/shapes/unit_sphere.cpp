#include "shapes/unit_sphere.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace poinsot {
namespace {

// The half-axes with a minimum length, so that a flattened ellipsoid still has an inside.
Eigen::Matrix3d thickened(const Eigen::Matrix3d& half_axes) {
    Eigen::Matrix3d axes = half_axes;
    const double longest = axes.colwise().norm().maxCoeff();
    const double least = longest > 0.0 ? 1e-6 * longest : 1e-12;
    for (int k = 0; k < 3; ++k) {
        if (axes.col(k).norm() >= least) continue;
        // The direction of a zero axis follows from the others.
        Eigen::Vector3d direction = axes.col((k + 1) % 3).cross(axes.col((k + 2) % 3));
        if (direction.norm() <= least * least) direction = axes.col((k + 1) % 3).unitOrthogonal();
        axes.col(k) = least * direction.normalized();
    }
    return axes;
}

}  // namespace

UnitSphere::UnitSphere(const Ellipsoid& ellipsoid)
    : axes(thickened(ellipsoid.half_axes)), to_u(axes.inverse()), centre(ellipsoid.centre) {}

}  // namespace poinsot
