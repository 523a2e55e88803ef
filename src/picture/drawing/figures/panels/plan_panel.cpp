// The plan panel: the herpolhode on the invariable plane, viewed along its normal, between the
// circles of its annulus. It is also the inset of a space panel.
//
// The plan has its own scale, at which the annulus fills the panel, so that the smallest wobble is
// visible; distances are measured from the foot of L, which avoids cancellation. The view is that
// of the space panel's camera after rising to the zenith or, if it is under the plane, sinking to
// the nadir, so that the herpolhode has the same sense of rotation in both.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "drawing/figures/elements/direction_marks.h"
#include "drawing/figures/elements/filled_annulus.h"
#include "drawing/figures/elements/ghost.h"
#include "drawing/figures/elements/measured_points.h"
#include "drawing/figures/elements/trail.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/framing.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/possible_motions.h"
#include "text/languages.h"

namespace poinsot {

namespace {

// From space axes to the plan: z towards the viewer, y up in the panel, the outer circle's radius
// 1.
struct PlanScale {
    Eigen::Matrix3d plan_from_space;
    double plan_per_rho = 1.0;
    double inner = 0.0;  // radii of the annulus
    double outer = 0.0;
};

// Whether the space panel's camera, as aimed or framed, is above the plane: far away, its elevation
// alone decides.
bool camera_is_above(const Panel& panel) {
    const CameraPose pose = panel.stage->timeline.camera_at(0.0);
    const Eigen::Vector3d towards = direction_of(pose.azimuth_deg, pose.elevation_deg);
    const double height = pose.target.z() + pose.distance * towards.z();
    return height >= panel.stage->rolling->foot().z();
}

PlanScale scale_of(const Panel& panel) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    const Polhode::Annulus annulus = picture.polhode.annulus();
    PlanScale scale;
    // A herpolhode that is a point is drawn at the space panel's scale.
    scale.plan_per_rho = annulus.outer > 0.0 ? 1.0 / annulus.outer : picture.picture_per_rho;
    scale.inner = annulus.outer > 0.0 ? annulus.inner / annulus.outer : 0.0;
    scale.outer = annulus.outer > 0.0 ? 1.0 : 0.0;

    // Columns are the picture's axes: right, up, and towards the viewer.
    const double azimuth = panel.stage->scene.camera.azimuth_deg * std::numbers::pi / 180.0;
    const Eigen::Vector3d outwards(std::cos(azimuth), std::sin(azimuth), 0.0);
    const double side = camera_is_above(panel) ? 1.0 : -1.0;
    Eigen::Matrix3d axes;
    axes.col(1) = -side * outwards;
    axes.col(2) = side * Eigen::Vector3d::UnitZ();
    axes.col(0) = axes.col(1).cross(axes.col(2));
    scale.plan_from_space = axes.transpose() * picture.picture_from_space.toRotationMatrix();
    return scale;
}

// ρ of the comparison motion from the foot of L, in the plan.
Eigen::Vector3d contact_beside(const Panel& panel, const PlanScale& scale,
                               const RotationState& state) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    Eigen::Vector3d at =
        scale.plan_from_space * picture.construction.contact_space(state) * scale.plan_per_rho;
    at.z() = 0.0;
    return at;
}

// The radius of what the plan shows, in radii of the annulus: a comparison motion may leave it.
double reach_of(const Panel& panel, const PlanScale& scale) {
    const StageContext& stage = *panel.stage;
    double reach = 1.0;
    if (!stage.comparison) return reach;
    constexpr double farthest = 2.0;
    constexpr int n_looks = 256;
    for (int k = 0; k <= n_looks; ++k) {
        const double t =
            stage.film_first_s + (stage.film_last_s - stage.film_first_s) * k / n_looks;
        const RotationState state = stage.comparison->sample(t, attitude_too).state;
        const double radius = contact_beside(panel, scale, state).norm();
        if (radius <= farthest) reach = std::max(reach, radius);
    }
    return reach;
}

