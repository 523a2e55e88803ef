// The camera of a view: where points of its axes land in the picture, and the lines of sight back.
// Drawing places labels by it, both renderers draw by it: in pixels, or in points on paper.
#pragma once

#include <Eigen/Core>

#include "shapes/views.h"

namespace poinsot {

// Right, up and backward of a camera, as columns: orthonormal. A camera that looks along its own
// `up`, or from its own target, still gets axes.
Eigen::Matrix3d camera_axes(const Camera& camera);

// Places are (x right, y down) from the picture's corner, in the picture's unit: pixels by default.
struct Projection {
    Projection() = default;
    // units_per_px: units of the picture for a pixel of the drawing, such as points on paper.
    explicit Projection(const View& view, double units_per_px = 1.0);

    // Distance in front of the eye along the camera's axis, view units.
    double depth(const Eigen::Vector3d& point) const { return forward.dot(point - eye); }
    // Units of the picture to a unit of the view at a depth.
    double scale(double at_depth) const { return perspective ? focal / at_depth : focal; }
    // Where a point is seen. Precondition: it is in front of a perspective camera.
    Eigen::Vector2d place(const Eigen::Vector3d& point) const;
    // The line of sight of a place: a point of it, and its direction away from the eye with unit
    // component along the camera's axis.
    Eigen::Vector3d ray_origin(const Eigen::Vector2d& place) const;
    Eigen::Vector3d ray(const Eigen::Vector2d& place) const;
    // From the point towards the eye; not of unit length.
    Eigen::Vector3d towards_eye(const Eigen::Vector3d& point) const;
    // Where the line of sight of a place meets the plane through `on`. Precondition: it does not
    // run along the plane.
    Eigen::Vector3d on_plane(const Eigen::Vector2d& place, const Eigen::Vector3d& on,
                             const Eigen::Vector3d& normal) const;

    bool perspective = true;
    Eigen::Vector3d eye, right, down, forward;  // the eye, and orthonormal axes of the picture
    Eigen::Vector2d corner, size,
        centre;               // of the view in the picture; the camera's axis meets the centre
    double focal = 1.0;       // focal length; units of the picture to a view unit if orthographic
    double near_depth = 0.0;  // nothing nearer is drawn
    double units_per_px = 1.0;
};

struct Projected {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();  // picture pixels, x right, y down
    double depth = 0.0;                            // along the camera's axis, view units
};

// Precondition: the point is in front of a perspective camera.
Projected project(const View& view, const Eigen::Vector3d& point);

// View units that one pixel covers at a depth along the camera's axis.
double units_per_pixel(const View& view, double depth);

}  // namespace poinsot
