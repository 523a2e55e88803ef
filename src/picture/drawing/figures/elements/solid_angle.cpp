// The solid angle of Montgomery's phase: the part of the sphere |m| = L that L encloses in body
// axes, as a flat area between the encircled axis and the path of L.
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "construction/montgomery_phase.h"
#include "drawing/figures/elements/body_axes.h"
#include "drawing/figures/elements/element_rows.h"
#include "drawing/stage/label_requests.h"
#include "error/error.h"
#include "shapes/projection.h"

namespace poinsot {

// Throws InputError for a motion in which L encloses nothing in the body.
Drawer make_solid_angle(const Panel& panel, StageStore& store) {
    if (!montgomery_phase(panel.stage->motion.motion().problem()))
        throw InputError(
            "show: solid-angle needs a torque-free motion whose polhode has a period; leave it "
            "out");
    const Polhode& polhode = picture_of(panel).polhode;
    const auto direction = [&](double chi) { return momentum_direction(panel, polhode.at(chi)); };
    const int a = polhode.encircled_axis();
    const Eigen::Vector3d axis = std::copysign(1.0, direction(0.0)[a]) * Eigen::Vector3d::Unit(a);
    // Across the axis the path is cos χ·v + sin χ·w, with v and w perpendicular.
    const auto across = [&](double chi) -> Eigen::Vector3d {
        const Eigen::Vector3d n = direction(chi);
        return n - n.dot(axis) * axis;
    };
    const double v = across(0.0).norm(), w = across(0.5 * std::numbers::pi).norm();

    // A mesh of points at equal angles about the axis, just below the surface, so that the lines on
    // the surface lie over it.
    constexpr int n_around = 84, n_out = 8;
    constexpr double below = 0.998;
    std::vector<Eigen::Vector3d> middles;
    const auto at = [&](int k, double share) -> Eigen::Vector3d {
        const double angle = 2.0 * std::numbers::pi * (k % n_around) / n_around;
        // Multiplied by v·w, so that neither is a divisor.
        const Eigen::Vector3d end = direction(std::atan2(std::sin(angle) * v, std::cos(angle) * w));
        const Eigen::Vector3d outward = (end - end.dot(axis) * axis).stableNormalized();
        const double reach_rad = share * std::atan2(end.dot(outward), end.dot(axis));
        return std::cos(reach_rad) * axis + std::sin(reach_rad) * outward;
    };
    MeshGeometry geometry;
    const auto add_triangle = [&](const Eigen::Vector3d& first, Eigen::Vector3d second,
                                  Eigen::Vector3d third) {
        // Seen from outside.
        if ((second - first).cross(third - first).dot(first) < 0.0) std::swap(second, third);
        for (const Eigen::Vector3d& corner : {first, second, third}) {
            geometry.positions.push_back((below * corner).cast<float>());
            geometry.normals.push_back(corner.cast<float>());
        }
    };
    for (int k = 0; k < n_around; ++k) {
        if (k % 8 == 4) middles.push_back(at(k, 0.55));
        for (int j = 0; j < n_out; ++j) {
            const double from = 1.0 * j / n_out, to = 1.0 * (j + 1) / n_out;
            add_triangle(at(k, from), at(k, to), at(k + 1, to));
            if (j > 0) add_triangle(at(k, from), at(k + 1, to), at(k + 1, from));
        }
    }
    const LineStyle& ink = panel.stage->theme.angles[0];
    Mesh area;
    area.geometry = store.keep(std::move(geometry));
    area.colour = ink;
    area.opacity = 0.95;  // the sphere and the ellipsoid in front leave about a quarter
    area.casts_shadow = false;
    const TextBlock type = set_label(panel, store, "S", 0.9);
    return [&panel, area, middles, type, ink](const FrameInput& instant, ViewBuilder& builder) {
        builder.view.meshes.push_back(area);
        // The name is where the area faces the viewer, away from the arrows at the tip of L.
        const Camera& camera = builder.view.camera;
        const Eigen::Vector3d rho =
            picture_of(panel).construction.contact_body(instant.state.omega_body);
        const Eigen::Vector3d clear =
            (camera.eye - camera.target).stableNormalized() - momentum_direction(panel, rho);
        const Eigen::Vector3d* best = &middles.front();
        for (const Eigen::Vector3d& middle : middles)
            if (middle.dot(clear) > best->dot(clear)) best = &middle;
        LabelRequest request;
        request.type = type;
        request.anchor_px = project(builder.view, *best).px;
        request.away = {-0.2, 0.0};  // the name's middle is at the anchor
        request.colour = ink;
        request.at = *best;
        builder.requests.push_back(request);
    };
}

}  // namespace poinsot
