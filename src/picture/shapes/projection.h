// The projection of a view: positions of points in the picture, and lines of sight. Used for
// placing labels and by both renderers, in pixels or in points on paper.
#pragma once

#include <Eigen/Core>

#include "shapes/views.h"

namespace poinsot {

// Right, up and backward axis of a camera, as orthonormal columns. A camera that looks along its
// own `up`, or whose eye is at its target, still has axes.
Eigen::Matrix3d camera_axes(const Camera& camera);

// Positions are (x right, y down) from the picture's corner, in the picture's unit: pixels by
// default.
struct Projection {
    Projection() = default;
    // units_per_px: units of the picture per pixel of the drawing, such as points on paper.
    explicit Projection(const View& view, double units_per_px = 1.0);

    // Distance in front of the eye along the camera's axis, in view units.
    double depth(const Eigen::Vector3d& point) const { return forward.dot(point - eye); }
    // Units of the picture per view unit at a depth.
    double scale(double at_depth) const { return perspective ? focal / at_depth : focal; }
    // The position of a point in the picture. Precondition: the point is in front of a perspective
    // camera.
    Eigen::Vector2d place(const Eigen::Vector3d& point) const;
    // The line of sight through a position: a point on it, and its direction away from the eye with
    // unit component along the camera's axis.
    Eigen::Vector3d ray_origin(const Eigen::Vector2d& place) const;
    Eigen::Vector3d ray(const Eigen::Vector2d& place) const;
    // The vector from the point towards the eye; not of unit length.
    Eigen::Vector3d towards_eye(const Eigen::Vector3d& point) const;
    // The intersection of the line of sight through a position with the plane through `on`.
    // Precondition: the line is not parallel to the plane.
    Eigen::Vector3d on_plane(const Eigen::Vector2d& place, const Eigen::Vector3d& on,
                             const Eigen::Vector3d& normal) const;

    bool perspective = true;
    Eigen::Vector3d eye, right, down, forward;  // the eye, and orthonormal axes of the picture
    Eigen::Vector2d corner, size,
        centre;               // of the view in the picture, on the camera's axis
    double focal = 1.0;       // focal length; if orthographic, units of the picture per view unit
    double near_depth = 0.0;  // nearer points are not drawn
    double units_per_px = 1.0;
};

struct Projected {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();  // picture pixels, x right, y down
    double depth = 0.0;                            // along the camera's axis, view units
};

// Precondition: the point is in front of a perspective camera.
Projected project(const View& view, const Eigen::Vector3d& point);

// View units per pixel at a depth along the camera's axis.
double units_per_pixel(const View& view, double depth);

}  // namespace poinsot
