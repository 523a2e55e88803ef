// The top panel: a heavy top on its fixed point, the path of its axis on the unit sphere between
// the circles θ1 and θ2, and its Euler angles z-x-z as arcs.
//
// The body is drawn as a symbol: a top of revolution about e3, on the side of the centre of mass,
// not to the scale of the moments. The panel reads only the motion's Euler angles.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "bodies/solid_meshes.h"
#include "construction/timed_path.h"
#include "drawing/figures/elements/ghost.h"
#include "drawing/figures/elements/trail.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/framing.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/possible_motions.h"
#include "drawing/style/theme_contrast.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

using std::numbers::pi;
constexpr int the_sphere = 0;

// Lengths in units of the sphere's radius.
constexpr double vertical_length = 1.22;
constexpr double theta_radius = 0.85;
constexpr double phi_radius = 0.50;
constexpr double psi_radius = 0.36;
constexpr double turn_spacing = 0.045;  // of the circles that count whole turns of φ
constexpr double most_turns = 6.0;      // that are drawn as circles
constexpr double node_length = 0.80;
constexpr double e1_length = 0.62;
constexpr double far_opacity = 0.4;      // of curves on the sphere's far side
constexpr double centre_of_mass = 0.43;  // on the axis, in the disc's middle

// e1, e2, e3 of the Euler angles as columns, space axes: Rz(φ) Rx(θ) Rz(ψ).
Eigen::Matrix3d axes_of(const EulerAngles& euler) {
    return (Eigen::AngleAxisd(euler.phi_rad, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(euler.theta_rad, Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(euler.psi_rad, Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

// An angle reduced to [0, 2π).
double within_turn(double angle_rad) {
    const double turn = std::fmod(angle_rad, 2.0 * pi);
    return turn < 0.0 ? turn + 2.0 * pi : turn;
}

// Arcs shorter than this on the picture are not drawn, px at 1080 rows.
constexpr double least_arc_px = 40.0;

// Whether ψ turns too fast for an arc to be followed with the eye: by more than 0.4 turns in a
// second of film, on average over the film. It is the same at every instant, so that the arc does
// not come and go.
bool spins_fast(const StageContext& stage) {
    constexpr double most_turns_per_s = 0.4;
    const Quantities angles{.attitude = false, .herpolhode = false, .euler_angles = true};
    const double first_s = stage.film_first_s, last_s = stage.film_last_s;
    const double turned_rad = stage.motion.sample(last_s, angles).euler.psi_rad -
                              stage.motion.sample(first_s, angles).euler.psi_rad;
    const double film_s = (last_s - first_s) / stage.scene.film.speed;
    return std::abs(turned_rad) > 2.0 * pi * most_turns_per_s * film_s;
}

// A top about z with its point at the origin: cone, disc and stem.
const MeshGeometry* keep_top(StageStore& store) {
    constexpr std::array<ProfilePoint, 13> profile{{{0.0, 0.0},
                                                    {0.018, 0.012},
                                                    {0.045, 0.10},
                                                    {0.09, 0.27},
                                                    {0.37, 0.375},
                                                    {0.405, 0.395},
                                                    {0.415, 0.42},
                                                    {0.405, 0.445},
                                                    {0.37, 0.46},
                                                    {0.07, 0.505},
                                                    {0.032, 0.54},
                                                    {0.028, 0.66},
                                                    {0.0, 0.66}}};
    ShadedCorners corners = shaded_corners(revolved(profile));
    return store.keep({0, std::move(corners.positions), std::move(corners.normals)});
}

// Radii on the disc's upper face, which make the spin visible.
std::vector<Curve> spokes_of(const Panel& panel) {
    std::vector<Curve> spokes;
    constexpr int n = 6;
    for (int k = 0; k < n; ++k) {
        const double angle = 2.0 * pi * k / n;
        const auto point = [angle](double radius, double z) {
            return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
        };
        spokes.push_back(line_between(panel, point(0.09, 0.507), point(0.365, 0.465),
                                      panel.stage->theme.solid_lines, k == 0 ? 4.0 : 1.6));
    }
    return spokes;
}

// The path of e3 on the sphere over the stage's span.
struct Locus {
    Curve curve;
    Trail trail;
};

Locus locus_of(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    const auto axis_at = [&](double t) {
        const MotionSample sample =
            stage.motion.sample(t, {.attitude = false, .herpolhode = false, .euler_angles = true});
        return Eigen::Vector3d(axes_of(sample.euler).col(2));
    };
    const double rate = stage.quickest_rate_rad_s();
    constexpr std::size_t most_points = 800'000;  // of a fast top's many small nutations
    TimedPath path = sample_path(axis_at, stage.options.first_time_s, stage.options.last_time_s,
                                 rate > 0.0 ? pi / rate : 1.0, panel.curve_units(), most_points);
    Trail trail(stage, stage.scene.trail.axis, path, {});
    Curve curve = curve_of(panel,
                           keep(panel, store, {.points = std::move(path.points)}, path.off,
                                "the path of the top's axis"),
                           path_of_e3(stage.theme), 4.0);
    curve.on_surface = the_sphere;
    curve.hidden_opacity = far_opacity;
    return {curve, std::move(trail)};
}

// e3 of the comparison motion and its path on the sphere. Empty without one.
Drawer make_ghost_axis(Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    if (!stage.comparison) return [](const FrameInput&, ViewBuilder&) {};
    panel.shows_comparison = true;
    // A stepped motion has no Euler angles: e3 in body axes is taken from the exact motion at one
    // instant.
    const MotionSample sample = stage.motion.sample(
        stage.options.first_time_s, {.attitude = true, .herpolhode = false, .euler_angles = true});
    const Eigen::Vector3d e3_body =
        sample.state.space_from_body.conjugate() * axes_of(sample.euler).col(2);
    const auto axis_of = [e3_body](const RotationState& state) {
        return Eigen::Vector3d(state.space_from_body * e3_body);
    };
    GhostPath path = ghost_path(panel, store, axis_of, 3.2);
    path.curve.on_surface = the_sphere;
    const TextBlock type = set_ghost_label(panel, store, "\\mathbf{e}");
    return [&panel, path, axis_of, type](const FrameInput& instant, ViewBuilder& builder) {
        add_ghost_path(path, instant, builder);
        add_ghost_arrow(panel, axis_of(*instant.comparison), type, builder);
    };
}

// A circle of latitude on the sphere at an angle from the upward vertical.
Curve latitude(const Panel& panel, double theta_rad, const LineStyle& colour, double width_px) {
    Curve circle =
        arc_curve(panel, {.centre = {0.0, 0.0, std::cos(theta_rad)}, .radius = std::sin(theta_rad)},
                  colour, width_px);
    circle.on_surface = the_sphere;
    circle.hidden_opacity = far_opacity;
    return circle;
}

// The static parts: the sphere, its circles, the vertical and the directions x and y.
struct Stand {
    Ellipsoid sphere;
    std::vector<Curve> curves;
    std::array<Arrow, 3> arrows;
};

Stand stand_of(const Panel& panel, const TopNutation& nutation) {
    const Theme& theme = panel.stage->theme;
    Stand stand;
    stand.sphere.colour = theme.sphere;
    stand.sphere.opacity = 0.10;
    stand.sphere.hides_far_curves = true;
    stand.sphere.section_px = 0.0;
    stand.sphere.ruling_px = 0.0;
    stand.sphere.casts_shadow = false;
    add_contour(panel, theme.rule, stand.sphere);
    stand.curves.push_back(latitude(panel, 0.5 * pi, theme.rule, 1.6));
    // Steady precession is along one circle; at the poles there is none.
    std::vector<double> ends{nutation.theta_min_rad};
    if (nutation.theta_max_rad - nutation.theta_min_rad > 1e-3) {
        ends.push_back(nutation.theta_max_rad);
    }
    for (const double theta : ends) {
        if (std::sin(theta) < 1e-3) continue;
        Curve circle = latitude(panel, theta, theme.angles[0], 2.2);
        circle.dash_px = dash_of(panel, theme.angles[0], 8.0);
        stand.curves.push_back(circle);
    }
    stand.arrows[0] = arrow_to(panel, {0.0, 0.0, vertical_length}, theme.text, 0.85);
    stand.arrows[1] = arrow_to(panel, {1.12, 0.0, 0.0}, theme.text, 0.6);
    stand.arrows[2] = arrow_to(panel, {0.0, 1.12, 0.0}, theme.text, 0.6);
    for (Arrow& arrow : stand.arrows) arrow.opacity = 0.75;
    return stand;
}

// The names of axes and angles.
struct Names {
    TextBlock z, x, y, node, e1, e3, theta, phi, psi, turn, height;
};

Names names_of(const Panel& panel, StageStore& store) {
    return {set_label(panel, store, "z", 0.9),
            set_label(panel, store, "x", 0.8),
            set_label(panel, store, "y", 0.8),
            set_label(panel, store, "N", 0.8),
            set_label(panel, store, "\\mathbf{e}_1", 0.8),
            set_label(panel, store, "\\mathbf{e}_3", 0.95),
            set_label(panel, store, "\\theta"),
            set_label(panel, store, "\\varphi"),
            set_label(panel, store, "\\psi"),
            set_label(panel, store,
                      vertical_axis(*panel.stage) < 0 ? "\\varphi - \\psi" : "\\varphi + \\psi"),
            set_label(panel, store, "l\\cos\\theta", 0.75)};
}

class TopDrawer {
 public:
    TopDrawer(const Panel& panel, ViewBuilder& builder, const EulerAngles& euler)
        : panel_(&panel), sheet_(&builder), euler_(euler), axes_(axes_of(euler)) {}

    // The symbol of the body with its spokes, pointing the other way for Mgl < 0.
    void body(const MeshGeometry* geometry, const std::vector<Curve>& spokes, bool hangs) {
        Mesh mesh;
        mesh.geometry = geometry;
        mesh.placement.linear() =
            hangs ? Eigen::Matrix3d(axes_ * Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal()) : axes_;
        mesh.colour = panel_->stage->theme.solid;
        mesh.casts_shadow = false;
        sheet_->view.meshes.push_back(mesh);
        for (Curve spoke : spokes) {
            spoke.placement = mesh.placement * spoke.placement;
            sheet_->view.curves.push_back(spoke);
        }
    }

    // Arcs of θ, φ and ψ, the line of nodes between them, and e1, e3.
    void angles(const Names& names, bool shows_psi) {
        const Theme& theme = panel_->stage->theme;
        const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
        const Eigen::Vector3d node(std::cos(euler_.phi_rad), std::sin(euler_.phi_rad), 0.0);
        const Eigen::Vector3d leaning(node.y(), -node.x(), 0.0);  // direction in which e3 leans
        const Eigen::Vector3d e3 = axes_.col(2);

        Curve nodes =
            line_between(*panel_, -0.35 * node_length * node, node_length * node, theme.text, 2.0);
        nodes.dash_px = 7.0 * panel_->px;
        sheet_->view.curves.push_back(nodes);
        request_label_beside(*panel_, node_length * node, Eigen::Vector3d::Zero(), names.node,
                             theme.text, *sheet_);

        add_arc(
            {.from = z, .towards = leaning, .radius = theta_radius, .angle_rad = euler_.theta_rad},
            theme.angles[0], names.theta);
        precession(theme.angles[1], names.phi);
        if (shows_psi)
            add_arc({.from = node,
                     .towards = e3.cross(node),
                     .radius = psi_radius,
                     .angle_rad = within_turn(euler_.psi_rad)},
                    theme.angles[2], names.psi);

        arrow(e1_length * axes_.col(0), theme.axes[0], 0.7, names.e1);
        arrow(e3, theme.axes[2], 1.0, names.e3);
    }

    // While the axis is vertical there is no line of nodes: only the angle from x to e1 has a
    // meaning.
    void turn(const Names& names, int vertical) {
        const Theme& theme = panel_->stage->theme;
        add_arc({.radius = phi_radius,
                 .angle_rad = within_turn(euler_.phi_rad + vertical * euler_.psi_rad)},
                theme.text, names.turn);
        arrow(e1_length * axes_.col(0), theme.axes[0], 0.7, names.e1);
        arrow(axes_.col(2), theme.axes[2], 1.0, names.e3);
    }

    // The centre of mass on the axis and its height above the fixed point, as in V = Mgl cos θ.
    // It has no name where it is the whole distance.
    void height(const TextBlock& name, bool hangs, bool is_named) {
        const LineStyle& colour = panel_->stage->theme.potential;
        const Eigen::Vector3d mass = (hangs ? -centre_of_mass : centre_of_mass) * axes_.col(2);
        const Eigen::Vector3d level(0.0, 0.0, mass.z());
        for (const auto& [a, b, width_px] :
             {std::tuple{mass, level, 2.0}, {Eigen::Vector3d::Zero().eval(), level, 5.0}}) {
            Curve line = line_between(*panel_, a, b, colour, width_px);
            line.hidden_opacity = 0.75;
            sheet_->view.curves.push_back(line);
        }
        sheet_->view.dots.push_back(dot_at(*panel_, mass, colour, 6.0));
        if (!is_named) return;
        // Where its upper end is, above the arc of φ; clear of the bar.
        request_label_beside(*panel_, level, mass, name, colour, *sheet_);
        sheet_->requests.back().gap_px += 7.0 * panel_->px;
    }

    void arrow(const Eigen::Vector3d& tip, const LineStyle& colour, double weight,
               const TextBlock& name) {
        sheet_->view.arrows.push_back(arrow_to(*panel_, tip, colour, weight));
        request_label_at_tip(*panel_, sheet_->view.arrows.back(), name, *sheet_);
    }

 private:
    // φ from x: a circle for each whole turn, and outside of them the arc of the rest, joined to
    // the last circle at x.
    void precession(const LineStyle& colour, const TextBlock& name) {
        const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
        const double whole =
            std::min(std::floor(std::abs(euler_.phi_rad) / (2.0 * pi)), most_turns);
        for (int k = 0; k < static_cast<int>(whole); ++k) {
            sheet_->view.curves.push_back(
                arc_curve(*panel_, {.radius = phi_radius + k * turn_spacing}, colour, 2.2));
            sheet_->view.curves.back().hidden_opacity = 0.5;
            sheet_->view.curves.push_back(line_between(*panel_, (phi_radius + k * turn_spacing) * x,
                                                       (phi_radius + (k + 1) * turn_spacing) * x,
                                                       colour, 2.2));
        }
        add_arc({.radius = phi_radius + whole * turn_spacing,
                 .angle_rad = std::fmod(euler_.phi_rad, 2.0 * pi)},
                colour, name, whole > 0.0);
    }

    // An arc about the fixed point with its label outside of its middle; nothing if it is too short
    // to be seen as one, unless it `goes_on` from another.
    void add_arc(const Arc& arc, const LineStyle& colour, const TextBlock& name,
                 bool goes_on = false) {
        const auto at = [&](double angle) -> Eigen::Vector3d {
            return arc.radius * (std::cos(angle) * arc.from + std::sin(angle) * arc.towards);
        };
        double length_px = 0.0;
        constexpr int n = 24;
        for (int k = 0; k < n; ++k)
            length_px += (project(sheet_->view, at(arc.angle_rad * (k + 1) / n)).px -
                          project(sheet_->view, at(arc.angle_rad * k / n)).px)
                             .norm();
        if (!goes_on && length_px < least_arc_px * panel_->px) return;
        sheet_->view.curves.push_back(arc_curve(*panel_, arc, colour, 3.2));
        sheet_->view.curves.back().hidden_opacity = 0.5;
        request_label_beside(*panel_, at(0.5 * arc.angle_rad), arc.centre, name, colour, *sheet_);
    }

    const Panel* panel_;
    ViewBuilder* sheet_;
    EulerAngles euler_;
    Eigen::Matrix3d axes_;
};

}  // namespace

void make_top_panel(Panel& panel, StageStore& store) {
    panel.needs = {.attitude = false, .herpolhode = false, .euler_angles = true};
    const HeavyTop& top = *panel.stage->motion.motion().heavy_top();
    // The whole sphere, also where nothing happens: a cut one reads as a fault of the picture.
    std::vector<Eigen::Vector3d> points = points_of_ellipsoid(Eigen::Matrix3d::Identity());
    points.emplace_back(0.0, 0.0, vertical_length);
    aim_around(panel, std::move(points), 0.7 * label_em_px(panel) + 24.0 * panel.px);

    const auto& gravity = std::get<Gravity>(panel.stage->motion.motion().problem().torque);
    const bool hangs = gravity.mgl_N_m < 0.0;
    const Stand stand = stand_of(panel, top.nutation());
    const Locus locus = locus_of(panel, store);
    const MeshGeometry* body = keep_top(store);
    const std::vector<Curve> spokes = spokes_of(panel);
    const Names names = names_of(panel, store);
    const int vertical = vertical_axis(*panel.stage);
    const bool shows_psi = !spins_fast(*panel.stage);
    const Drawer ghost = make_ghost_axis(panel, store);
    panel.draw = [&panel, hangs, vertical, shows_psi, stand, locus, body, spokes, names, ghost](
                     const FrameInput& instant, ViewBuilder& builder) {
        builder.view.ellipsoids.push_back(stand.sphere);
        builder.view.curves = stand.curves;
        name_shapes("unit-sphere", builder);
        for (const Arrow& arrow : stand.arrows) builder.view.arrows.push_back(arrow);
        request_label_at_tip(panel, stand.arrows[0], names.z, builder);
        request_label_at_tip(panel, stand.arrows[1], names.x, builder);
        request_label_at_tip(panel, stand.arrows[2], names.y, builder);
        name_shapes("space-axes", builder);
        TopDrawer drawer(panel, builder, instant.euler);
        drawer.body(body, spokes, hangs);
        name_shapes("top", builder);
        if (vertical != 0)
            drawer.turn(names, vertical);
        else
            drawer.angles(names, shows_psi);
        name_shapes("angles", builder);
        drawer.height(names.height, hangs, vertical == 0);
        name_shapes("height", builder);
        builder.view.curves.push_back(locus.curve);
        locus.trail.at(instant.time_s).apply_to(builder.view.curves.back());
        name_shapes("locus", builder);
        ghost(instant, builder);
        name_shapes("ghost", builder);
        builder.view.dots.push_back(
            dot_at(panel, Eigen::Vector3d::Zero(), panel.stage->theme.contact, 5.0));
        builder.view.dots.push_back(
            dot_at(panel, axes_of(instant.euler).col(2), panel.stage->theme.axes[2]));
    };
}

}  // namespace poinsot
