#include "vector/passes/arrow_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace poinsot::vector {

namespace {

using std::numbers::pi;

// A part of an ellipse between two angles as Béziers; angle 0 is ahead.
std::vector<Bezier> arc(const PaperEllipse& ellipse, double from, double to) {
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (0.5 * pi))));
    return arc_of(ellipse, from, to, n);
}

}  // namespace

// A circle about the axis, seen as an ellipse.
PaperEllipse ArrowShape::circle_about(const Eigen::Vector2d& middle, double radius_pt) const {
    return {middle, radius_pt * along * open, radius_pt * across};
}

// The convex hull of two circles about the axis, the second ahead of the first.
Path ArrowShape::hull(const Eigen::Vector2d& a, double radius_a, const Eigen::Vector2d& b,
                      double radius_b) const {
    const PaperEllipse first = circle_about(a, radius_a), second = circle_about(b, radius_b);
    const double run = along.dot(b - a) / open;
    Path path;
    if (std::abs(radius_a - radius_b) >= run) {
        path.add(arc(radius_a > radius_b ? first : second, -pi, pi));
        path.close();
        return path;
    }
    // After stretching along the axis, common tangents touch both circles at the same angle.
    const double touch = std::acos((radius_a - radius_b) / run);
    path.add(arc(first, touch, 2.0 * pi - touch));
    if (radius_b > 1e-9) {
        path.line(second.at(-touch));
        path.add(arc(second, -touch, touch), false);
    } else {
        path.line(b);
    }
    path.close();
    return path;
}

Path ArrowShape::outline_of(ArrowPart part) const {
    if (part == ArrowPart::head) return hull(neck_pt, head_radius * neck_scale, tip_pt, 0.0);
    return hull(tail_pt, shaft_radius * tail_scale, neck_pt, shaft_radius * neck_scale);
}

double ArrowShape::begin_of(ArrowPart part) const {
    return part == ArrowPart::shaft ? 0.0 : neck_at;
}

double ArrowShape::end_of(ArrowPart part) const { return part == ArrowPart::shaft ? neck_at : 1.0; }

double ArrowShape::reach_pt(ArrowPart part) const {
    return part == ArrowPart::shaft ? shaft_radius * std::max(tail_scale, neck_scale) + 1.0
                                    : head_radius * neck_scale + 1.0;
}

Path ArrowShape::strip(const Projection& projection, ArrowPart part, double from, double to) const {
    const double reach = 2.0 * reach_pt(part);
    const auto place = [&](double s) { return projection.place(front(s)); };
    const Eigen::Vector2d begin = place(from) - (from <= begin_of(part) ? reach : 0.0) * along;
    const Eigen::Vector2d end = place(to) + (to >= end_of(part) ? reach : 0.0) * along;
    Path path;
    path.move(begin - reach * across);
    path.line(end - reach * across);
    path.line(end + reach * across);
    path.line(begin + reach * across);
    path.close();
    return path;
}

ArrowShape arrow_shape(const Canvas& canvas, const Arrow& arrow) {
    const Projection& projection = canvas.projection;
    ArrowShape shape;
    const Eigen::Vector3d run = arrow.tip - arrow.tail;
    const double length = run.norm();
    if (!(length > 0.0) || arrow.opacity <= 0.0) return shape;
    shape.axis = run / length;
    // Sizes apply at the depth of the camera's target.
    const double unit_px =
        projection.scale(std::max(projection.depth(canvas.view.camera.target), 1e-9)) /
        projection.units_per_px;
    shape.shaft_radius = 0.5 * arrow.shaft_px / unit_px;
    shape.head_radius = 0.5 * arrow.head_px / unit_px;
    const double head_length = std::min(arrow.head_length_px / unit_px, length);
    shape.tail = arrow.tail;
    shape.tip = arrow.tip;
    shape.neck = arrow.tip - head_length * shape.axis;
    const double reach = std::max(shape.head_radius, shape.shaft_radius);
    if (projection.perspective &&
        std::min(projection.depth(shape.tail), projection.depth(shape.tip)) <=
            projection.near_depth + reach)
        return shape;
    shape.tail_pt = projection.place(shape.tail);
    shape.neck_pt = projection.place(shape.neck);
    shape.tip_pt = projection.place(shape.tip);
    shape.tail_scale = projection.scale(projection.depth(shape.tail));
    shape.neck_scale = projection.scale(projection.depth(shape.neck));
    const Eigen::Vector3d ray =
        projection.perspective ? (shape.neck - projection.eye).normalized() : projection.forward;
    shape.open = std::max(std::abs(ray.dot(shape.axis)), 0.03);
    const Eigen::Vector2d on_paper = shape.tip_pt - shape.tail_pt;
    shape.along = on_paper.norm() > 1e-6 ? on_paper.normalized().eval() : Eigen::Vector2d::UnitX();
    shape.across = {-shape.along.y(), shape.along.x()};
    const Eigen::Vector3d to_eye =
        projection.towards_eye(0.5 * (shape.tail + shape.tip)).normalized();
    const Eigen::Vector3d front = to_eye - to_eye.dot(shape.axis) * shape.axis;
    // Seen along its axis, the arrow has no such line.
    if (front.norm() > 1e-3) shape.to_front = shape.shaft_radius * front.normalized();
    shape.neck_at = 1.0 - head_length / length;
    shape.seen = true;
    return shape;
}

}  // namespace poinsot::vector
