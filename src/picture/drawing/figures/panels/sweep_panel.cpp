// The sweep panel: the quantity that [construction] sweep varies over the film instead of a motion.
//
// axis: the body is at rest, and an axis n takes all directions in turn; the tip of ρ = n/√I(n)
// traces the inertia ellipsoid until it is complete. energy: at fixed L the plane's distance
// √(2T)/L rises from the least possible value, 1/√I of the largest moment, to the greatest; the
// ellipsoid touches the plane at each distance, and its polhode changes from a point to small
// closed curves, to the separatrix, and on to a point about the other axis.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "drawing/figures/elements/axis_sweep.h"
#include "drawing/figures/elements/construction_lines.h"
#include "drawing/figures/elements/figure_elements.h"
#include "drawing/figures/elements/object_shapes.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/framing.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/overlay.h"
#include "scene/scene_error.h"
#include "shapes/identity.h"
#include "text/printable.h"

namespace poinsot {

namespace {

using std::numbers::pi;

// The elapsed fraction of the film at an instant, 0…1.
double share_at(const StageContext& stage, const FrameInput& instant) {
    const double span_s = stage.film_last_s - stage.film_first_s;
    return std::clamp((instant.time_s - stage.film_first_s) / span_s, 0.0, 1.0);
}

const InertiaTensor& inertia_of(const Panel& panel) {
    return panel.stage->motion.motion().problem().inertia;
}

// Half-axes 1/√I in units of the largest.
Eigen::Vector3d half_axes_of(const Panel& panel) {
    const Eigen::Vector3d& moments = inertia_of(panel).moments_kg_m2();
    return (moments / moments.minCoeff()).cwiseSqrt().cwiseInverse();
}

// Rejects elements: a sweep shows only its own, with the title, the caption and the clock.
void check_show(const StageContext& stage) {
    for (const std::string& name : stage.scene.show) {
        if (is_overlay(name)) continue;
        throw SceneError(stage.scene.location_of("show"),
                         fmt::format("show names \"{}\", but panel \"sweep\" has its own elements; "
                                     "let show name only title, caption and clock, or leave it out",
                                     printable(name)));
    }
}

Margins margins_of(const Panel& panel) {
    const double gap = 18.0 * panel.px;
    return {gap, gap, gap + panel.header_px, gap};
}

// Fraction of the film that the sweep of n takes; after it the ellipsoid is shown alone.
constexpr double swept_share = 0.86;

// The body at rest, so small that it is inside its ellipsoid in every direction.
Drawer resting_body(const Panel& panel, StageStore& store) {
    const BodyShape shape = body_shape(panel, store);
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    placement.linear() =
        0.72 * half_axes_of(panel).minCoeff() * inertia_of(panel).body_from_principal().transpose();
    return [shape, placement](const FrameInput&, ViewBuilder& builder) {
        add_body(shape, placement, false, builder);
    };
}

void make_axis_sweep(Panel& panel, StageStore& store) {
    const Eigen::Vector3d half_axes = half_axes_of(panel);
    std::vector<Eigen::Vector3d> points = points_of_ellipsoid(
        (half_axes.array() + AxisSweep::beyond).matrix().asDiagonal().toDenseMatrix());
    aim_around(panel, std::move(points), margins_of(panel).left_px + 0.4 * label_em_px(panel));

    const AxisSweep axis_sweep(panel, store, half_axes);
    const Drawer body = resting_body(panel, store);
    const std::array<TextBlock, 3> axis_types = set_axis_labels(panel, store);
    const std::array<TextBlock, 3> half_types = set_half_axis_labels(panel, store, 0.8);
    Ellipsoid ellipsoid = ellipsoid_of(panel);
    ellipsoid.half_axes = half_axes.asDiagonal();
    ellipsoid.casts_shadow = false;
    ellipsoid.hides_far_curves = true;  // though it is nearly clear
    panel.draw = [&panel, half_axes, axis_sweep, body, axis_types, half_types, ellipsoid](
                     const FrameInput& instant, ViewBuilder& builder) {
        const StageContext& stage = *panel.stage;
        const double share = share_at(stage, instant);
        const double swept = std::min(share / swept_share, 1.0);
        const double stands =
            std::clamp((share - swept_share) / (0.7 * (1.0 - swept_share)), 0.0, 1.0);

        body(instant, builder);
        name_shapes("body", builder);
        // Nearly transparent until its points have been traced, but hiding objects behind it.
        builder.view.ellipsoids.push_back(ellipsoid);
        Ellipsoid& shown = builder.view.ellipsoids.back();
        // At this opacity a surface begins to hide completely.
        constexpr double faint = 0.25;
        shown.opacity = std::max(stands * ellipsoid.opacity, std::min(faint, ellipsoid.opacity));
        shown.section_px *= stands;
        shown.ruling_px *= stands;
        name_shapes("ellipsoid", builder);

        add_principal_axes(panel, beyond_half_axes(half_axes), 0.75, axis_types, builder);
        name_shapes("axes", builder);
        add_half_axes(panel, Eigen::Matrix3d::Identity(), half_axes, half_types, builder);
        name_shapes("half-axes", builder);
        axis_sweep.add_trace(Eigen::Matrix3d::Identity(), swept, builder);
        axis_sweep.add_direction(Eigen::Matrix3d::Identity(), swept, builder);
    };
}

// The construction at fixed L for a fraction of the sweep: in the body, L moves along the quarter
// circle from the axis of the largest moment to that of the smallest.
struct EnergyState {
    Eigen::Vector3d rho;    // principal axes, in units of the largest half-axis
    double distance = 1.0;  // √(2T)/L in the same units
    Eigen::Matrix3d picture_from_principal;
};

class EnergySweep {
 public:
    EnergySweep(const Panel& panel, const Eigen::Vector3d& normal)
        : half_axes_(half_axes_of(panel)), normal_(normal) {
        half_axes_.minCoeff(&high_);
        half_axes_.maxCoeff(&low_);
        if (high_ == low_) low_ = (high_ + 1) % 3;
        // The middle axis is horizontal, rotated by a quarter turn from the camera.
        const double azimuth = (panel.stage->scene.camera.azimuth_deg + 35.0) * pi / 180.0;
        level_ = {std::cos(azimuth), std::sin(azimuth), 0.0};
    }

