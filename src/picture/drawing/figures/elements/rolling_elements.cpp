// Elements of the rolling: the plane, and the contact point's paths on it and on the ellipsoid.
// Rows of the table in element_rows.h; picture axes, z along L.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "drawing/figures/elements/construction_lines.h"
#include "drawing/figures/elements/direction_marks.h"
#include "drawing/figures/elements/filled_annulus.h"
#include "drawing/figures/elements/trail.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/smooth_paths.h"
#include "numerics/smooth_step.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

// Radius of the plane, which contains the herpolhode.
double plane_radius(const Panel& panel) {
    const double herpolhode = picture_of(panel).herpolhode_radius;
    return radius_in_view(panel, picture_of(panel).foot(), std::max(1.0, 1.3 * herpolhode),
                          std::max(2.4, 2.2 * herpolhode));
}

// A plane with a grid of circles about the foot of L. For a camera that turns about L, circles do
// not move; straight lines would turn, and lines that followed the camera would contradict the
// rolling.
Drawer plane_with_circles(const Panel& panel, Plane plane) {
    plane.grid_px = 0.0;
    std::vector<Curve> circles;
    for (int k = 1; k * plane.grid_spacing < plane.radius; ++k) {
        const double radius = k * plane.grid_spacing;
        const double share = (radius / plane.radius - plane.fade_from) / (1.0 - plane.fade_from);
        Curve circle =
            arc_curve(panel, {.centre = plane.centre, .radius = radius}, plane.grid_colour, 1.1);
        circle.on_plane = the_plane;
        circle.opacity = plane.opacity * (1.0 - smooth_step(share));
        circles.push_back(circle);
    }
    return [plane, circles](const FrameInput&, ViewBuilder& builder) {
        builder.view.planes.push_back(plane);
        builder.view.planes.back().opacity *= plane_presence(plane.centre, builder.view.camera);
        builder.view.curves.insert(builder.view.curves.end(), circles.begin(), circles.end());
    };
}

}  // namespace

// The invariable plane with a square grid, or with circles for a camera that turns about L.
Drawer make_plane(const Panel& panel, StageStore&) {
    Plane plane;
    plane.centre = picture_of(panel).foot();
    plane.radius = plane_radius(panel);
    plane.grid_spacing = 0.2;
    plane.grid_px = 1.1 * panel.px;
    plane.colour = panel.stage->theme.plane;
    plane.grid_colour = panel.stage->theme.grid;
    plane.opacity = panel.stage->theme.plane_opacity;
    if (panel.stage->turns()) return plane_with_circles(panel, plane);
    return [&panel, plane](const FrameInput& instant, ViewBuilder& builder) {
        builder.view.planes.push_back(plane);
        Plane& shown = builder.view.planes.back();
        shown.centre = picture_of(panel).foot(instant);
        shown.opacity *= plane_presence(shown.centre, builder.view.camera);
    };
}

namespace {

// Distance between direction marks, in largest half-axes; the same on both curves, since they roll
// on each other.
constexpr double mark_spacing = 0.45;

// The same of ticks, at most: a whole number of them goes on a closed polhode, so that those of
// each turn come to lie on those of the turn before.
constexpr double tick_spacing = 0.11;

double tick_step(const Panel& panel) {
    const ConstructionPicture& picture = picture_of(panel);
    if (picture.dissipates || !picture.polhode.closed()) return tick_spacing;
    CurveGeometry polhode;
    polhode.closed = true;
    polhode.points = picture.polhode.sampled(panel.curve_units() / picture.picture_per_rho);
    const double length = length_of(polhode) * picture.picture_per_rho;
    return length > 0.0 ? length / std::ceil(length / tick_spacing) : tick_spacing;
}

// The marks that the scene requests on a path of the contact point, which is at `first_index` at
// the stage's first instant.
std::vector<DirectionMarks> marks_on(const Panel& panel, StageStore& store,
                                     const CurveGeometry& geometry, double first_index,
                                     bool backwards) {
    std::vector<DirectionMarks> marks;
    if (wants_marks(panel))
        marks.emplace_back(panel, store, geometry,
                           Marking{.spacing = mark_spacing, .backwards = backwards});
    if (panel.stage->scene.trail.ticks)
        marks.emplace_back(panel, store, geometry,
                           Marking{.spacing = tick_step(panel), .tick_at = first_index});
    return marks;
}

// Opacities of the curves' parts behind the ellipsoid: paler than the parts in front of it, but so
// strong that each curve is read as one closed line. The herpolhode's colour is the brighter.
constexpr double polhode_under_the_body = 0.7;
constexpr double herpolhode_under_the_body = 0.88;

}  // namespace

