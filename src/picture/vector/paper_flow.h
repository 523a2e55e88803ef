// Positions and velocities of curves on paper: points (1/72 inch), x right, y down from the sheet's
// corner.
#pragma once

#include <Eigen/Core>

#include "shapes/projection.h"
#include "shapes/smooth_form.h"

namespace poinsot::vector {

// A point of a curve on paper and its velocity, per unit of the curve's parameter.
struct PaperFlow {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
};

// The third component of a × b.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Precondition: the point is in front of a perspective camera.
PaperFlow on_paper(const Projection& projection, const CurveFlow& flow);

// The distance in pixels of the drawing between neighbouring lines on a surface: a line has the
// direction `along`, and the next line is displaced by `beside`. Precondition: as on_paper().
double spacing_px(const Projection& projection, const Eigen::Vector3d& at,
                  const Eigen::Vector3d& along, const Eigen::Vector3d& beside);

}  // namespace poinsot::vector
