#include "render/shadow_web.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/to_glm.h"
#include "shapes/soft_shadow.h"

namespace poinsot {
namespace {

constexpr int n_rings = ShadowWeb::n_rings;
constexpr int n_spokes = ShadowWeb::n_spokes;

// The distance from the hub, along a direction in the plane, up to which the shadow is visible.
double reach_of(const SoftShadow& shadow, const Eigen::Vector3d& direction) {
    double light = shadow.limit(direction);
    if (light <= 0.0) return 0.0;
    // Steps inwards to the first dark point, then bisects the last step.
    constexpr int n_steps = 16, n_halvings = 5;
    const double step = light / n_steps;
    while (light > 0.0 && shadow.darkness(shadow.hub() + (light - step) * direction) <= 0.0)
        light -= step;
    double dark = std::max(light - step, 0.0);
    for (int k = 0; k < n_halvings; ++k) {
        const double between = 0.5 * (dark + light);
        (shadow.darkness(shadow.hub() + between * direction) > 0.0 ? dark : light) = between;
    }
    return std::max(light, 0.0);
}

}  // namespace

ShadowWeb shadow_web(const Plane& plane, const Quadric& caster, const Light& light,
                     const Projection& projection) {
    const SoftShadow shade(plane, caster, caster.presence, light);
    const Eigen::Vector3d across = plane.normal.cross(plane.along);
    std::array<Eigen::Vector3d, n_spokes> spokes;
    bool any = false;
    for (int k = 0; k < n_spokes; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_spokes;
        const Eigen::Vector3d direction = std::cos(angle) * plane.along + std::sin(angle) * across;
        const double reach = reach_of(shade, direction);
        any = any || reach > 0.0;
        spokes[static_cast<std::size_t>(k)] = reach * direction;
    }
    ShadowWeb web;
    if (!any) return web;
    web.corners.reserve(std::size_t{n_rings + 1} * n_spokes);
    for (int ring = 0; ring <= n_rings; ++ring) {
        const double share = static_cast<double>(ring) / n_rings;
        for (const Eigen::Vector3d& spoke : spokes) {
            const Eigen::Vector3d point = shade.hub() + share * share * spoke;
            const Eigen::Vector3d from_eye = point - projection.eye;
            const double depth = projection.perspective ? projection.depth(point) : 1.0;
            const double x =
                projection.centre.x() * depth + projection.focal * projection.right.dot(from_eye);
            const double y =
                projection.centre.y() * depth + projection.focal * projection.down.dot(from_eye);
            // The rim has darkness zero, whatever accuracy the search for it had.
            const double darkness = ring == n_rings ? 0.0 : shade.darkness(point);
            web.corners.emplace_back(x, y, depth, darkness);
        }
    }
    return web;
}

void ShadowWeb::mark(const Projection& projection, TileMask& marks) const {
    if (corners.empty()) return;
    const auto pixel = [](const glm::vec4& corner) {
        return to_eigen(glm::vec2(corner) / corner.z);
    };
    const auto at = [&](int ring, int spoke) -> const glm::vec4& {
        const int corner = ring * n_spokes + spoke % n_spokes;
        return corners[static_cast<std::size_t>(corner)];
    };
    for (int spoke = 0; spoke < n_spokes; ++spoke) {
        if (projection.perspective && std::min(at(0, 0).z, at(n_rings, spoke).z) <=
                                          static_cast<float>(projection.near_depth)) {
            marks.mark(box_of(projection));
            return;
        }
    }
    for (int spoke = 0; spoke < n_spokes; ++spoke) {
        PixelPolygon sector;
        sector.add(pixel(at(0, 0)));
        sector.add(pixel(at(n_rings, spoke)));
        sector.add(pixel(at(n_rings, spoke + 1)));
        marks.mark(sector, box_of(projection));
    }
}

}  // namespace poinsot
