#include "shapes/shape_boxes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot {

void ShapeBoxes::add(const Label& label) {
    if (label.mask == nullptr || label.mask->width == 0) return;
    const double halo = label.halo_px;
    boxes_.push_back({label.top_left_px.x() - halo, label.top_left_px.y() - halo,
                      label.top_left_px.x() + label.mask->width_px() + halo,
                      label.top_left_px.y() + label.mask->height_px() + halo});
}

void ShapeBoxes::add(const Curve& curve) {
    if (curve.geometry == nullptr || curve.geometry->points.size() < 2) return;
    const auto& points = curve.geometry->points;
    const std::size_t n = points.size();
    const auto n_segments = n - (curve.geometry->closed ? 0 : 1);
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(curve.first)));
    const auto last = static_cast<std::size_t>(
        std::clamp(std::ceil(curve.last), 0.0, static_cast<double>(n_segments)));
    for (std::size_t i = first; i < last; ++i)
        add_segment(curve.placement * points[i], curve.placement * points[(i + 1) % n],
                    0.5 * curve.width_px);
}

void ShapeBoxes::add(const Arrow& arrow) {
    add_segment(arrow.tail, arrow.tip, 0.5 * std::max(arrow.head_px, arrow.shaft_px));
}

void ShapeBoxes::add(const Dot& dot) { add_segment(dot.at, dot.at, dot.radius_px + dot.rim_px); }

void ShapeBoxes::add(const Ellipsoid& ellipsoid) {
    PixelBox box;
    constexpr int n_rows = 24, n_columns = 48;
    for (int i = 0; i <= n_rows; ++i) {
        const double polar = std::numbers::pi * i / n_rows;
        for (int k = 0; k < n_columns; ++k) {
            const double azimuth = 2.0 * std::numbers::pi * k / n_columns;
            const Eigen::Vector3d unit(std::sin(polar) * std::cos(azimuth),
                                       std::sin(polar) * std::sin(azimuth), std::cos(polar));
            add_to(box, ellipsoid.centre + ellipsoid.half_axes * unit);
        }
    }
    // Between the points the outline is at most 1 − cos(3.75°) = 0.2 % farther out.
    add_box(box, 0.01);
}

void ShapeBoxes::add(const Plane& plane) {
    add_disc(plane.centre, plane.radius * plane.along,
             plane.radius * plane.normal.cross(plane.along), std::nullopt);
}

void ShapeBoxes::add(const Cone& cone) {
    const Eigen::Vector3d across = cone.axis.unitOrthogonal();
    const double radius = cone.length * std::tan(cone.half_angle_rad);
    add_disc(cone.apex + cone.length * cone.axis, radius * across, radius * cone.axis.cross(across),
             cone.apex);
}

void ShapeBoxes::add(const Mesh& mesh) {
    if (mesh.geometry == nullptr) return;
    PixelBox box;
    for (const Eigen::Vector3f& point : mesh.geometry->positions)
        add_to(box, mesh.placement * point.cast<double>());
    add_box(box, 0.0);
}

// Where a point is behind the eye, the whole view is taken.
void ShapeBoxes::add_to(PixelBox& box, const Eigen::Vector3d& point) const {
    if (projection_.depth(point) > projection_.near_depth) {
        box.add(projection_.place(point));
    } else {
        box.add(projection_.corner);
        box.add(projection_.corner + projection_.size);
    }
}

void ShapeBoxes::add_box(PixelBox box, double margin_share) {
    const double margin = margin_share * std::max(box.right - box.left, box.bottom - box.top);
    box.left -= margin, box.top -= margin, box.right += margin, box.bottom += margin;
    boxes_.push_back(box.within(box_of(projection_)));
}

// Cut into pieces of some pixels, so that a diagonal does not take its whole rectangle.
void ShapeBoxes::add_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                             double half_px) {
    constexpr double piece_px = 16.0;
    PixelBox whole;
    add_to(whole, from);
    add_to(whole, to);
    const double length = std::hypot(whole.right - whole.left, whole.bottom - whole.top);
    const int n_pieces = std::clamp(static_cast<int>(std::ceil(length / piece_px)), 1, 512);
    for (int i = 0; i < n_pieces; ++i) {
        PixelBox box;
        add_to(box, from + (to - from) * (1.0 * i / n_pieces));
        add_to(box, from + (to - from) * (1.0 * (i + 1) / n_pieces));
        box.left -= half_px, box.top -= half_px, box.right += half_px, box.bottom += half_px;
        boxes_.push_back(box.within(box_of(projection_)));
    }
}

void ShapeBoxes::add_disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& along,
                          const Eigen::Vector3d& across,
                          const std::optional<Eigen::Vector3d>& apex) {
    PixelBox box;
    constexpr int n_points = 96;
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        add_to(box, centre + std::cos(angle) * along + std::sin(angle) * across);
    }
    if (apex) add_to(box, *apex);
    add_box(box, 0.01);
}

}  // namespace poinsot