// Rows at the foot of an inset for the words that say from where it is seen; else none.
double words_px(const Panel& panel) { return panel.host ? 1.2 * label_em_px(panel) : 0.0; }

// The side of the largest square above these rows.
double square_px(const Panel& panel) {
    return std::min(1.0 * panel.box.width_px, panel.box.height_px - words_px(panel));
}

void aim_from_above(Panel& panel, double reach) {
    const double side_px = square_px(panel);
    const double margin_px =
        panel.host ? 12.0 * panel.px : 26.0 * panel.px + 0.5 * label_em_px(panel) + panel.header_px;
    const double room_px = std::max(0.4 * side_px, side_px - 2.0 * margin_px);
    const double units_per_px = 2.0 * reach / room_px;
    const double lower = -0.5 * words_px(panel) * units_per_px;
    Camera camera;
    camera.eye = {0.0, lower, 4.0};
    camera.target = {0.0, lower, 0.0};
    camera.up = Eigen::Vector3d::UnitY();
    camera.orthographic = true;
    camera.height_units = units_per_px * panel.box.height_px;
    aim(panel, camera);
}

// Below an inset: from where it is seen.
Drawer words_below(const Panel& panel, StageStore& store) {
    if (!panel.host) return [](const FrameInput&, ViewBuilder&) {};
    // In the order of language_codes.
    static constexpr Phrase above{"from above",   "von oben",       "vue de dessus",
                                  "desde arriba", "dall\u2019alto", "上から"},
        below{"from below", "von unten", "vue de dessous", "desde abajo", "dal basso", "下から"};
    const StageContext& stage = *panel.stage;
    const double size_px = std::max(0.8 * label_em_px(panel), least_type_px(stage));
    const TextBlock type =
        store.set(phrase_in(stage.scene.language, camera_is_above(panel) ? above : below),
                  {.size_px = size_px, .mode = TypeMode::text});
    return [&panel, &stage, type](const FrameInput&, ViewBuilder& builder) {
        // Words that are wider would reach into the panel beside it.
        if (type.mask->width == 0 || type.width_px() > panel.box.width_px) return;
        Label label;
        label.mask = type.mask;
        const PanelBox& box = panel.box;
        label.top_left_px = {
            stage.at_whole_pixel(box.x_px + 0.5 * (box.width_px - type.width_px())),
            stage.at_whole_pixel(box.y_px + box.height_px - 0.3 * words_px(panel)) -
                type.baseline_px};
        label.colour = stage.theme.text;
        label.halo_colour = stage.theme.halo;
        label.halo_px = 2.0 * panel.px;
        label.held_at = 0.0;
        label.rank = rank_of_charts;
        builder.view.labels.push_back(label);
        name_shapes("view", builder);
    };
}

Plane plane_of(const Panel& panel) {
    Plane plane;
    // It fades out between the herpolhode and the nearest side of the panel.
    plane.radius =
        0.5 * panel.camera.height_units * std::min(1.0, square_px(panel) / panel.box.height_px);
    plane.fade_from = std::clamp(1.05 / plane.radius, 0.6, 0.9);
    plane.grid_spacing = 0.25;
    // Straight lines would turn in rotating axes; the annulus's circles do not.
    plane.grid_px = panel.stage->turns() ? 0.0 : 1.0 * panel.px;
    plane.colour = panel.stage->theme.plane;
    plane.grid_colour = panel.stage->theme.grid;
    plane.opacity = 0.8 * panel.stage->theme.plane_opacity;
    return plane;
}

// The herpolhode, and the part of it that is shown.
struct HerpolhodeCurve {
    Curve curve;
    Trail trail;
    std::optional<DirectionMarks> marks;
    std::optional<AnnulusCurve> annulus;
};

