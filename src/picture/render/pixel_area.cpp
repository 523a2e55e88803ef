#include "render/pixel_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/to_glm.h"

namespace poinsot {

void PixelPolygon::add(const Eigen::Vector2d& corner) {
    corners[static_cast<std::size_t>(n_corners++)] = glm::vec2(to_glm(corner));
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

PixelBox ball_box(const Projection& projection, const Eigen::Vector3d& centre, double radius) {
    const double nearest = projection.depth(centre) - radius;
    if (projection.perspective && nearest <= projection.near_depth) return box_of(projection);
    PixelBox ball;
    // A bound of the distance of a sphere's image from the image of its centre: the radius at its
    // nearest depth, and the slant of the line of sight relative to its depth.
    const Eigen::Vector2d middle = projection.place(centre);
    const double slant =
        projection.perspective ? (middle - projection.centre).norm() / projection.focal : 0.0;
    ball.add(middle, radius * projection.scale(nearest) * (1.0 + slant));
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
            return polygon_of(box_of(projection));
        polygon.add(projection.place(corner));
    }
    return polygon;
}

PlaneMap map_of(const Projection& projection, const Eigen::Vector3d& centre,
                const Eigen::Vector3d& along, const Eigen::Vector3d& across) {
    PlaneMap map;
    map.anchor_px = projection.centre;
    const Eigen::Vector3d normal = along.cross(across);
    // Directions of the line of sight as columns: derivatives in x and y, and the direction at the
    // anchor.
    Eigen::Matrix3d rays;
    rays << projection.right / projection.focal, projection.down / projection.focal,
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
        // Origins are affine in the pixel; the direction is constant.
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
