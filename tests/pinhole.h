// The camera as its definition has it, worked out without the renderers: what both of them are held
// against.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>

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
    // Whether the line of sight to the point passes through the ellipsoid in front of it: the
    // minimum of a quadratic over a segment, independent of poles and outlines.
    bool hides(const Ellipsoid& shape, const Eigen::Vector3d& point) const {
        const Eigen::Matrix3d inverse = shape.half_axes.inverse();
        const Eigen::Vector3d from = start_of_sight(point);
        const Eigen::Vector3d u = inverse * (from - shape.centre), d = inverse * (point - from);
        const double nearest = -u.dot(d) / d.squaredNorm();
        // The square at the nearest point, accurate to rounding: |u × d|²/|d|² for the whole line.
        if (nearest <= 0.0) return u.squaredNorm() < 1.0;
        return nearest < 1.0 ? u.cross(d).squaredNorm() < d.squaredNorm()
                             : (u + d).squaredNorm() < 1.0;
    }
    // Whether the point of the ellipsoid's surface is on the far side: the outer normal points
    // away.
    bool turns_away(const Ellipsoid& shape, const Eigen::Vector3d& point) const {
        const Eigen::Matrix3d inverse = shape.half_axes.inverse();
        const Eigen::Vector3d d = inverse * (point - start_of_sight(point));
        return (inverse * (point - shape.centre)).dot(d) > 0.0;
    }
    bool hides(const Plane& plane, const Eigen::Vector3d& point) const {
        const Eigen::Vector3d back = start_of_sight(point) - point;
        const double here = plane.normal.dot(point - plane.centre);
        return here * plane.normal.dot(camera_.orthographic ? back : camera_.eye - plane.centre) <
               0.0;
    }
    // By Möller and Trumbore (1997), for all triangles.
    bool hides(const Mesh& mesh, const Eigen::Vector3d& point) const {
        const Eigen::Vector3d from = start_of_sight(point), run = point - from;
        const auto& positions = mesh.geometry->positions;
        for (std::size_t k = 0; k + 2 < positions.size(); k += 3) {
            const Eigen::Vector3d a = positions[k].cast<double>();
            const Eigen::Vector3d e = positions[k + 1].cast<double>() - a;
            const Eigen::Vector3d f = positions[k + 2].cast<double>() - a;
            const Eigen::Vector3d p = run.cross(f), s = from - a, q = s.cross(e);
            const double determinant = e.dot(p);
            if (determinant == 0.0) continue;
            const double u = s.dot(p) / determinant, v = run.dot(q) / determinant;
            const double t = f.dot(q) / determinant;
            if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < 1.0 - 1e-6) return true;
        }
        return false;
    }

 private:
    // The eye, or a point of a parallel line of sight far in front.
    Eigen::Vector3d start_of_sight(const Eigen::Vector3d& point) const {
        return camera_.orthographic ? Eigen::Vector3d(point - 50.0 * forward_) : camera_.eye;
    }

    Camera camera_;
    Eigen::Vector2d middle_px_;
    Eigen::Vector3d forward_, right_, down_;
    double unit_;  // per px: of length, or at unit depth
};

}  // namespace poinsot::testing
