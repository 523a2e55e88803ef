// The camera as its definition has it, worked out without the renderers: what both of them are held
// against.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "shapes/views.h"

namespace poinsot::testing {

class Pinhole {
 public:
    explicit Pinhole(const View& view)
        : camera_(view.camera),
          middle_px_(0.5 * view.width_px, 0.5 * view.height_px),
          forward_((camera_.target - camera_.eye).normalized()),
          right_(forward_.cross(camera_.up).normalized()),
          down_(forward_.cross(right_)),
          unit_(camera_.orthographic
                    ? camera_.height_units / view.height_px
                    : std::tan(0.5 * camera_.vertical_field_rad) / middle_px_.y()) {}

    // Where a point is seen, px from the upper left corner. Precondition: a perspective camera.
    Eigen::Vector2d place(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d from_eye = point - camera_.eye;
        const double scale = 1.0 / (unit_ * from_eye.dot(forward_));
        return middle_px_ + scale * Eigen::Vector2d(from_eye.dot(right_), from_eye.dot(down_));
    }
    // Whether the line of sight of a place meets the ellipsoid: a quadratic equation.
    bool meets(const Ellipsoid& shape, const Eigen::Vector2d& at_px) const {
        const Eigen::Vector2d off = unit_ * (at_px - middle_px_);
        const Eigen::Vector3d across = off.x() * right_ + off.y() * down_;
        const bool parallel = camera_.orthographic;
        const Eigen::Matrix3d inverse = shape.half_axes.inverse();
        const Eigen::Vector3d from =
            camera_.eye + (parallel ? across : Eigen::Vector3d::Zero()) - shape.centre;
        const Eigen::Vector3d along = forward_ + (parallel ? Eigen::Vector3d::Zero() : across);
        const Eigen::Vector3d o = inverse * from, d = inverse * along;
        return std::pow(o.dot(d), 2) >= d.squaredNorm() * (o.squaredNorm() - 1.0);
    }

 private:
    Camera camera_;
    Eigen::Vector2d middle_px_;
    Eigen::Vector3d forward_, right_, down_;
    double unit_;  // per px: of length, or at unit depth
};

}  // namespace poinsot::testing