// The polhode and the part of it that is shown.
Drawer make_polhode(const Panel& panel, StageStore& store) {
    const double per_rho = picture_of(panel).picture_per_rho;
    const double tolerance = panel.curve_units() / per_rho;
    const Polhode& polhode = picture_of(panel).polhode;
    // With dissipation the path never repeats: it is sampled in time.
    const bool whole = panel.stage->scene.trail.polhode == "whole" && !picture_of(panel).dissipates;
    CurveGeometry geometry;
    std::optional<Trail> trail;
    double off = 0.0;
    if (whole) {
        geometry.closed = polhode.closed();
        geometry.points = polhode.sampled(tolerance, &off);
        geometry.smooth = smooth_polhode(polhode, tolerance);
    } else {
        TimedCurve timed = polhode_trail(*panel.stage, tolerance);
        geometry.points = std::move(timed.points);
        geometry.smooth = std::move(timed.smooth);
        trail = std::move(timed.trail);
        off = timed.off;
    }
    for (Eigen::Vector3d& point : geometry.points) point *= per_rho;
    if (geometry.smooth)
        geometry.smooth = placed(geometry.smooth, Eigen::Affine3d(Eigen::Scaling(per_rho)));
    Curve curve =
        curve_of(panel, keep(panel, store, std::move(geometry), off * per_rho, "the polhode"),
                 panel.stage->theme.polhode, 4.0 * panel.stage->theme.polhode_weight);
    curve.on_surface = first_ellipsoid;
    curve.hidden_opacity = polhode_under_the_body;
    const StageContext& stage = *panel.stage;
    const auto first_contact = [&]() -> Eigen::Vector3d {
        const MotionSample sample =
            stage.motion.motion().sample(stage.options.first_time_s, omega_alone);
        return per_rho * picture_of(panel).contact_body(sample.state.omega_body);
    };
    const double first_index = trail ? trail->first_index()
                               : stage.scene.trail.ticks
                                   ? nearest_index(*curve.geometry, first_contact())
                                   : 0.0;
    const std::vector<DirectionMarks> marks =
        marks_on(panel, store, *curve.geometry, first_index,
                 whole && runs_backwards(panel, curve.geometry->points));
    return [&panel, curve, trail, marks](const FrameInput& instant, ViewBuilder& builder) {
        Curve shown = curve;
        shown.placement.linear() = picture_of(panel).picture_from_body(instant).toRotationMatrix();
        ShownStretch stretch{0.0, curve.last, 0.0, false};
        if (trail) stretch = trail->at(instant.time_s);
        stretch.apply_to(shown);
        shown.lasting = false;  // the curve rotates with the body
        builder.view.curves.push_back(shown);
        for (const DirectionMarks& kind : marks) kind.add_to(builder, shown, stretch.grows);
    };
}