    const Eigen::Vector3d& half_axes() const { return half_axes_; }

    EnergyState at(double share) const {
        const double angle = 0.5 * pi * share;
        Eigen::Vector3d n = Eigen::Vector3d::Zero();  // direction of L in the body
        n[high_] = std::cos(angle);
        n[low_] = std::sin(angle);
        EnergyState state;
        const Eigen::Vector3d towards = half_axes_.cwiseProduct(n);
        state.distance = towards.norm();
        state.rho = half_axes_.cwiseProduct(towards) / state.distance;

        // n is along the plane's normal and the middle axis horizontal: two right-handed frames.
        Eigen::Vector3d middle = Eigen::Vector3d::Unit(3 - high_ - low_);
        Eigen::Matrix3d in_body, in_picture;
        in_body << n, middle, n.cross(middle);
        in_picture << normal_, level_, normal_.cross(level_);
        state.picture_from_principal = in_picture * in_body.transpose();
        return state;
    }

 private:
    Eigen::Vector3d half_axes_, normal_, level_;
    int low_ = 0, high_ = 0;
};

// What all instants of the sweep of the energy share, and the drawer of an instant.
struct EnergySweepFigure {
    const Panel* panel = nullptr;
    EnergySweep sweep;
    Eigen::Vector3d normal;  // of the plane, in the direction of L
    Plane plane;
    Ellipsoid ellipsoid;
    TextBlock momentum_type, omega_type;
    std::array<TextBlock, 3> axis_types;
    LevelScale levels;

    void operator()(const FrameInput& instant, ViewBuilder& builder) const {
        const EnergyState state = sweep.at(share_at(*panel->stage, instant));
        const Eigen::Vector3d foot = state.distance * normal;
        builder.view.planes.push_back(plane);
        builder.view.planes.back().centre = foot;
        builder.view.planes.back().opacity *= plane_presence(foot, builder.view.camera);
        name_shapes("plane", builder);
        builder.view.ellipsoids.push_back(ellipsoid);
        builder.view.ellipsoids.back().half_axes =
            state.picture_from_principal * sweep.half_axes().asDiagonal();
        name_shapes("ellipsoid", builder);
        add_polhode(state, builder);
        add_principal_axes(*panel,
                           state.picture_from_principal * beyond_half_axes(sweep.half_axes()), 0.85,
                           axis_types, builder, axis_label_turn_rad);
        name_shapes("axes", builder);
        add_vectors(state, builder);
        levels.add_to(builder, sweep.half_axes(), foot);
        name_shapes("levels", builder);
    }

