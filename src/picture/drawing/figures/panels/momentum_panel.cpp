// The momentum panel: in body axes, L moves on the sphere |m| = L and on the ellipsoid of energy Σ
// mᵢ²/2Iᵢ = T, both conserved, so it moves on the curves in which they intersect. In units of L the
// sphere has radius 1 and the ellipsoid the half-axes √(2TIᵢ)/L.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "construction/adaptive_curve.h"
#include "drawing/figures/charts/plot_frame.h"
#include "drawing/figures/elements/body_axes.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/figures/elements/ghost.h"
#include "drawing/figures/elements/trail.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/framing.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/overlay.h"
#include "drawing/style/theme_contrast.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// An ellipsoid longer than this, in radii of the sphere, would make the sphere too small: its ends
// are left out of the frame.
constexpr double longest_framed = 2.2;

// −ω × L at a point ρ of the polhode, where L has length 1: the velocity of L in the body. Its
// length is that of ω × L with the unit of ω in which the longest half-axis is ρ.
Eigen::Vector3d velocity_at(const Panel& panel, const Eigen::Vector3d& contact_body) {
    constexpr double per_rate = 0.75;
    const Eigen::Vector3d rho =
        principal_from_body(panel) * contact_body * panel.stage->rolling->picture_per_rho;
    return per_rate * momentum_direction(panel, contact_body).cross(rho);
}

// The arrow along ω, with the same length as in other panels.
Eigen::Vector3d omega_at(const Panel& panel, const Eigen::Vector3d& contact_body) {
    return omega_tip(principal_from_body(panel) * contact_body *
                     panel.stage->rolling->picture_per_rho);
}

// Tips of these arrows over the motion, for the frame.
std::vector<Eigen::Vector3d> tips_of_arrows(const Panel& panel) {
    const Polhode& polhode = panel.stage->rolling->polhode;
    std::vector<Eigen::Vector3d> tips;
    constexpr int n = 48;
    for (int k = 0; k <= n; ++k) {
        const Eigen::Vector3d rho = polhode.at(
            polhode.first_chi_rad() + (polhode.last_chi_rad() - polhode.first_chi_rad()) * k / n);
        tips.push_back(omega_at(panel, rho));
        tips.push_back(momentum_direction(panel, rho) + velocity_at(panel, rho));
    }
    return tips;
}

// One of the curves in which sphere and ellipsoid meet; its mirror image in the centre is the
// other.
const CurveGeometry* keep_meeting_curve(const Panel& panel, StageStore& store) {
    const Polhode& polhode = panel.stage->rolling->polhode;
    const SampledCurve sampled =
        sample_adaptively([&](double chi) { return momentum_direction(panel, polhode.at(chi)); },
                          {.first = polhode.first_chi_rad(),
                           .last = polhode.last_chi_rad(),
                           .tolerance = panel.curve_units()});
    CurveGeometry geometry;
    geometry.closed = polhode.closed();
    for (const CurveSample& sample : sampled.samples) geometry.points.push_back(sample.point);
    if (geometry.closed) geometry.points.pop_back();
    return keep(panel, store, std::move(geometry), sampled.off,
                "the curve in which sphere and ellipsoid meet");
}

// m of the comparison motion in units of the L of the start, principal axes: a drift of L moves it
// off the sphere.
Eigen::Vector3d comparison_momentum(const Panel& panel, const RotationState& state) {
    const MotionProblem& problem = panel.stage->motion.motion().problem();
    const Eigen::Vector3d& moments = problem.inertia.moments_kg_m2();
    const Eigen::Vector3d weights = moments / moments.maxCoeff();
    const double rate = norm_of(problem.start.omega_body);
    const auto momentum = [&](const Eigen::Vector3d& omega_body) -> Eigen::Vector3d {
        return weights.cwiseProduct(principal_from_body(panel) * (omega_body / rate));
    };
    return momentum(state.omega_body) / momentum(problem.start.omega_body).norm();
}

// The path of the comparison motion, which leaves the curve of intersection. Empty without one.
Drawer make_momentum_comparison(Panel& panel, StageStore& store) {
    if (!panel.stage->comparison) return [](const FrameInput&, ViewBuilder&) {};
    panel.shows_comparison = true;
    const GhostPath path = ghost_path(
        panel, store,
        [&panel](const RotationState& state) { return comparison_momentum(panel, state); }, 2.6);
    const TextBlock type = set_ghost_label(panel, store, "\\mathbf{L}");
    return [&panel, path, type](const FrameInput& instant, ViewBuilder& builder) {
        add_ghost_path(path, instant, builder);
        add_ghost_arrow(panel, comparison_momentum(panel, *instant.comparison), type, builder);
    };
}

