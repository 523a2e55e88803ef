#include "render/projection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot {

void PixelBox::add(const Eigen::Vector2d& point, double margin) {
    left = std::min(left, point.x() - margin);
    top = std::min(top, point.y() - margin);
    right = std::max(right, point.x() + margin);
    bottom = std::max(bottom, point.y() + margin);
}

PixelBox PixelBox::within(const PixelBox& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

PixelBox box_of(const View& view) {
    return {static_cast<double>(view.x_px), static_cast<double>(view.y_px),
            static_cast<double>(view.x_px + view.width_px),
            static_cast<double>(view.y_px + view.height_px)};
}

void PixelPolygon::add(const Eigen::Vector2d& corner) {
    corners[static_cast<std::size_t>(n_corners++)] = corner.cast<float>();
    box.add(corner);
}

PixelPolygon polygon_of(const PixelBox& box) {
    PixelPolygon polygon;
    polygon.add({box.left, box.top});
    polygon.add({box.right, box.top});
    polygon.add({box.right, box.bottom});
    polygon.add({box.left, box.bottom});
    return polygon;
}

Projection::Projection(const View& view)
    : perspective(!view.camera.orthographic),
      eye(view.camera.eye),
      centre_px(view.x_px + 0.5 * view.width_px, view.y_px + 0.5 * view.height_px),
      box(box_of(view)) {
    const Camera& camera = view.camera;
    const double distance = (camera.target - eye).norm();
    forward = distance > 0.0 ? Eigen::Vector3d((camera.target - eye) / distance)
                             : Eigen::Vector3d::UnitY();
    right = forward.cross(camera.up);
    // Looking along `up`: any direction across will do.
    if (right.norm() < 1e-9 * camera.up.norm() || right.norm() == 0.0)
        right = forward.unitOrthogonal();
    right.normalize();
    down = forward.cross(right);
    focal_px = perspective ? 0.5 * view.height_px / std::tan(0.5 * camera.vertical_field_rad)
                           : view.height_px / camera.height_units;
    near_depth = perspective ? 1e-3 * distance : -1e30;
}

Eigen::Vector2d Projection::pixel(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_eye = point - eye;
    return centre_px +
           unit_px(depth(point)) * Eigen::Vector2d(right.dot(from_eye), down.dot(from_eye));
}

Eigen::Vector3d Projection::ray(const Eigen::Vector2d& pixel) const {
    if (!perspective) return forward;
    const Eigen::Vector2d slope = (pixel - centre_px) / focal_px;
    return forward + slope.x() * right + slope.y() * down;
}

Eigen::Vector3d Projection::ray_origin(const Eigen::Vector2d& pixel) const {
    if (perspective) return eye;
    const Eigen::Vector2d across = (pixel - centre_px) / focal_px;
    return eye + across.x() * right + across.y() * down;
}

PixelBox Projection::ball_box(const Eigen::Vector3d& centre, double radius) const {
    const double nearest = depth(centre) - radius;
    if (perspective && nearest <= near_depth) return box;
    PixelBox ball;
    // A ball's picture reaches at most this far from its middle's: its radius at its nearest
    // depth, and the slant of the line of sight over its depth.
    const Eigen::Vector2d middle = pixel(centre);
    const double slant = perspective ? (middle - centre_px).norm() / focal_px : 0.0;
    ball.add(middle, radius * unit_px(nearest) * (1.0 + slant));
    return ball;
}

PixelPolygon disc_polygon(const Projection& projection, const Eigen::Vector3d& centre,
                          const Eigen::Vector3d& along, const Eigen::Vector3d& across,
                          double radius) {
    constexpr int n = PixelPolygon::most_corners;
    const double reach = radius / std::cos(std::numbers::pi / n);
    PixelPolygon polygon;
    for (int k = 0; k < n; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n;
        const Eigen::Vector3d corner =
            centre + reach * (std::cos(angle) * along + std::sin(angle) * across);
        if (projection.perspective && projection.depth(corner) <= projection.near_depth)
            return polygon_of(projection.box);
        polygon.add(projection.pixel(corner));
    }
    return polygon;
}

PlaneMap map_of(const Projection& projection, const Eigen::Vector3d& centre,
                const Eigen::Vector3d& along, const Eigen::Vector3d& across) {
    PlaneMap map;
    map.anchor_px = projection.centre_px;
    const Eigen::Vector3d normal = along.cross(across);
    // Directions of the line of sight as columns: its change with x and y, and at the anchor.
    Eigen::Matrix3d rays;
    rays << projection.right / projection.focal_px, projection.down / projection.focal_px,
        projection.forward;
    const Eigen::Vector3d from_centre = projection.eye - centre;
    const double height = normal.dot(from_centre);
    Eigen::Matrix3d& h = map.plane_from_pixel;
    if (projection.perspective) {
        map.edge_on = std::abs(height) < 1e-9 * from_centre.norm();
        if (map.edge_on) return map;
        // The line eye + z d meets the plane where 1/z = -(n·d)/height.
        h.row(2) = -normal.transpose() * rays / height;
        h.row(0) = along.dot(from_centre) * h.row(2) + along.transpose() * rays;
        h.row(1) = across.dot(from_centre) * h.row(2) + across.transpose() * rays;
    } else {
        const double descent = normal.dot(projection.forward);
        map.edge_on = std::abs(descent) < 1e-6;
        if (map.edge_on) return map;
        // Origins are affine in the pixel, the direction is always the same.
        Eigen::Matrix3d origins = rays;
        origins.col(2) = from_centre;
        const Eigen::RowVector3d reach = -normal.transpose() * origins / descent;
        h.row(0) = along.transpose() * origins + along.dot(projection.forward) * reach;
        h.row(1) = across.transpose() * origins + across.dot(projection.forward) * reach;
        h.row(2) = Eigen::RowVector3d::UnitZ();
    }
    return map;
}

}  // namespace poinsot
