#include "drawing/figures/elements/ghost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/label_requests.h"
#include "error/error.h"

namespace poinsot {

namespace {

// A point at this distance from the centre, in largest half-axes, is outside of every picture.
constexpr double out_of_picture = 4.0;

// Ends the path before the first point outside of the picture.
void cut(TimedPath& path) {
    const auto far = std::find_if(
        path.points.begin(), path.points.end(),
        [](const Eigen::Vector3d& point) { return !(point.norm() <= out_of_picture); });
    const auto n_points = static_cast<std::size_t>(far - path.points.begin());
    path.points.resize(n_points);
    path.times_s.resize(n_points);
    path.offs.resize(n_points);
    // The distance is unknown for a path that was not sampled (infinite).
    if (std::isfinite(path.off))
        path.off = n_points > 0 ? *std::max_element(path.offs.begin(), path.offs.end()) : 0.0;
}

void require_beside(const Panel& panel, std::string_view element) {
    if (panel.stage->comparison) return;
    throw InputError(fmt::format(
        "show: \"{}\" needs a comparison method; name one under [beside], or leave the element out",
        element));
}

// ρ of a state in the space panel's axes, computed with the T of the start: a drift of T moves it
// off the plane.
Eigen::Vector3d contact_of(const ConstructionPicture& picture, const RotationState& state) {
    return picture.picture_from_space * picture.construction.contact_space(state) *
           picture.picture_per_rho;
}

}  // namespace

GhostPath ghost_path(const Panel& panel, StageStore& store,
                     const std::function<Eigen::Vector3d(const RotationState&)>& point,
                     double width_px) {
    const StageContext& stage = *panel.stage;
    const double half_turn_s = std::numbers::pi / stage.quickest_rate_rad_s();
    GhostPath ghost;
    ghost.path = sample_path(
        [&](double time_s) { return point(stage.comparison->sample(time_s, attitude_too).state); },
        stage.options.first_time_s, stage.options.last_time_s, half_turn_s, panel.curve_units());
    cut(ghost.path);
    CurveGeometry geometry;
    geometry.points = std::move(ghost.path.points);
    ghost.curve = curve_of(panel,
                           keep(panel, store, std::move(geometry), ghost.path.off,
                                "the path of the comparison motion"),
                           panel.stage->theme.ghost, width_px);
    ghost.curve.hidden_opacity = 0.45;
    ghost.curve.lasting = true;
    ghost.path.points.clear();
    return ghost;
}

void add_ghost_path(const GhostPath& ghost, const FrameInput& instant, ViewBuilder& builder) {
    builder.view.curves.push_back(ghost.curve);
    builder.view.curves.back().last = ghost.path.index_at(instant.time_s);
}

std::string comparison_name(const StageContext& stage) {
    std::string name = stage.comparison->motion().problem().method.name;
    // Euler's name, and abbreviations.
    if (name == "euler") name.front() = 'E';
    for (const std::string_view letters : {"rk4", "dmv", "rkmk4"})
        if (name == letters)
            for (char& letter : name)
                if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    return name;
}

TextBlock set_ghost_label(const Panel& panel, StageStore& store, std::string_view symbol,
                          double scale) {
    return set_label(panel, store,
                     fmt::format("{}_{{\\mathrm{{{}}}}}", symbol, comparison_name(*panel.stage)),
                     scale);
}

void add_ghost_arrow(const Panel& panel, const Eigen::Vector3d& tip, const TextBlock& type,
                     ViewBuilder& builder) {
    if (!(tip.norm() <= out_of_picture)) return;
    add_named_arrow(panel, arrow_to(panel, tip, panel.stage->theme.ghost, 0.95), type, builder);
}

Drawer make_ghost(const Panel& panel, StageStore& store) {
    require_beside(panel, "ghost");
    Ellipsoid ellipsoid = ellipsoid_of(panel);
    ellipsoid.colour = panel.stage->theme.ghost;
    ellipsoid.line_colour = panel.stage->theme.ghost;
    // Only its outline, so that nobody takes the two for a nut and its shell.
    ellipsoid.opacity = 0.02;
    ellipsoid.section_px = 0.0;
    ellipsoid.ruling_px = 0.0;
    ellipsoid.casts_shadow = false;
    add_contour(panel, panel.stage->theme.ghost, ellipsoid);
    const TextBlock type = set_ghost_label(panel, store, "\\boldsymbol{\\omega}");
    const bool beyond = is_shown(*panel.stage, "radius");
    return [&panel, ellipsoid, type, beyond](const FrameInput& instant, ViewBuilder& builder) {
        const ConstructionPicture& picture = *panel.stage->rolling;
        const Eigen::Quaterniond turn =
            picture.picture_from_space * instant.comparison->space_from_body;
        builder.view.ellipsoids.push_back(ellipsoid);
        builder.view.ellipsoids.back().half_axes =
            turn.toRotationMatrix() * picture.construction.inertia().body_from_principal() *
            picture.half_axes.asDiagonal();
        const Eigen::Vector3d contact = contact_of(picture, *instant.comparison);
        // Ends like ω's arrow, which depends on whether ρ is shown.
        add_ghost_arrow(panel, beyond ? spin_axis_end(contact) : contact, type, builder);
        if (contact.norm() <= out_of_picture) {
            builder.view.dots.push_back(dot_at(panel, contact, panel.stage->theme.ghost, 5.5));
        }
    };
}

Drawer make_drift(const Panel& panel, StageStore& store) {
    require_beside(panel, "drift");
    const ConstructionPicture& picture = *panel.stage->rolling;
    GhostPath ghost = ghost_path(
        panel, store, [&picture](const RotationState& state) { return contact_of(picture, state); },
        3.2);
    // Visible through the plane, too, since it shows how far the method's error lets it sink.
    ghost.curve.hidden_opacity = 0.75;
    return [ghost](const FrameInput& instant, ViewBuilder& builder) {
        add_ghost_path(ghost, instant, builder);
    };
}

}  // namespace poinsot
