// How a view's axes land on paper: points (1/72 inch), x right, y down from the page's corner.
#pragma once

#include <Eigen/Core>

#include "shapes/smooth_form.h"
#include "shapes/views.h"

namespace poinsot::vector {

// A point of a curve on paper and how fast it runs there, per unit of the curve's parameter.
struct PaperFlow {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
};

// The third component of a × b.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// The camera of a view, as it draws on paper.
struct Sight {
    // pt_per_px: points on paper for a pixel of the drawing.
    Sight(const View& view, double pt_per_px);

    // Along the camera's axis, view units.
    double depth(const Eigen::Vector3d& point) const { return forward.dot(point - eye); }
    // Points on paper to a unit of the view at a depth.
    double unit_pt(double depth) const { return perspective ? focal_pt / depth : focal_pt; }
    // Precondition: the point is in front of a perspective camera.
    Eigen::Vector2d paper(const Eigen::Vector3d& point) const;
    // Precondition: as paper().
    PaperFlow paper(const CurveFlow& flow) const;
    // Pixels from a line to the next on a surface, where it runs `along` and the next lies
    // `beside`. Precondition: as paper().
    double spacing_px(const Eigen::Vector3d& at, const Eigen::Vector3d& along,
                      const Eigen::Vector3d& beside) const;
    // From the point towards the eye; not of unit length.
    Eigen::Vector3d towards_eye(const Eigen::Vector3d& point) const;
    // Where the line of sight of a place on paper meets the plane through `on`; nothing can be said
    // of one that runs along it.
    Eigen::Vector3d on_plane(const Eigen::Vector2d& at, const Eigen::Vector3d& on,
                             const Eigen::Vector3d& normal) const;
    // The line of sight of a place on paper: a point of it, and its direction away from the eye
    // with unit component along the axis.
    Eigen::Vector3d ray_origin(const Eigen::Vector2d& at) const;
    Eigen::Vector3d ray(const Eigen::Vector2d& at) const;

    bool perspective = true;
    Eigen::Vector3d eye, right, down, forward;  // orthonormal axes of the picture
    Eigen::Vector2d centre_pt;                  // where the view's axis meets the paper
    double focal_pt = 1.0;    // focal length in points; points a unit if orthographic
    double near_depth = 0.0;  // nothing nearer is drawn
    double pt_per_px = 1.0;
    Eigen::Vector2d corner_pt, size_pt;  // of the view
};

}  // namespace poinsot::vector
