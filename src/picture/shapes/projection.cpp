#include "shapes/projection.h"

#include <Eigen/Geometry>
#include <cmath>

namespace poinsot {

Eigen::Matrix3d camera_axes(const Camera& camera) {
    const Eigen::Vector3d sight = camera.target - camera.eye;
    const double distance = sight.norm();
    const Eigen::Vector3d forward = distance > 0.0 ? Eigen::Vector3d(sight / distance)
                                                   : Eigen::Vector3d(-Eigen::Vector3d::UnitZ());
    Eigen::Vector3d right = forward.cross(camera.up);
    if (right.norm() < 1e-9 * camera.up.norm() || right.norm() == 0.0)
        right = forward.unitOrthogonal();
    right.normalize();
    Eigen::Matrix3d axes;
    axes << right, right.cross(forward), -forward;
    return axes;
}

Projection::Projection(const View& view, double units_per_pixel)
    : perspective(!view.camera.orthographic), eye(view.camera.eye), units_per_px(units_per_pixel) {
    const Camera& camera = view.camera;
    const Eigen::Matrix3d axes = camera_axes(camera);
    right = axes.col(0);
    down = -axes.col(1);
    forward = -axes.col(2);
    corner = units_per_px * Eigen::Vector2d(view.x_px, view.y_px);
    size = units_per_px * Eigen::Vector2d(view.width_px, view.height_px);
    centre = corner + 0.5 * size;
    focal = perspective ? 0.5 * size.y() / std::tan(0.5 * camera.vertical_field_rad)
                        : size.y() / camera.height_units;
    near_depth = perspective ? 1e-3 * (camera.target - camera.eye).norm() : -1e30;
}

Eigen::Vector2d Projection::place(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_eye = point - eye;
    return centre + scale(depth(point)) * Eigen::Vector2d(right.dot(from_eye), down.dot(from_eye));
}

Eigen::Vector3d Projection::ray_origin(const Eigen::Vector2d& place) const {
    if (perspective) return eye;
    const Eigen::Vector2d across = (place - centre) / focal;
    return eye + across.x() * right + across.y() * down;
}

Eigen::Vector3d Projection::ray(const Eigen::Vector2d& place) const {
    if (!perspective) return forward;
    const Eigen::Vector2d slope = (place - centre) / focal;
    return forward + slope.x() * right + slope.y() * down;
}

Eigen::Vector3d Projection::towards_eye(const Eigen::Vector3d& point) const {
    return perspective ? Eigen::Vector3d(eye - point) : Eigen::Vector3d(-forward);
}

Eigen::Vector3d Projection::on_plane(const Eigen::Vector2d& place, const Eigen::Vector3d& on,
                                     const Eigen::Vector3d& normal) const {
    const Eigen::Vector3d origin = ray_origin(place), direction = ray(place);
    return origin + direction * (normal.dot(on - origin) / normal.dot(direction));
}

Projected project(const View& view, const Eigen::Vector3d& point) {
    const Projection projection(view);
    return {projection.place(point), projection.depth(point)};
}

double units_per_pixel(const View& view, double depth) {
    return 1.0 / Projection(view).scale(depth);
}

}  // namespace poinsot