    // The polhode of this distance, through the contact; it depends only on ω, which is along ρ.
    void add_polhode(const EnergyState& state, ViewBuilder& builder) const {
        const Eigen::Vector3d& moments = inertia_of(*panel).moments_kg_m2();
        const Polhode polhode(InertiaTensor::from_principal_moments(moments), state.rho);
        if (polhode.kind() == Polhode::Kind::point) return;
        const double per_rho = std::sqrt(moments.minCoeff());
        const double tolerance = panel->curve_units() / per_rho;
        CurveGeometry& geometry = builder.view.live_curves.emplace_back();
        geometry.id = next_identity();
        geometry.closed = polhode.closed();
        for (const Eigen::Vector3d& point : polhode.sampled(tolerance))
            geometry.points.push_back(point * per_rho);
        Curve curve = curve_of(*panel, &geometry, panel->stage->theme.polhode, 4.6);
        curve.placement.linear() = state.picture_from_principal;
        curve.on_surface = first_ellipsoid;
        curve.hidden_opacity = 0.72;
        builder.view.curves.push_back(curve);
        name_shapes("polhode", builder);
    }

    // L, ω up to the contact and its axis beyond it, where its label is, and the contact.
    void add_vectors(const EnergyState& state, ViewBuilder& builder) const {
        const Theme& theme = panel->stage->theme;
        const Eigen::Vector3d contact = state.picture_from_principal * state.rho;
        Arrow momentum = arrow_to(*panel, (state.distance + momentum_beyond_plane) * normal,
                                  theme.momentum, 1.15);
        Arrow omega = arrow_to(*panel, contact, theme.omega, 1.15);
        momentum.hidden_opacity = omega.hidden_opacity = 0.9;
        add_named_arrow(*panel, momentum, momentum_type, builder);
        name_shapes("momentum", builder);
        builder.view.arrows.push_back(omega);
        Curve axis = line_between(*panel, contact, past_contact(contact), theme.omega, 2.0);
        axis.hidden_opacity = 0.6;
        builder.view.curves.push_back(axis);
        request_label_beside(*panel, past_contact(contact), Eigen::Vector3d::Zero(), omega_type,
                             theme.omega, builder);
        name_shapes("omega", builder);
        Dot dot = dot_at(*panel, contact, theme.contact);
        dot.occlusion = Occlusion::none;
        builder.view.dots.push_back(dot);
        name_shapes("contact", builder);
    }
};

// Aims the camera at the sweep, with the plane at its farthest.
void aim_at_energy_sweep(Panel& panel, const Eigen::Vector3d& normal, double farthest,
                         double least_radius) {
    std::vector<Eigen::Vector3d> points = points_of_ellipsoid(Eigen::Matrix3d::Identity());
    points.push_back((farthest + momentum_beyond_plane) * normal);
    const double azimuth = timeline_of(panel).camera_at(0.0).azimuth_deg * pi / 180.0;
    const Eigen::Vector3d right(-std::sin(azimuth), std::cos(azimuth), 0.0);
    for (const double side : {1.85, -1.85}) points.emplace_back(side * right);
    for (double turn_deg = 0.0; turn_deg < 360.0; turn_deg += 30.0)
        points.emplace_back(farthest * normal + least_radius * direction_of(turn_deg, 0.0));
    aim_around(panel, std::move(points), margins_of(panel).left_px);
}

void make_energy_sweep(Panel& panel, StageStore& store) {
    const bool above = panel.stage->scene.construction.plane == "above";
    const Eigen::Vector3d normal =
        above ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(-Eigen::Vector3d::UnitZ());
    const EnergySweep sweep(panel, normal);
    const double farthest = sweep.half_axes().maxCoeff();
    // Of the plane, so that nothing cuts it.
    constexpr double least_radius = 0.95;
    aim_at_energy_sweep(panel, normal, farthest, least_radius);

    Plane plane;
    plane.radius = radius_in_view(panel, farthest * normal, least_radius, 2.0);
    plane.grid_spacing = 0.2;
    plane.grid_px = 1.1 * panel.px;
    plane.colour = panel.stage->theme.plane;
    plane.grid_colour = panel.stage->theme.grid;
    plane.opacity = panel.stage->theme.plane_opacity;
    panel.draw = EnergySweepFigure{.panel = &panel,
                                   .sweep = sweep,
                                   .normal = normal,
                                   .plane = plane,
                                   .ellipsoid = ellipsoid_of(panel),
                                   .momentum_type = set_label(panel, store, "\\mathbf{L}"),
                                   .omega_type = set_label(panel, store, "\\boldsymbol{\\omega}"),
                                   .axis_types = set_axis_labels(panel, store),
                                   .levels = LevelScale(panel, store)};
}

}  // namespace

void make_sweep_panel(Panel& panel, StageStore& store) {
    check_show(*panel.stage);
    if (panel.stage->scene.construction.sweep == "axis") {
        make_axis_sweep(panel, store);
    } else {
        make_energy_sweep(panel, store);
    }
}

}  // namespace poinsot