HerpolhodeCurve herpolhode_of(const Panel& panel, StageStore& store, const PlanScale& scale) {
    const LineStyle& ink = panel.stage->theme.herpolhode;
    const double width_px =
        herpolhode_width_px(panel, (scale.outer - scale.inner) / panel.units_per_px);
    TimedCurve timed = herpolhode_trail(
        *panel.stage, panel.curve_units() / scale.plan_per_rho,
        width_px * ink.weight * panel.px * panel.units_per_px / scale.plan_per_rho);
    const auto placed_points = [&](const std::vector<Eigen::Vector3d>& points) {
        CurveGeometry geometry;
        for (const Eigen::Vector3d& point : points) {
            Eigen::Vector3d at = scale.plan_from_space * point * scale.plan_per_rho;
            at.z() = 0.0;
            geometry.points.push_back(at);
        }
        return geometry;
    };
    CurveGeometry geometry = placed_points(timed.points);
    if (timed.smooth) {
        const Eigen::Matrix3d flattened = Eigen::Vector3d(1.0, 1.0, 0.0).asDiagonal();
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        map.linear() = scale.plan_per_rho * flattened * scale.plan_from_space;
        geometry.smooth = placed(timed.smooth, map);
    }
    Curve curve = curve_of(
        panel,
        keep(panel, store, std::move(geometry), timed.off * scale.plan_per_rho, "the herpolhode"),
        ink, width_px);
    curve.on_plane = the_plane;
    curve.occlusion = Occlusion::none;
    // Spacing of direction marks, in radii of the outer circle.
    constexpr double mark_spacing = 1.1;
    std::optional<DirectionMarks> marks;
    if (wants_marks(panel))
        marks.emplace(panel, store, *curve.geometry, Marking{.spacing = mark_spacing});
    std::optional<AnnulusCurve> annulus = annulus_of(
        panel, store, timed, curve, [&](const auto& points) { return placed_points(points); });
    return {curve, std::move(timed.trail), std::move(marks), std::move(annulus)};
}

Curve circle_of(const Panel& panel, double radius) {
    Curve circle = arc_curve(panel, {.radius = radius}, panel.stage->theme.annulus, 2.0);
    circle.dash_px = dash_of(panel, panel.stage->theme.annulus, 8.0);
    circle.occlusion = Occlusion::none;
    return circle;
}

// The path of the comparison motion's contact point. Empty without one.
Drawer beside_on_plane(Panel& panel, StageStore& store, const PlanScale& scale) {
    if (!panel.stage->comparison) return [](const FrameInput&, ViewBuilder&) {};
    panel.shows_comparison = true;
    GhostPath ghost = ghost_path(
        panel, store,
        [&panel, scale](const RotationState& state) { return contact_beside(panel, scale, state); },
        3.0);
    ghost.curve.occlusion = Occlusion::none;
    return [ghost](const FrameInput& instant, ViewBuilder& builder) {
        add_ghost_path(ghost, instant, builder);
    };
}

// The sign of a vector that is seen end on: a circled point if it points at the reader, a circled
// cross if it points away.
constexpr double end_on_radius_px = 7.0;
void add_end_on(const Panel& panel, bool towards, const LineStyle& ink, ViewBuilder& builder) {
    const double radius = end_on_radius_px * panel.px * panel.units_per_px;
    const Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    const auto add = [&](Curve curve) {
        curve.occlusion = Occlusion::none;
        builder.view.curves.push_back(curve);
    };
    add(arc_curve(panel, {.centre = centre, .radius = radius}, ink, 2.4));
    if (towards) {
        Dot point = dot_at(panel, centre, ink, 2.6);
        point.occlusion = Occlusion::none;
        builder.view.dots.push_back(point);
        return;
    }
    for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d end = std::sqrt(0.5) * radius * Eigen::Vector3d(1.0, side, 0.0);
        add(line_between(panel, -end, end, ink, 2.4));
    }
}

// The measured motion on the plane. Empty without one.
Drawer measured_on_plane(const Panel& panel, StageStore& store, const PlanScale& scale) {
    const StageContext& stage = *panel.stage;
    if (!has_measured(stage)) return [](const FrameInput&, ViewBuilder&) {};
    Drawer track = measured_track(
        panel, store,
        [&](const MeasuredRow& row) {
            const Eigen::Quaterniond attitude =
                stage.turned_from_space(row.time_s) * stage.measured_state(row).space_from_body;
            Eigen::Vector3d at =
                scale.plan_from_space * (attitude * measured_rho(stage, row)) * scale.plan_per_rho;
            at.z() = 0.0;
            return at;
        },
        [](const FrameInput&) { return Eigen::Affine3d::Identity(); });
    return fading(stage, store, "measured", std::move(track));
}

}  // namespace

