// The body panel: the ellipsoid at rest in its principal axes, with its family of polhodes, the
// separatrices between the two kinds, and the polhode of the motion.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "drawing/figures/elements/body_axes.h"
#include "drawing/figures/elements/ghost.h"
#include "drawing/figures/elements/measured_points.h"
#include "drawing/figures/elements/trail.h"
#include "drawing/figures/elements/user_marks.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/framing.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/possible_motions.h"
#include "drawing/stage/smooth_paths.h"

namespace poinsot {

namespace {

// L and ω are shorter than in the space panel, where they must extend beyond a rotating body, so
// that the ellipsoid fills its panel; L still extends beyond ω.
constexpr double body_momentum_length = 1.3;
constexpr double omega_share = 0.88;

// Spacing of neighbouring polhodes on the ellipse through the axes of lowest and highest moment, as
// that ellipse's parameter.
constexpr double family_spacing_rad = 0.13;

// A polhode as geometry in principal axes and picture lengths.
const CurveGeometry* keep_polhode(const Panel& panel, StageStore& store, const Polhode& polhode) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    const double tolerance = panel.curve_units();
    CurveGeometry geometry;
    geometry.closed = polhode.closed();
    double off = 0.0;
    for (const Eigen::Vector3d& point :
         polhode.sampled(tolerance / picture.picture_per_rho, &off)) {
        geometry.points.emplace_back(principal_from_body(panel) * point * picture.picture_per_rho);
    }
    const Eigen::Affine3d map =
        Eigen::Scaling(picture.picture_per_rho) * Eigen::Affine3d(principal_from_body(panel));
    geometry.smooth = placed(smooth_polhode(polhode, tolerance / picture.picture_per_rho), map);
    return keep(panel, store, std::move(geometry), off * picture.picture_per_rho, "a polhode");
}

// A thin line of the family; the mirror image of a polhode is a polhode, since F(ρ) = F(−ρ).
Curve thin(const Panel& panel, const CurveGeometry* geometry, const LineStyle& ink) {
    Curve curve = curve_of(panel, geometry, ink, 1.9);
    curve.opacity = 0.85;
    curve.hidden_opacity = 0.16;
    curve.on_surface = first_ellipsoid;
    return curve;
}
Curve mirror_image(Curve curve) {
    curve.placement.linear() = -Eigen::Matrix3d::Identity();
    return curve;
}

// The principal axes in order of their moments.
struct Ranks {
    int low, middle, high;
};
Ranks ranks_of(const Eigen::Vector3d& moments) {
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&moments](int i, int j) { return moments[i] < moments[j]; });
    return {order[0], order[1], order[2]};
}

// Polhodes in even steps from the axes of the lowest and the highest moment to the separatrices.
// They cross the ellipse ρ = (cos u/√I_low, 0, sin u/√I_high); the separatrices cross it at tan u =
// √((I_mid − I_low)/(I_high − I_mid)). None for a sphere.
std::vector<Curve> family_of(const Panel& panel, StageStore& store) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    const InertiaTensor& inertia = picture.construction.inertia();
    const Eigen::Vector3d I = inertia.moments_kg_m2() / inertia.moments_kg_m2().maxCoeff();
    const auto ranks = ranks_of(I);
    const int low = ranks.low;
    const int middle = ranks.middle;
    const int high = ranks.high;
    std::vector<Curve> curves;
    if (I[low] == I[high]) return curves;

    // Where the curve of the motion crosses that ellipse: no thin line is drawn beside the bold
    // one.
    const Eigen::Vector3d crossing = principal_from_body(panel) * picture.polhode.at(0.0);
    const double u_motion = std::atan2(std::abs(crossing[high]) * std::sqrt(I[high]),
                                       std::abs(crossing[low]) * std::sqrt(I[low]));
    const bool is_curve = picture.polhode.kind() != Polhode::Kind::point;

    const double u_separatrix =
        std::atan2(std::sqrt(I[middle] - I[low]), std::sqrt(I[high] - I[middle]));
    const auto add_side = [&](double from, double extent) {
        const int n_steps =
            panel.spec.curves ? *panel.spec.curves + 1
                              : static_cast<int>(std::round(std::abs(extent) / family_spacing_rad));
        for (int k = 1; k < n_steps; ++k) {
            const double u = from + extent * k / n_steps;
            if (is_curve && std::abs(u - u_motion) < 0.4 * family_spacing_rad) continue;
            // Both curves of the level: one about the axis's end, and its mirror image about the
            // other end.
            Eigen::Vector3d rho = Eigen::Vector3d::Zero();
            rho[low] = std::cos(u) / std::sqrt(I[low]);
            rho[high] = std::sin(u) / std::sqrt(I[high]);
            const Polhode polhode(inertia, inertia.body_from_principal() * rho);
            if (polhode.kind() == Polhode::Kind::point) continue;
            // The two kinds are told apart by the colours of the axes that they encircle.
            const auto axis = static_cast<std::size_t>(polhode.encircled_axis());
            const Curve curve =
                thin(panel, keep_polhode(panel, store, polhode), panel.stage->theme.axes[axis]);
            curves.push_back(curve);
            curves.push_back(mirror_image(curve));
        }
    };
    add_side(0.0, u_separatrix);
    add_side(0.5 * std::numbers::pi, u_separatrix - 0.5 * std::numbers::pi);
    return curves;
}