// With dissipation: the path of L over the sphere, as much of it as the trail of the polhode.
Drawer make_momentum_spiral(const Panel& panel, StageStore& store) {
    TimedCurve timed = polhode_trail(
        *panel.stage, panel.curve_units(),
        [&panel](const Eigen::Vector3d& point) { return momentum_direction(panel, point); });
    CurveGeometry geometry;
    geometry.points = std::move(timed.points);
    Curve curve =
        curve_of(panel, keep(panel, store, std::move(geometry), timed.off, "the path of L"),
                 panel.stage->theme.polhode, 4.0);
    curve.on_surface = first_ellipsoid;
    curve.hidden_opacity = 0.5;
    return traversed(std::move(curve), std::move(timed.trail));
}

Eigen::Vector3d energy_half_axes(const Panel& panel) {
    const PoinsotConstruction& construction = panel.stage->rolling->construction;
    return construction.plane_distance() * construction.inertia().moments_kg_m2().cwiseSqrt();
}

// The equations of the two surfaces, in their colours, in the lower left corner; as sums where they
// would reach into the next panel.
std::vector<Label> legend_of(const Panel& panel, StageStore& store) {
    const Theme& theme = panel.stage->theme;
    struct Row {
        std::string_view whole, sum;
        Colour colour;
    };
    const std::array<Row, 2> rows{{
        {"L_1^2 + L_2^2 + L_3^2 = L^2", "\\sum L_i^2 = L^2", letter_colour(theme, theme.sphere)},
        {"L_1^2/I_1 + L_2^2/I_2 + L_3^2/I_3 = 2T", "\\sum L_i^2/I_i = 2T",
         letter_colour(theme, theme.ellipsoid_lines)},
    }};
    constexpr double size = 0.72;
    std::vector<Label> legend;
    // In the first column it is left-aligned with the title.
    const double left =
        panel.box.x_px == 0 ? overlay_margin_px(*panel.stage) : 0.6 * chart_margin * panel.px;
    const bool has_room = std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
        return left + set_label(panel, store, row.whole, size).width_px() < panel.box.width_px;
    });
    double bottom = 0.5 * chart_margin * panel.px;
    for (const auto& [whole, sum, colour] : rows) {
        const TextBlock type = set_label(panel, store, has_room ? whole : sum, size);
        legend.push_back(chart_label(panel, type, left, bottom, Anchor::bottom_left, colour));
        bottom += type.height_px() + 10.0 * panel.px;
    }
    return legend;
}

// Rows reserved for the legend: none if it leaves the middle of the panel free.
double legend_rows(const Panel& panel, const std::vector<Label>& legend) {
    double top = panel.box.y_px + panel.box.height_px;
    double right = panel.box.x_px;
    for (const Label& label : legend) {
        top = std::min(top, label.top_left_px.y());
        right = std::max(right, label.top_left_px.x() + label.mask->width_px());
    }
    const bool in_the_way = right - panel.box.x_px > 0.35 * panel.box.width_px;
    return in_the_way ? panel.box.y_px + panel.box.height_px - top : 0.0;
}

// The constant |L| as a sphere, and the ellipsoid of constant T. Each surface keeps its tint where
// the other one covers it.
constexpr std::string_view surfaces_name = "momentum-sphere";

Ellipsoid momentum_sphere(const Panel& panel) {
    Ellipsoid sphere = ellipsoid_of(panel);
    sphere.colour = panel.stage->theme.sphere;
    sphere.section_px = 0.0;
    sphere.ruling_px = 0.0;
    sphere.opacity = 0.6;
    add_contour(panel, panel.stage->theme.rule, sphere);
    sphere.name = {surfaces_name, 0, ""};
    return sphere;
}

Ellipsoid energy_ellipsoid(const Panel& panel, const Eigen::Vector3d& half_axes) {
    Ellipsoid energy = ellipsoid_of(panel);
    energy.opacity *= 0.6;
    energy.half_axes = half_axes.asDiagonal();
    energy.section_px = 0.8 * panel.px;
    energy.ruling_px = 0.0;
    energy.name = {surfaces_name, 0, "ellipsoid"};
    return energy;
}

// The curve in which the surfaces meet and on which L moves, and the other curve of intersection,
// which this motion does not reach. None with dissipation or for a motion about a principal axis.
std::vector<Curve> meeting_curves(const Panel& panel, StageStore& store) {
    if (panel.stage->rolling->dissipates ||
        panel.stage->rolling->polhode.kind() == Polhode::Kind::point)
        return {};
    Curve reached =
        curve_of(panel, keep_meeting_curve(panel, store), panel.stage->theme.polhode, 4.6);
    reached.on_surface = first_ellipsoid;
    reached.hidden_opacity = 0.72;
    reached.name = {surfaces_name, 0, "path"};
    Curve other = reached;
    other.placement.linear() = -Eigen::Matrix3d::Identity();
    other.width_px = 1.9 * panel.px;
    other.opacity = 0.85;
    other.hidden_opacity = 0.16;
    return {reached, other};
}

