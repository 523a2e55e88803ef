#include "vector/sight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace poinsot::vector {

Sight::Sight(const View& view, double points_per_pixel)
    : perspective(!view.camera.orthographic), eye(view.camera.eye), pt_per_px(points_per_pixel) {
    const Camera& camera = view.camera;
    corner_pt = pt_per_px * Eigen::Vector2d(view.x_px, view.y_px);
    size_pt = pt_per_px * Eigen::Vector2d(view.width_px, view.height_px);
    centre_pt = corner_pt + 0.5 * size_pt;
    const double distance = (camera.target - camera.eye).norm();
    forward = (camera.target - camera.eye) / (distance > 0.0 ? distance : 1.0);
    if (!(distance > 0.0)) forward = -Eigen::Vector3d::UnitZ();
    right = forward.cross(camera.up);
    // A camera that looks along its own "up" still needs a side.
    if (right.norm() < 1e-9 * camera.up.norm() || right.norm() == 0.0)
        right = forward.unitOrthogonal();
    right.normalize();
    down = forward.cross(right);
    focal_pt = perspective ? 0.5 * size_pt.y() / std::tan(0.5 * camera.vertical_field_rad)
                           : size_pt.y() / camera.height_units;
    near_depth = perspective ? 1e-3 * distance : -1e30;
}

Eigen::Vector2d Sight::paper(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_eye = point - eye;
    return centre_pt +
           unit_pt(depth(point)) * Eigen::Vector2d(right.dot(from_eye), down.dot(from_eye));
}

PaperFlow Sight::paper(const CurveFlow& flow) const {
    const double at_depth = depth(flow.position);
    const double scale = unit_pt(at_depth);
    const Eigen::Vector3d from_eye = flow.position - eye;
    const Eigen::Vector2d across(right.dot(from_eye), down.dot(from_eye));
    Eigen::Vector2d change(right.dot(flow.velocity), down.dot(flow.velocity));
    if (perspective) change -= across * (forward.dot(flow.velocity) / at_depth);
    return {centre_pt + scale * across, scale * change};
}

double Sight::spacing_px(const Eigen::Vector3d& at, const Eigen::Vector3d& along,
                         const Eigen::Vector3d& beside) const {
    const Eigen::Vector2d run = paper(CurveFlow{at, along}).velocity;
    const Eigen::Vector2d step = paper(CurveFlow{at, beside}).velocity;
    const double area = run.x() * step.y() - run.y() * step.x();
    return std::abs(area) / std::max(run.norm(), 1e-12) / pt_per_px;
}

Eigen::Vector3d Sight::towards_eye(const Eigen::Vector3d& point) const {
    return perspective ? Eigen::Vector3d(eye - point) : Eigen::Vector3d(-forward);
}

Eigen::Vector3d Sight::ray_origin(const Eigen::Vector2d& at) const {
    if (perspective) return eye;
    const Eigen::Vector2d across = (at - centre_pt) / focal_pt;
    return eye + across.x() * right + across.y() * down;
}

Eigen::Vector3d Sight::ray(const Eigen::Vector2d& at) const {
    if (!perspective) return forward;
    const Eigen::Vector2d slope = (at - centre_pt) / focal_pt;
    return forward + slope.x() * right + slope.y() * down;
}

Eigen::Vector3d Sight::on_plane(const Eigen::Vector2d& at, const Eigen::Vector3d& on,
                                const Eigen::Vector3d& normal) const {
    const Eigen::Vector3d origin = ray_origin(at), direction = ray(at);
    return origin + direction * (normal.dot(on - origin) / normal.dot(direction));
}

}  // namespace poinsot::vector
