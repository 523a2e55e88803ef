#include "shapes/projection.h"

#include <Eigen/Geometry>
#include <cmath>

namespace poinsot {

Eigen::Matrix3d camera_axes(const Camera& camera) {
    const Eigen::Vector3d back = (camera.eye - camera.target).normalized();
    const Eigen::Vector3d right = camera.up.cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    return axes;
}

double units_per_pixel(const View& view, double depth) {
    if (view.camera.orthographic) return view.camera.height_units / view.height_px;
    return 2.0 * depth * std::tan(0.5 * view.camera.vertical_field_rad) / view.height_px;
}

Projected project(const View& view, const Eigen::Vector3d& point) {
    const Eigen::Vector3d seen = camera_axes(view.camera).transpose() * (point - view.camera.eye);
    Projected projected;
    projected.depth = -seen.z();
    const double scale = 1.0 / units_per_pixel(view, projected.depth);
    projected.px = {view.x_px + 0.5 * view.width_px + seen.x() * scale,
                    view.y_px + 0.5 * view.height_px - seen.y() * scale};
    return projected;
}

}  // namespace poinsot