// The two separatrices, dashed.
std::vector<Curve> separatrices_of(const Panel& panel, StageStore& store) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    const double tolerance = panel.curve_units();
    std::vector<Curve> curves;
    double off = 0.0;  // of both
    for (const auto& points :
         separatrices(picture.construction.inertia(), tolerance / picture.picture_per_rho, &off)) {
        CurveGeometry geometry;
        geometry.closed = true;
        for (const Eigen::Vector3d& point : points) {
            geometry.points.emplace_back(principal_from_body(panel) * point *
                                         picture.picture_per_rho);
        }
        Curve curve = curve_of(
            panel,
            keep(panel, store, std::move(geometry), off * picture.picture_per_rho, "a separatrix"),
            panel.stage->theme.separatrix, 2.6);
        curve.dash_px = dash_of(panel, panel.stage->theme.separatrix, 9.0);
        curve.hidden_opacity = 0.25;
        curve.on_surface = first_ellipsoid;
        curves.push_back(curve);
    }
    return curves;
}

// The polhode of the motion, bold, through the tip of ρ; its mirror image is part of the family.
std::vector<Curve> motion_of(const Panel& panel, StageStore& store) {
    std::vector<Curve> curves;
    const Polhode& polhode = panel.stage->rolling->polhode;
    if (polhode.kind() == Polhode::Kind::point) return curves;
    const CurveGeometry* geometry = keep_polhode(panel, store, polhode);
    curves.push_back(mirror_image(thin(panel, geometry, panel.stage->theme.polhode)));
    Curve curve = curve_of(panel, geometry, panel.stage->theme.polhode, 4.6);
    curve.hidden_opacity = 0.72;
    curve.on_surface = first_ellipsoid;
    curves.push_back(curve);
    return curves;
}

// With dissipation: the path so far, which spirals over the ellipsoid from polhode to polhode.
Drawer make_spiral(const Panel& panel, StageStore& store) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    TimedCurve timed = polhode_trail(*panel.stage, panel.curve_units() / picture.picture_per_rho);
    CurveGeometry geometry;
    geometry.points.reserve(timed.points.size());
    for (const Eigen::Vector3d& point : timed.points)
        geometry.points.emplace_back(principal_from_body(panel) * point * picture.picture_per_rho);
    Curve curve = curve_of(
        panel,
        keep(panel, store, std::move(geometry), timed.off * picture.picture_per_rho, "the polhode"),
        panel.stage->theme.polhode, 4.0);
    curve.hidden_opacity = 0.5;
    curve.on_surface = first_ellipsoid;
    return traversed(std::move(curve), std::move(timed.trail));
}

// ρ = ω/√(2T) of the comparison motion, with the T of the start: a drift moves it off its polhode
// and off the ellipsoid.
Eigen::Vector3d rho_of(const Panel& panel, const RotationState& state) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    return (principal_from_body(panel) * picture.construction.contact_body(state.omega_body)) *
           picture.picture_per_rho;
}

