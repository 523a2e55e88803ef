#include "drawing/stage/type/name_surroundings.h"

#include <algorithm>
#include <cmath>

#include "numerics/smooth_step.h"
#include "shapes/outlines.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

// Adds the whole of a curve on a body, of which a part is behind it and pale.
void add_hidden(const Curve& curve, Surroundings& around) {
    constexpr int n_pieces = 96;
    const Projection projection(*around.view);
    const std::vector<Eigen::Vector3d>& points = curve.geometry->points;
    const auto n = static_cast<double>(points.size());
    const double first = std::max(curve.first, 0.0);
    const double last = std::min(curve.last, curve.geometry->closed ? n : n - 1.0);
    Eigen::Vector2d before_px = Eigen::Vector2d::Zero();
    bool is_joined = false;  // to the point before
    for (int k = 0; k <= n_pieces && first < last; ++k) {
        const auto index = static_cast<std::size_t>(first + (last - first) * k / n_pieces);
        const Eigen::Vector3d at = curve.placement * points[index % points.size()];
        if (projection.depth(at) <= projection.near_depth) {
            is_joined = false;
            continue;
        }
        const Eigen::Vector2d px = projection.place(at);
        if (is_joined)
            around.lines.push_back({before_px, px, curve.name.element, curve.name.part, 0.4});
        before_px = px;
        is_joined = true;
    }
}

// The degree to which two boxes read as one phrase: 1 for neighbours on one line.
double phrase_share(const LabelBox& box, const LabelBox& other, double em_px) {
    const Eigen::Vector2d apart =
        (box.centre_px - other.centre_px).cwiseAbs() - box.half_px - other.half_px;
    const double on_one_line =
        std::clamp(-apart.y() / std::min(box.half_px.y(), other.half_px.y()), 0.0, 1.0);
    return smooth_step(2.0 * on_one_line) * smooth_step((1.5 * em_px - apart.x()) / (0.7 * em_px));
}

}  // namespace

Surroundings surroundings_of(const View& view, const std::vector<LabelBox>& overlays,
                             double margin_px) {
    Surroundings around;
    around.view = &view;
    around.margin_px = margin_px;
    around.labels = overlays;
    for (const Label& label : view.labels) around.labels.push_back(label_box(label));
    const Projection projection(view);
    for (const Arrow& arrow : view.arrows) {
        if (projection.depth(arrow.tail) <= projection.near_depth ||
            projection.depth(arrow.tip) <= projection.near_depth)
            continue;
        around.shafts.push_back({projection.place(arrow.tail), projection.place(arrow.tip),
                                 std::max(arrow.head_px, arrow.head_length_px),
                                 std::clamp(arrow.opacity, 0.0, 1.0)});
    }
    for (const Curve& curve : view.curves) {
        // A curve over everything else is no obstacle, except a curve on the plane in a plan.
        const bool is_over = curve.occlusion == Occlusion::none && curve.on_plane < 0;
        if (curve.opacity < 0.3 || is_over) continue;
        for (const VisiblePoint& point : outline_of(view, curve, 192))
            around.lines.push_back(
                {point.before_px, point.px, curve.name.element, curve.name.part});
        if (curve.on_surface >= 0 && curve.hidden_opacity > 0.15) add_hidden(curve, around);
    }
    return around;
}