void make_plan_panel(Panel& panel, StageStore& store) {
    panel.needs = {.attitude = false, .herpolhode = true, .euler_angles = false};
    const PlanScale scale = scale_of(panel);
    aim_from_above(panel, reach_of(panel, scale));
    panel.herpolhode_radius = 1.0;

    std::vector<Curve> circles;
    if (scale.outer > 0.0) {
        circles.push_back(circle_of(panel, 1.0));
        // Near the separatrix, or for a circular herpolhode, one circle is enough.
        if (scale.inner > 1e-3 && scale.inner < 0.999)
            circles.push_back(circle_of(panel, scale.inner));
    }
    std::optional<HerpolhodeCurve> timed;
    if (panel.stage->rolling->polhode.kind() != Polhode::Kind::point) {
        timed = herpolhode_of(panel, store, scale);
    }
    const bool towards =
        (scale.plan_from_space * panel.stage->rolling->construction.normal_space()).z() > 0.0;
    const TextBlock momentum_type = set_label(panel, store, "\\mathbf{L}", 0.85);
    const Plane plane = plane_of(panel);
    const Drawer beside = beside_on_plane(panel, store, scale);
    const Drawer measured = measured_on_plane(panel, store, scale);
    const Drawer words = words_below(panel, store);
    panel.draw = [&panel, scale, circles, timed, towards, momentum_type, plane, beside, measured,
                  words](const FrameInput& instant, ViewBuilder& builder) {
        const ConstructionPicture& picture = *panel.stage->rolling;
        builder.view.planes.push_back(plane);
        name_shapes("plane", builder);
        builder.view.curves = circles;
        name_shapes("annulus", builder);
        Eigen::Vector3d contact = scale.plan_from_space *
                                  picture.construction.contact_in_plane(instant.herpolhode_space) *
                                  scale.plan_per_rho;
        contact.z() = 0.0;

        // The radius from the sign of L to the contact point.
        const double sign = end_on_radius_px * panel.px * panel.units_per_px;
        if (contact.norm() > sign) {
            Curve radius = line_between(panel, sign * contact.normalized(), contact,
                                        panel.stage->theme.omega, 1.6);
            radius.occlusion = Occlusion::none;
            builder.view.curves.push_back(radius);
        }
        name_shapes("radius", builder);
        beside(instant, builder);
        name_shapes("drift", builder);
        if (timed && timed->annulus && instant.time_s >= timed->annulus->from_s) {
            builder.view.curves.push_back(timed->annulus->curve);
        } else if (timed) {
            Curve shown = timed->curve;
            const ShownStretch stretch = timed->trail.at(instant.time_s);
            stretch.apply_to(shown);
            add_on_grid(panel, shown, builder.view);
            if (timed->marks) timed->marks->add_to(builder, shown, stretch.grows);
        }

        // The start of the film's curve; a loop has none.
        if (timed && !(panel.stage->options.repeat_s > 0.0)) {
            Dot start = dot_at(panel, timed->curve.geometry->points.front(),
                               panel.stage->theme.herpolhode, 4.5);
            start.occlusion = Occlusion::none;
            builder.view.dots.push_back(start);
        }
        name_shapes("herpolhode", builder);
        measured(instant, builder);
        Dot dot = dot_at(panel, contact, panel.stage->theme.contact);
        dot.occlusion = Occlusion::none;
        builder.view.dots.push_back(dot);
        name_shapes("contact", builder);
        add_end_on(panel, towards, panel.stage->theme.momentum, builder);
        request_label_beside(panel, Eigen::Vector3d::Zero(), contact, momentum_type,
                             panel.stage->theme.momentum, builder);
        name_shapes("momentum", builder);
        words(instant, builder);
    };
}

}  // namespace poinsot