// The drifting polhode of the comparison motion up to the instant, with its ω. Empty without one.
Drawer make_comparison(Panel& panel, StageStore& store) {
    if (!panel.stage->comparison) return [](const FrameInput&, ViewBuilder&) {};
    panel.shows_comparison = true;
    const GhostPath path = ghost_path(
        panel, store, [&panel](const RotationState& state) { return rho_of(panel, state); }, 2.6);
    const TextBlock type = set_ghost_label(panel, store, "\\boldsymbol{\\omega}");
    return [&panel, path, type](const FrameInput& instant, ViewBuilder& builder) {
        add_ghost_path(path, instant, builder);
        add_ghost_arrow(panel, omega_share * omega_tip(rho_of(panel, *instant.comparison)), type,
                        builder);
    };
}

// The measured motion, at rest in the body. Empty without one.
Drawer make_measured_in_body(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    if (!has_measured(stage)) return [](const FrameInput&, ViewBuilder&) {};
    Drawer track = measured_track(
        panel, store,
        [&](const MeasuredRow& row) {
            return Eigen::Vector3d(principal_from_body(panel) * measured_rho(stage, row) *
                                   stage.rolling->picture_per_rho);
        },
        [](const FrameInput&) { return Eigen::Affine3d::Identity(); });
    return fading(stage, store, "measured", std::move(track));
}

// For a body with two equal moments: the circle of ω's tip about the axis of symmetry, its radius
// A, and the rate Ω with its sense. Empty for other bodies.
Drawer make_precession_circle(const Panel& panel, StageStore& store) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    if (!picture.cones || picture.polhode.kind() == Polhode::Kind::point) {
        return [](const FrameInput&, ViewBuilder&) {};
    }
    const RollingCones cones = *picture.cones;
    const TextBlock amplitude = set_label(panel, store, "A", 0.9);
    const TextBlock rate = set_label(panel, store, "\\Omega", 0.9);
    return [&panel, &picture, cones, amplitude, rate](const FrameInput& instant,
                                                      ViewBuilder& builder) {
        const Theme& theme = panel.stage->theme;
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(cones.symmetry_axis);
        const Eigen::Vector3d tip = omega_share * omega_tip(rho_in_principal_axes(panel, instant));
        const Eigen::Vector3d centre = tip.dot(axis) * axis;
        const Eigen::Vector3d radius = tip - centre;
        const Eigen::Vector3d from = radius.stableNormalized();
        Curve circle = arc_curve(
            panel,
            {.centre = centre, .from = from, .towards = axis.cross(from), .radius = radius.norm()},
            theme.omega, 2.2);
        circle.hidden_opacity = 0.5;
        builder.view.curves.push_back(circle);
        // The radius opposite to ω, where neither ω nor L covers it or its name.
        Curve spoke = line_between(panel, centre, centre - radius, theme.omega, 2.6);
        spoke.hidden_opacity = 0.8;
        builder.view.curves.push_back(spoke);
        request_label_beside(panel, centre - 0.6 * radius, 2.0 * centre - 0.6 * radius, amplitude,
                             theme.omega, builder);
        const double side = std::copysign(1.0, centre.dot(axis));
        const double beyond = picture.half_axes[cones.symmetry_axis] + 0.55 * axis_overhang;
        add_turn(panel,
                 {side * beyond * axis, axis, 0.2, std::copysign(5.0, cones.body_precession_rad_s)},
                 theme.body_cone, rate, builder);
    };
}

// Everything that the camera must show over the whole motion.
std::vector<Eigen::Vector3d> points_to_frame(const Panel& panel) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    std::vector<Eigen::Vector3d> points =
        points_of_ellipsoid(picture.half_axes.asDiagonal().toDenseMatrix());
    for (int i = 0; i < 3; ++i) {
        points.emplace_back((picture.half_axes[i] + axis_overhang) * Eigen::Vector3d::Unit(i));
    }
    const Polhode& polhode = picture.polhode;
    const Eigen::Vector3d moments = picture.construction.inertia().moments_kg_m2();
    if (picture.dissipates) {
        // L and ω at equidistant instants of the film: their path is a steady spiral.
        const StageContext& stage = *panel.stage;
        constexpr int n_looks = 512;
        for (int k = 0; k <= n_looks; ++k) {
            FrameInput instant;
            instant.time_s =
                stage.film_first_s + (stage.film_last_s - stage.film_first_s) * k / n_looks;
            instant.state = stage.motion.sample(instant.time_s, omega_alone).state;
            const Eigen::Vector3d rho = rho_in_principal_axes(panel, instant);
            points.emplace_back(omega_share * omega_tip(rho));
            points.emplace_back(moments.cwiseProduct(rho).stableNormalized() *
                                body_momentum_length);
        }
        return points;
    }
    constexpr int n = 48;
    for (int k = 0; k <= n; ++k) {
        const double chi =
            polhode.first_chi_rad() + (polhode.last_chi_rad() - polhode.first_chi_rad()) * k / n;
        const Eigen::Vector3d rho =
            (principal_from_body(panel) * polhode.at(chi)) * picture.picture_per_rho;
        points.emplace_back(omega_share * omega_tip(rho));
        points.emplace_back(moments.cwiseProduct(rho).stableNormalized() * body_momentum_length);
    }
    return points;
}

}  // namespace

