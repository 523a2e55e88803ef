// The solid angle of Montgomery's phase: the part of the sphere |m| = L that L encloses in body
// axes, hatched by arcs of great circles from the encircled axis to the path of L.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "construction/montgomery_phase.h"
#include "drawing/figures/elements/body_axes.h"
#include "drawing/figures/elements/element_rows.h"
#include "drawing/stage/marks.h"
#include "error/error.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

// An arc of the unit sphere between two directions.
Curve arc_between(const Panel& panel, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  const LineStyle& ink, double width_px) {
    const Eigen::Vector3d across = to - from.dot(to) * from;
    return arc_about(panel, Eigen::Vector3d::Zero(), from, across.stableNormalized(), 1.0,
                     std::atan2(across.norm(), from.dot(to)), ink, width_px);
}

}  // namespace

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

    // The arcs end at equal angles about the axis. Most begin at a distance from it, so that the
    // hatching is nowhere dense.
    constexpr int n_arcs = 96;
    constexpr std::array<double, 8> begins{0.08, 0.6, 0.32, 0.6, 0.16, 0.6, 0.32, 0.6};
    const LineStyle& ink = panel.stage->theme.angles[0];
    std::vector<Curve> arcs;
    std::vector<Eigen::Vector3d> middles;
    for (int k = 0; k < n_arcs; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_arcs;
        // Multiplied by v·w, so that neither is a divisor.
        const Eigen::Vector3d end = direction(std::atan2(std::sin(angle) * v, std::cos(angle) * w));
        const Eigen::Vector3d outward = (end - end.dot(axis) * axis).stableNormalized();
        const double reach_rad = std::atan2(end.dot(outward), end.dot(axis));
        const auto at = [&](double share) -> Eigen::Vector3d {
            return std::cos(share * reach_rad) * axis + std::sin(share * reach_rad) * outward;
        };
        Curve arc = arc_between(panel, at(begins[static_cast<std::size_t>(k % 8)]), end, ink, 1.2);
        arc.on_surface = first_ellipsoid;
        arc.opacity = 0.6;
        arc.hidden_opacity = 0.14;
        arcs.push_back(arc);
        if (k % 8 == 4) middles.push_back(at(0.55));
    }
    const TextBlock type = set_label(panel, store, "S", 0.9);
    return [&panel, arcs, middles, type, ink](const FrameInput& instant, ViewBuilder& builder) {
        builder.view.curves.insert(builder.view.curves.end(), arcs.begin(), arcs.end());
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