// Aims the camera so that the surfaces, axes and arrows are in the picture and the legend is below
// the names of axes. `framed_axes`: the ellipsoid's half-axes, as far as they are framed.
void aim_at_momentum(Panel& panel, const Eigen::Vector3d& framed_axes,
                     const Eigen::Vector3d& axis_lengths, const std::vector<Label>& legend) {
    std::vector<Eigen::Vector3d> points = points_of_ellipsoid(Eigen::Matrix3d::Identity());
    for (const Eigen::Vector3d& point :
         points_of_ellipsoid(framed_axes.asDiagonal().toDenseMatrix()))
        points.push_back(point);
    for (int i = 0; i < 3; ++i) points.emplace_back(axis_lengths[i] * Eigen::Vector3d::Unit(i));
    for (const Eigen::Vector3d& tip : tips_of_arrows(panel)) points.push_back(tip);
    const double margin = 0.6 * label_em_px(panel) + 30.0 * panel.px;
    const Margins margins{margin, margin, margin + panel.header_px,
                          margin + legend_rows(panel, legend)};
    aim_in_principal_axes(panel, std::move(points), margins);
}

// What all instants share, and the drawer of an instant.
struct MomentumFigure {
    const Panel* panel = nullptr;
    std::vector<Label> legend;
    Ellipsoid sphere, energy;
    std::vector<Curve> curves;
    Eigen::Vector3d axis_lengths = Eigen::Vector3d::Ones();
    std::array<TextBlock, 3> axis_types;
    TextBlock momentum_type, omega_type, velocity_type;
    Drawer comparison;
    Drawer spiral;  // of L with dissipation; else empty
    Drawer elements;

    void operator()(const FrameInput& instant, ViewBuilder& builder) const {
        builder.view.labels = legend;
        builder.view.ellipsoids = {sphere, energy};
        builder.view.curves = curves;
        if (spiral) {
            // The ellipsoid of the remaining T, in units of the remaining L.
            builder.view.ellipsoids.back().half_axes =
                energy.half_axes * panel->stage->rolling->plane_approach(instant.state.omega_body);
            spiral(instant, builder);
        }
        name_shapes(surfaces_name, builder);
        elements(instant, builder);
        add_principal_axes(*panel, axis_lengths.asDiagonal(), 0.85, axis_types, builder);
        name_shapes("axes", builder);
        add_arrows(instant, builder);
        comparison(instant, builder);
        name_shapes("ghost", builder);
    }

    // ω, dL/dt in the body's axes, and L.
    void add_arrows(const FrameInput& instant, ViewBuilder& builder) const {
        const Theme& theme = panel->stage->theme;
        const PoinsotConstruction& construction = panel->stage->rolling->construction;
        const Eigen::Vector3d contact = construction.contact_body(instant.state.omega_body);
        const Eigen::Vector3d momentum = momentum_direction(*panel, contact);
        const auto add_arrow = [&](Arrow arrow, const TextBlock& type, double turn_rad) {
            arrow.hidden_opacity = 0.7;
            add_named_arrow(*panel, arrow, type, builder, turn_rad);
        };
        add_arrow(arrow_to(*panel, omega_at(*panel, contact), theme.omega, 1.15), omega_type,
                  omega_label_turn_rad);
        name_shapes("omega", builder);
        const Eigen::Vector3d velocity = velocity_at(*panel, contact);
        if (!velocity.isZero(1e-12)) {
            add_arrow(arrow_between(*panel, momentum, momentum + velocity, theme.potential, 1.0),
                      velocity_type, 0.0);
            name_shapes("velocity", builder);
        }
        add_arrow(arrow_to(*panel, momentum, theme.momentum, 1.15), momentum_type, 0.0);
        name_shapes("momentum", builder);
    }
};

}  // namespace

void make_momentum_panel(Panel& panel, StageStore& store) {
    const Eigen::Vector3d half_axes = energy_half_axes(panel);
    const Eigen::Vector3d framed_axes = half_axes.cwiseMin(longest_framed);
    MomentumFigure figure;
    figure.panel = &panel;
    figure.axis_lengths = framed_axes.cwiseMax(1.0).array() + axis_overhang;
    figure.legend = legend_of(panel, store);
    aim_at_momentum(panel, framed_axes, figure.axis_lengths, figure.legend);
    figure.sphere = momentum_sphere(panel);
    figure.energy = energy_ellipsoid(panel, half_axes);
    figure.curves = meeting_curves(panel, store);
    figure.axis_types = set_axis_labels(panel, store);
    figure.momentum_type = set_label(panel, store, "\\mathbf{L}");
    figure.omega_type = set_label(panel, store, "\\boldsymbol{\\omega}");
    figure.velocity_type =
        set_label(panel, store, "-\\boldsymbol{\\omega}\\times\\mathbf{L}", 0.85);
    figure.comparison = make_momentum_comparison(panel, store);
    if (panel.stage->rolling->dissipates) figure.spiral = make_momentum_spiral(panel, store);
    figure.elements = make_shown_elements(panel, store, uses_solid_angle);
    panel.draw = std::move(figure);
}

}  // namespace poinsot