void make_body_panel(Panel& panel, StageStore& store) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    const double margin = 0.6 * label_em_px(panel) + 26.0 * panel.px;
    Margins margins = even_margins(panel.box, margin);
    // On a screen the corner of the heading stays free by itself.
    if (is_on_paper(*panel.stage)) margins.top_px += panel.header_px;
    aim_in_principal_axes(panel, points_to_frame(panel), margins);

    Ellipsoid ellipsoid = ellipsoid_of(panel);
    ellipsoid.half_axes = picture.half_axes.asDiagonal();
    ellipsoid.section_px = 0.8 * panel.px;  // the polhodes are more important
    ellipsoid.ruling_px = 0.0;
    std::vector<Curve> curves;
    const auto add = [&curves](std::string_view name, std::vector<Curve> part) {
        for (Curve& curve : part) curve.name.element = name;
        curves.insert(curves.end(), part.begin(), part.end());
    };
    add("polhodes", family_of(panel, store));
    add("separatrix", separatrices_of(panel, store));
    if (!picture.dissipates) add("polhode", motion_of(panel, store));

    const std::array<TextBlock, 3> axis_types = set_axis_labels(panel, store);
    const TextBlock omega_type = set_label(panel, store, "\\boldsymbol{\\omega}");
    const TextBlock momentum_type = set_label(panel, store, "\\mathbf{L}");
    const Drawer comparison = make_comparison(panel, store);
    const Drawer measured = make_measured_in_body(panel, store);
    const Drawer precession = make_precession_circle(panel, store);
    const Drawer marks =
        make_user_marks(panel, store,
                        [&panel, &picture](const MarkSpec& mark,
                                           const RotationState&) -> std::optional<Eigen::Vector3d> {
                            if (mark.on != "ellipsoid") return std::nullopt;
                            return principal_from_body(panel) * on_ellipsoid(picture, mark);
                        });
    const Drawer spiral = picture.dissipates ? make_spiral(panel, store) : Drawer();
    panel.draw = [&panel, &picture, precession, marks, spiral, ellipsoid, curves, axis_types,
                  omega_type, momentum_type, comparison,
                  measured](const FrameInput& instant, ViewBuilder& builder) {
        const Theme& theme = panel.stage->theme;
        builder.view.ellipsoids.push_back(ellipsoid);
        name_shapes("ellipsoid", builder);
        builder.view.curves = curves;
        if (spiral) spiral(instant, builder);
        name_shapes("polhode", builder);
        measured(instant, builder);
        add_principal_axes(panel, beyond_half_axes(picture.half_axes), 0.85, axis_types, builder,
                           axis_label_turn_rad);
        name_shapes("axes", builder);

        // L is the normal of the ellipsoid at the tip of ρ, where ω pierces it.
        const Eigen::Vector3d rho = rho_in_principal_axes(panel, instant);
        const Eigen::Vector3d momentum =
            picture.construction.inertia().moments_kg_m2().cwiseProduct(rho).stableNormalized();
        add_named_arrow(panel,
                        arrow_to(panel, momentum * body_momentum_length, theme.momentum, 1.15),
                        momentum_type, builder);
        name_shapes("momentum", builder);
        add_named_arrow(panel, arrow_to(panel, omega_share * omega_tip(rho), theme.omega, 1.15),
                        omega_type, builder, omega_label_turn_rad);
        name_shapes("omega", builder);
        precession(instant, builder);
        name_shapes("precession", builder);
        marks(instant, builder);
        name_shapes("marks", builder);
        builder.view.dots.push_back(dot_at(panel, rho, theme.contact));
        name_shapes("contact", builder);
        comparison(instant, builder);
        name_shapes("ghost", builder);
    };
}

}  // namespace poinsot
