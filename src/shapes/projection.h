// Where a point of a view's axes lands in the picture: for placing type beside what it names.
#pragma once

#include <Eigen/Core>

#include "shapes/views.h"

namespace poinsot {

struct Projected {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();  // picture pixels, x right, y down
    double depth = 0.0;                            // along the camera's axis, view units
};

// Right, up and backward of a camera, as columns.
Eigen::Matrix3d camera_axes(const Camera& camera);

// Precondition: the point is in front of a perspective camera.
Projected project(const View& view, const Eigen::Vector3d& point);

// View units that one pixel covers at a depth along the camera's axis.
double units_per_pixel(const View& view, double depth);

}  // namespace poinsot