// The herpolhode and the part of it that is shown.
Drawer make_herpolhode(const Panel& panel, StageStore& store) {
    const ConstructionPicture& picture = picture_of(panel);
    const double per_rho = picture.picture_per_rho;
    const LineStyle& ink = panel.stage->theme.herpolhode;
    const Polhode::Annulus annulus = picture.polhode.annulus();
    const Eigen::Vector3d towards_eye = (panel.camera.eye - panel.camera.target).normalized();
    const double width_px =
        herpolhode_width_px(panel, (annulus.outer - annulus.inner) * per_rho / panel.units_per_px *
                                       std::abs(towards_eye.z()));
    TimedCurve timed =
        herpolhode_trail(*panel.stage, panel.curve_units() / per_rho,
                         width_px * ink.weight * panel.px * panel.units_per_px / per_rho);

    // If the plane moves, the path traced on it moves with it.
    const Eigen::Vector3d foot = picture.dissipates
                                     ? Eigen::Vector3d::Zero()
                                     : Eigen::Vector3d(picture.construction.plane_distance() *
                                                       picture.construction.normal_space());
    const auto placed_points = [&](const std::vector<Eigen::Vector3d>& points) {
        CurveGeometry geometry;
        geometry.points.reserve(points.size());
        for (const Eigen::Vector3d& point : points)
            geometry.points.emplace_back(picture.picture_from_space * (foot + point) * per_rho);
        return geometry;
    };
    CurveGeometry geometry = placed_points(timed.points);
    if (timed.smooth) {
        const Eigen::Affine3d map =
            Eigen::Scaling(per_rho) * picture.picture_from_space * Eigen::Translation3d(foot);
        geometry.smooth = placed(timed.smooth, map);
    }
    Curve curve = curve_of(
        panel, keep(panel, store, std::move(geometry), timed.off * per_rho, "the herpolhode"), ink,
        width_px);
    curve.on_plane = the_plane;
    curve.hidden_opacity = herpolhode_under_the_body;
    const std::vector<DirectionMarks> marks =
        marks_on(panel, store, *curve.geometry, timed.trail.first_index(), false);
    const std::optional<AnnulusCurve> filled = annulus_of(
        panel, store, timed, curve, [&](const auto& points) { return placed_points(points); });
    return [&panel, &picture, curve, filled, trail = std::move(timed.trail), marks](
               const FrameInput& instant, ViewBuilder& builder) {
        if (filled && instant.time_s >= filled->from_s)
            return builder.view.curves.push_back(filled->curve);
        Curve shown = curve;
        const ShownStretch stretch = trail.at(instant.time_s);
        stretch.apply_to(shown);
        if (picture.dissipates) {
            shown.placement.translation() = picture.foot(instant);
            shown.lasting = false;
        }
        add_on_grid(panel, shown, builder.view);
        for (const DirectionMarks& kind : marks) kind.add_to(builder, shown, stretch.grows);
    };
}

namespace {

CurveGeometry circle_on_plane(const Panel& panel, double radius) {
    CurveGeometry circle;
    circle.closed = true;
    // The sagitta r(1 − cos(π/n)) stays below the tolerance.
    const double tolerance = panel.curve_units();
    const double least =
        std::numbers::pi / std::sqrt(2.0 * tolerance / std::max(radius, tolerance));
    const int n_points = static_cast<int>(std::clamp(std::ceil(least), 256.0, 65536.0));
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        circle.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                   picture_of(panel).foot().z());
    }
    circle.smooth =
        smooth_circle({0.0, 0.0, circle.points.front().z()}, radius, circle.points.size());
    return circle;
}

}  // namespace

// The circles on the plane that bound the herpolhode.
Drawer make_annulus(const Panel& panel, StageStore& store) {
    const Polhode::Annulus annulus = picture_of(panel).polhode.annulus();
    std::vector<Curve> circles;
    for (const double radius : {annulus.inner, annulus.outer}) {
        const LineStyle& ink = panel.stage->theme.annulus;
        Curve curve = curve_of(
            panel,
            keep(panel, store, circle_on_plane(panel, radius * picture_of(panel).picture_per_rho),
                 panel.curve_units(), "a circle of the annulus"),
            ink, 1.5);
        curve.dash_px = dash_of(panel, ink, 7.0);
        curve.on_plane = the_plane;
        circles.push_back(curve);
    }
    return [circles](const FrameInput&, ViewBuilder& builder) {
        builder.view.curves.insert(builder.view.curves.end(), circles.begin(), circles.end());
    };
}

}  // namespace poinsot
