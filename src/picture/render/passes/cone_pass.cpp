#include "render/passes/cone_pass.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/passes/colour.h"

namespace poinsot {
namespace {

bool shows(const Cone& cone) {
    return cone.opacity > 0.0 && cone.presence > 0.0 && cone.length > 0.0;
}

// Unit vectors perpendicular to the axis; the first is as near to the reference as possible.
struct ConeAxes {
    Eigen::Vector3d first, second, axis;
    double tangent;

    explicit ConeAxes(const Cone& cone) : axis(cone.axis.normalized()) {
        const Eigen::Vector3d across = cone.reference - cone.reference.dot(axis) * axis;
        first = across.norm() > 1e-9 ? Eigen::Vector3d(across.normalized()) : axis.unitOrthogonal();
        second = axis.cross(first);
        constexpr double least = 1e-3;
        tangent = std::tan(std::clamp(cone.half_angle_rad, least, 0.5 * std::numbers::pi - least));
    }
    Eigen::Vector3d local(const Eigen::Vector3d& v) const {
        return {first.dot(v) / tangent, second.dot(v) / tangent, axis.dot(v)};
    }
};

PixelBox box_of(const Projection& p, const Cone& cone) {
    const ConeAxes axes(cone);
    const Eigen::Vector3d middle = cone.apex + cone.length * axes.axis;
    const double radius = cone.length * axes.tangent;
    PixelBox box;
    const auto add = [&](const Eigen::Vector3d& point) {
        if (p.perspective && p.depth(point) <= p.near_depth) return false;
        box.add(p.place(point), 2.0 + cone.rim_px);
        return true;
    };
    bool before_eye = add(cone.apex);
    constexpr int n = 16;
    const double outside = 1.0 / std::cos(std::numbers::pi / n);
    for (int k = 0; k < n && before_eye; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n;
        before_eye =
            add(middle +
                outside * radius * (std::cos(angle) * axes.first + std::sin(angle) * axes.second));
    }
    return before_eye ? box.within(box_of(p)) : box_of(p);
}

void add_cone(Constants& constants, const Projection& p, const Cone& cone) {
    const ConeAxes axes(cone);
    const double depth = p.depth(cone.apex);
    const bool before_eye = !p.perspective || depth > p.near_depth;
    const Eigen::Vector2d anchor = before_eye ? p.place(cone.apex) : p.centre;
    // Derivatives, with respect to the pixel, of the lines' points at the apex's depth, and of
    // their directions.
    const double unit = 1.0 / p.focal;
    const double spread = p.perspective ? depth * unit : unit;
    const Eigen::Vector3d ray = p.ray(anchor);
    const Eigen::Vector3d at_apex = p.ray_origin(anchor) + depth * ray - cone.apex;
    const Eigen::Vector3d right = axes.local(p.right), down = axes.local(p.down);
    const double turning = p.perspective ? unit : 0.0;
    constants.add(axes.local(at_apex), anchor.x());
    constants.add(spread * right, anchor.y());
    constants.add(spread * down, depth);
    constants.add(axes.local(ray), cone.length);
    constants.add(turning * right, cone.rim_px);
    constants.add(turning * down, cone.n_rulings);
    constants.add(axes.first / axes.tangent, cone.phase_rad);
    constants.add(axes.second / axes.tangent);
    constants.add(axes.axis, cone.presence);
    constants.add(linear_from_srgb(cone.colour, cone.opacity));
}

}  // namespace

const PolygonProgram& ConePass::program_for(int n_members, const Solids& solids) {
    for (const Row& row : programs_)
        if (row.n_members == n_members && row.solids == solids) return *row.program;
    std::vector<std::string> defines = solids.defines();
    defines.push_back("MEMBERS " + std::to_string(n_members));
    programs_.push_back({n_members, solids,
                         std::make_unique<PolygonProgram>(
                             "cone.frag", 7 + 10 * n_members + solids.n_constants(), defines)});
    return *programs_.back().program;
}

void ConePass::draw(const ViewScene& scene) {
    const auto n = scene.view->cones.size();
    for (std::size_t first = 0; first < n; first += most_members)
        draw_group(scene, first, static_cast<int>(std::min<std::size_t>(most_members, n - first)));
}

void ConePass::draw_group(const ViewScene& scene, std::size_t first, int n_members) {
    Constants constants;
    scene.add_view(constants);
    scene.add_light(constants);
    PixelBox box;
    int n_shown = 0;
    for (std::size_t k = first; k < first + static_cast<std::size_t>(n_members); ++k) {
        const Cone& cone = scene.view->cones[k];
        if (!shows(cone)) continue;
        const PixelBox part = box_of(scene.projection, cone);
        if (part.empty()) continue;
        add_cone(constants, scene.projection, cone);
        box.add({part.left, part.top});
        box.add({part.right, part.bottom});
        ++n_shown;
    }
    if (n_shown == 0) return;
    scene.add_solids(constants);
    program_for(n_shown, scene.solids()).draw(polygon_of(box), constants, *scene.drawing);
}

void ConePass::mark(const ViewScene& scene, TileMask& marks) const {
    for (const Cone& cone : scene.view->cones)
        if (shows(cone)) marks.mark(box_of(scene.projection, cone));
}

}  // namespace poinsot
