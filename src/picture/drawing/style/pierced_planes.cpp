#include "drawing/style/pierced_planes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "shapes/projection.h"
#include "shapes/soft_shadow.h"

namespace poinsot {

namespace {

// Sizes in pixels at 1080 rows.
constexpr double ring_radius_px = 10.0, ring_width_px = 1.6, dash_px = 7.0;

// Where an arrow meets a plane.
struct Piercing {
    double share = 0.0;      // of the arrow
    double presence = 0.0;   // of the plane there, 0…1
    bool is_beyond = false;  // whether the tip is on the side away from the eye
};

std::optional<Piercing> piercing_of(const View& view, const Plane& plane, const Arrow& arrow) {
    const auto height = [&](const Eigen::Vector3d& x) {
        return plane.normal.dot(x - plane.centre);
    };
    // An arrow may begin on the plane, as ω does at the contact.
    constexpr double on_it = 1e-6;
    const double tail = height(arrow.tail), tip = height(arrow.tip);
    if (std::abs(tip) < on_it || (std::abs(tail) > on_it && tail * tip > 0.0)) return {};
    Piercing found;
    found.share = std::abs(tail) > on_it ? tail / (tail - tip) : 0.0;
    const Eigen::Vector3d at = arrow.tail + found.share * (arrow.tip - arrow.tail);
    // A plane of this opacity hides enough to count as one.
    constexpr double seen = 0.25;
    found.presence = std::clamp(opacity_at(plane, (at - plane.centre).norm()) / seen, 0.0, 1.0);
    if (!(found.presence > 0.0)) return {};
    const double eye = view.camera.orthographic ? plane.normal.dot(camera_axes(view.camera).col(2))
                                                : height(view.camera.eye);
    found.is_beyond = eye * tip < 0.0;
    return found;
}

// A circle on the plane around the shaft.
Curve ring_of(const LineStyleRules& rules, const View& view, std::size_t plane, const Arrow& arrow,
              const Piercing& piercing) {
    const Plane& on = view.planes[plane];
    const double radius = ring_radius_px * rules.px / unit_px_of(view);
    Curve ring;
    ring.geometry = rules.unit_circle;
    ring.placement.linear() << radius * on.along, radius * on.normal.cross(on.along),
        radius * on.normal;
    ring.placement.translation() = arrow.tail + piercing.share * (arrow.tip - arrow.tail);
    ring.width_px = ring_width_px * rules.px;
    ring.colour = arrow.colour;
    ring.opacity = arrow.opacity * piercing.presence;
    ring.on_plane = static_cast<int>(plane);
    ring.name = {arrow.name.element, arrow.name.number, "ring"};
    return ring;
}

bool has_dot_near(const View& view, const Eigen::Vector3d& at, double reach) {
    return std::any_of(view.dots.begin(), view.dots.end(), [&](const Dot& dot) {
        return dot.opacity > 0.0 && (dot.at - at).norm() < reach;
    });
}

// Adds the arrow as its part before the plane, if there is one, and its part beyond. Where the
// plane cuts the head, the whole head belongs to the second part. That part is in full strength:
// its dashes say where it is, and the head bears the arrow's name. While the head goes through, it
// becomes so gradually.
void add_parts(const LineStyleRules& rules, const View& view, const Arrow& arrow,
               const Piercing& piercing, std::vector<Arrow>& parts) {
    const double length_px = (arrow.tip - arrow.tail).norm() * unit_px_of(view);
    const double head = std::clamp(arrow.head_length_px / length_px, 1e-9, 1.0);
    const double cut = std::min(piercing.share, 1.0 - head);
    Arrow beyond = arrow;
    beyond.tail = arrow.tail + cut * (arrow.tip - arrow.tail);
    const double passed = std::min((1.0 - piercing.share) / head, 1.0);
    if (beyond.hidden_opacity >= 0.0)
        beyond.hidden_opacity += piercing.presence * passed * (1.0 - beyond.hidden_opacity);
    constexpr double mostly_there = 0.5;
    if (piercing.presence > mostly_there) beyond.dash_px = dash_px * rules.px;
    if (cut > 0.0) {
        // A flat end: a head as wide as the shaft, of negligible length.
        Arrow& before = parts.emplace_back(arrow);
        before.tip = beyond.tail;
        before.head_px = before.shaft_px;
        before.head_length_px = 0.01;
    }
    parts.push_back(beyond);
}

}  // namespace

double unit_px_of(const View& view) {
    return 1.0 / units_per_pixel(view, project(view, view.camera.target).depth);
}

void pierce_planes(const LineStyleRules& rules, View& view) {
    for (std::size_t k = 0; k < view.planes.size(); ++k) {
        std::vector<Arrow> arrows;
        arrows.reserve(view.arrows.size());
        for (const Arrow& arrow : view.arrows) {
            std::optional<Piercing> piercing;
            if (arrow.opacity > 0.0 && arrow.occlusion == Occlusion::by_solids)
                piercing = piercing_of(view, view.planes[k], arrow);
            if (piercing) {
                Curve ring = ring_of(rules, view, k, arrow, *piercing);
                if (!has_dot_near(view, ring.placement.translation(),
                                  ring.placement.linear().col(0).norm()))
                    view.curves.push_back(ring);
            }
            if (piercing && piercing->is_beyond)
                add_parts(rules, view, arrow, *piercing, arrows);
            else
                arrows.push_back(arrow);
        }
        view.arrows = std::move(arrows);
    }
}

}  // namespace poinsot