double cost_of(const LabelBox& box, const Surroundings& around, const NamedThing& thing,
               double em_px) {
    const auto within = [em_px](double distance) {
        return smooth_step((0.6 * em_px - distance) / (0.8 * em_px));
    };
    double cost = 0.0;
    const View& view = *around.view;
    const Eigen::Vector2d low = box.centre_px - box.half_px, high = box.centre_px + box.half_px;
    const double outside = around.margin_px + std::max({view.x_px - low.x(), view.y_px - low.y(),
                                                        high.x() - view.x_px - view.width_px,
                                                        high.y() - view.y_px - view.height_px});
    cost += 8.0 * smooth_step(1.0 + outside / em_px);
    for (const LabelBox& other : around.labels)
        cost += other.opacity *
                (8.0 * within(box.distance(other)) + 2.0 * phrase_share(box, other, em_px));
    for (const Surroundings::Shaft& shaft : around.shafts) {
        cost += 6.0 * shaft.opacity * within(box.distance(shaft.tip) - 0.5 * shaft.head_px);
        cost += 2.0 * shaft.opacity *
                smooth_step(box.length_inside(shaft.tail, shaft.tip) / (1.5 * em_px));
    }
    double length = 0.0, own_length = 0.0;
    for (const Surroundings::Line& line : around.lines) {
        if (std::max(line.a.x(), line.b.x()) < low.x() ||
            std::min(line.a.x(), line.b.x()) > high.x() ||
            std::max(line.a.y(), line.b.y()) < low.y() ||
            std::min(line.a.y(), line.b.y()) > high.y())
            continue;
        const bool is_own = line.element == thing.element && line.part == thing.part;
        (is_own ? own_length : length) += line.weight * box.length_inside(line.a, line.b);
    }
    // The name of a plane has room beside the curves on it.
    cost += (thing.element == "plane" ? 4.0 : 2.0) * smooth_step(length / (2.0 * em_px));
    // A name never lies on its own line.
    cost += 4.0 * smooth_step(own_length / (0.6 * em_px));
    if (thing.keeps_off_bodies)
        for (const Ellipsoid& ellipsoid : view.ellipsoids) {
            if (ellipsoid.opacity < 0.4) continue;
            const double nearness = nearness_to_ellipsoid(view, ellipsoid, box.centre_px);
            double on_body = smooth_step((1.25 - nearness) / 0.3);
            // The end of a long name may lie on the body, too.
            if (ellipsoid.name.element != thing.element)
                for (const double side : {-1.0, 1.0}) {
                    const Eigen::Vector2d end_px =
                        box.centre_px + Eigen::Vector2d(side * box.half_px.x(), 0.0);
                    const double end = nearness_to_ellipsoid(view, ellipsoid, end_px);
                    on_body = std::max(on_body, smooth_step((1.05 - end) / 0.15));
                }
            cost += 1.2 * ellipsoid.presence * on_body;
        }
    // On another thing's cone it would be read as that cone's name.
    for (const Cone& cone : view.cones) {
        if (cone.name.element == thing.element && cone.name.part == thing.part) continue;
        const double nearness = nearness_to_cone(view, cone, box.centre_px);
        cost += 3.0 * cone.presence * smooth_step((1.3 - nearness) / 0.4);
    }
    return cost;
}

double covered_share(const LabelBox& box, const Surroundings& around, double em_px) {
    const auto covered = [em_px](double distance_px) {
        return smooth_step(0.5 - 12.0 * distance_px / em_px);
    };
    const View& view = *around.view;
    const Eigen::Vector2d low = box.centre_px - box.half_px, high = box.centre_px + box.half_px;
    const double inside =
        std::min({low.x() - view.x_px, low.y() - view.y_px, view.x_px + view.width_px - high.x(),
                  view.y_px + view.height_px - high.y()});
    double free = 1.0 - covered(inside - around.margin_px);
    for (const LabelBox& other : around.labels)
        free *= 1.0 - other.opacity * covered(box.distance(other));
    for (const Surroundings::Shaft& shaft : around.shafts) {
        const Eigen::Vector2d way = shaft.tip - shaft.tail;
        const double length = std::max(way.norm(), 1e-9);
        const Eigen::Vector2d middle =
            shaft.tip - std::min(0.5 * length, 0.5 * shaft.head_px) / length * way;
        free *= 1.0 - shaft.opacity * covered(box.distance(middle) - 0.3 * shaft.head_px);
    }
    return 1.0 - free;
}

}  // namespace poinsot
