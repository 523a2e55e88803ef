// Elements of textbook figures of the body and its rates: axes, half-axes, rates of precession.
// Rows of the table in element_rows.h; picture axes.
#include "drawing/figures/elements/figure_elements.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "construction/montgomery_phase.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/figures/elements/object_shapes.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/label_requests.h"
#include "error/error.h"
#include "shapes/projection.h"
#include "text/languages.h"

namespace poinsot {

// The axes x, y, z in which the scene's numbers are given.
Drawer make_given_axes(const Panel& panel, StageStore& store) {
    const std::array<TextBlock, 3> types{set_label(panel, store, "x", 0.85),
                                         set_label(panel, store, "y", 0.85),
                                         set_label(panel, store, "z", 0.85)};
    return [&panel, types](const FrameInput& instant, ViewBuilder& builder) {
        const Eigen::Matrix3d axes =
            picture_of(panel).picture_from_body(instant).toRotationMatrix();
        for (int i = 0; i < 3; ++i) {
            Arrow arrow = arrow_to(panel, given_axis_length * axes.col(i),
                                   panel.stage->theme.potential, 0.65);
            arrow.opacity = 0.85;
            add_named_arrow(panel, arrow, types[static_cast<std::size_t>(i)], builder);
        }
    };
}

namespace {

// Arcs about the axis of a turn from each of some points, the columns, to where the turn takes it,
// with a name at the longest.
void add_turn_of_axes(const Panel& panel, const Eigen::Matrix3Xd& from_points,
                      const Eigen::AngleAxisd& turn, const LineStyle& colour, const TextBlock& type,
                      ViewBuilder& builder) {
    double longest = 0.0;
    Eigen::Vector3d middle = turn.axis();
    for (Eigen::Index i = 0; i < from_points.cols(); ++i) {
        const Eigen::Vector3d tip = from_points.col(i);
        const Eigen::Vector3d centre = tip.dot(turn.axis()) * turn.axis();
        const Eigen::Vector3d from = tip - centre;
        const double radius = from.norm();
        if (!(radius > 0.1)) continue;
        const double arc_rad = std::max(0.0, turn.angle() - 0.8 * arc_head_rad(radius));
        add_arc_arrow(panel, {centre, turn.axis(), radius, arc_rad}, from / radius, colour,
                      builder);
        if (!(radius > longest)) continue;
        longest = radius;
        middle = centre + Eigen::AngleAxisd(0.5 * turn.angle(), turn.axis()) * from;
    }
    request_label_beside(panel, middle, Eigen::Vector3d::Zero(), type, colour, builder);
    builder.requests.back().gap_px = 18.0 * panel.px;
}

}  // namespace

// The rotation from x, y, z to e1, e2, e3: about its axis u, an arc from each old to each new axis,
// with the angle at the longest arc.
Drawer make_turn(const Panel& panel, StageStore& store) {
    // The rotation that takes x, y, z to e1, e2, e3: about one axis by one angle (Euler's theorem).
    const Eigen::AngleAxisd turn(picture_of(panel).construction.inertia().body_from_principal());
    const double degrees = turn.angle() * 180.0 / std::numbers::pi;
    const std::string number = with_decimal_mark(
        fmt::format("{:.1f}°", degrees), decimal_mark_in_formula(panel.stage->scene.language));
    const TextBlock type = set_label(panel, store, number, 0.85);
    const TextBlock axis_type = set_label(panel, store, "\\mathbf{u}", 0.85);
    return [&panel, turn, type, axis_type](const FrameInput& instant, ViewBuilder& builder) {
        if (!(turn.angle() > 0.0)) return;
        const LineStyle& colour = panel.stage->theme.angles[0];
        const Eigen::Vector3d axis = picture_of(panel).picture_from_body(instant) * turn.axis();
        Curve line =
            line_between(panel, Eigen::Vector3d::Zero(), turn_axis_length * axis, colour, 2.0);
        line.hidden_opacity = 0.6;
        builder.view.curves.push_back(line);
        request_label_beside(panel, turn_axis_length * axis, Eigen::Vector3d::Zero(), axis_type,
                             colour, builder);
        const Eigen::Matrix3d given =
            picture_of(panel).picture_from_body(instant).toRotationMatrix();
        constexpr double reach = 1.12;
        add_turn_of_axes(panel, reach * given, Eigen::AngleAxisd(turn.angle(), axis), colour, type,
                         builder);
    };
}

// The principal axis that is farthest from L, at the start of the film, and its turn about L in one
// polhode period, as an angle from 0 to a whole turn. All axes turn by the same angle; three arcs
// would look like three. Throws InputError for a motion without such a period.
Drawer make_period_turn(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    const std::optional<MontgomeryPhase> phase = montgomery_phase(stage.motion.motion().problem());
    if (!phase)
        throw InputError(
            "show: period-turn needs a torque-free motion whose polhode has a period; leave it "
            "out");
    if (stage.turns())
        throw InputError(
            "show: a co-precessing camera turns by the angle that period-turn shows; leave out one "
            "of them");
    constexpr double whole = 2.0 * std::numbers::pi;
    const double n_whole = std::floor(phase->turned_rad / whole);
    const double angle_rad = phase->turned_rad - whole * n_whole;
    const Eigen::AngleAxisd turn(angle_rad, picture_of(panel).normal);
    FrameInput start;
    start.state = stage.motion.sample(stage.film_first_s, attitude_too).state;
    Eigen::Matrix3d axes = picture_of(panel).principal_axes(start);
    for (int i = 0; i < 3; ++i) axes.col(i) *= picture_of(panel).half_axes[i] + axis_overhang;
    Eigen::Index widest = 0;
    const Eigen::Vector3d normal = picture_of(panel).normal;
    for (Eigen::Index i = 1; i < 3; ++i)
        if (axes.col(i).cross(normal).norm() > axes.col(widest).cross(normal).norm()) widest = i;
    std::string name = "\\Delta\\varphi";
    if (n_whole != 0.0) {
        name += n_whole > 0.0 ? " - " : " + ";
        if (std::abs(n_whole) > 1.0) name += fmt::format("{}\\cdot", std::abs(n_whole));
        name += "360°";
    }
    name += with_decimal_mark(fmt::format(" = {:.2f}°", angle_rad * 180.0 / std::numbers::pi),
                              decimal_mark_in_formula(stage.scene.language));
    const TextBlock type = set_label(panel, store, name, 0.85);
    const Eigen::Vector3d axis = axes.col(widest);
    const LineStyle& ink = stage.theme.axes[static_cast<std::size_t>(widest)];
    return [&panel, axis, turn, type, ink](const FrameInput&, ViewBuilder& builder) {
        Curve line = line_between(panel, Eigen::Vector3d::Zero(), axis, ink, 3.0);
        line.opacity = 0.7;
        line.hidden_opacity = 0.45;
        builder.view.curves.push_back(line);
        // Inside of the arrow's head.
        constexpr double reach = 0.9;
        add_turn_of_axes(panel, reach * axis, turn, panel.stage->theme.angles[1], type, builder);
    };
}

void add_half_axes(const Panel& panel, const Eigen::Matrix3d& principal_axes,
                   const Eigen::Vector3d& half_axes, const std::array<TextBlock, 3>& types,
                   ViewBuilder& builder) {
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d end = principal_axes.col(i) * half_axes[i];
        const LineStyle& colour = panel.stage->theme.axes[i];
        Curve line = line_between(panel, Eigen::Vector3d::Zero(), end, colour, 5.0);
        line.hidden_opacity = 0.75;
        builder.view.curves.push_back(line);
        builder.view.dots.push_back(dot_at(panel, end, colour, 5.0));
        // The label is at the end, since beside the middle it would be too near to that of ρ, and
        // beside the line, which may continue as the arrow of the axis.
        request_label_beside(panel, end, Eigen::Vector3d::Zero(),
                             types[static_cast<std::size_t>(i)], colour, builder);
        constexpr double turn_rad = 1.1;
        Eigen::Vector2d& away = builder.requests.back().away;
        away = Eigen::Rotation2Dd(turn_rad) * away;
    }
}

// The half-axes from the centre to the surface along e1, e2, e3, labelled 1/√I.
Drawer make_half_axes(const Panel& panel, StageStore& store) {
    const std::array<TextBlock, 3> types = set_half_axis_labels(panel, store, 0.8);
    return [&panel, types](const FrameInput& instant, ViewBuilder& builder) {
        add_half_axes(panel, picture_of(panel).principal_axes(instant), picture_of(panel).half_axes,
                      types, builder);
    };
}

// The two rates whose sum is ω: L/I₁ about L, at which the axis of symmetry goes round L, and ψ̇ =
// −Ω about that axis, at which the body turns meanwhile. Throws InputError for a body without two
// equal moments.
Drawer make_precession(const Panel& panel, StageStore& store) {
    if (!picture_of(panel).cones) {
        throw InputError(
            "show: precession needs a body with exactly two equal moments; leave it out");
    }
    const RollingCones cones = *picture_of(panel).cones;
    const int across = cones.symmetry_axis == 0 ? 2 : 1;
    const TextBlock of_spin = set_label(panel, store, "\\dot\\psi", 0.9);
    const TextBlock in_space = set_label(panel, store, fmt::format("L/I_{}", across), 0.85);
    return [&panel, cones, of_spin, in_space](const FrameInput& instant, ViewBuilder& builder) {
        const ConstructionPicture& picture = picture_of(panel);
        const Theme& theme = panel.stage->theme;
        // Each ring is about a line along its axis: at the tips of the axis and of L, or, if the
        // plane is shown, on the side away from it.
        const double side = is_shown(*panel.stage, "plane") ? -1.0 : 1.0;
        const Eigen::Vector3d axis = picture.principal_axes(instant).col(cones.symmetry_axis);
        const Eigen::Vector3d end =
            side * axis.dot(picture.normal) > 0.0 ? axis : Eigen::Vector3d(-axis);
        const double beyond = picture.half_axes[cones.symmetry_axis] + 0.62 * axis_overhang;
        builder.view.curves.push_back(line_between(panel, Eigen::Vector3d::Zero(),
                                                   (beyond + 0.5 * axis_overhang) * end,
                                                   theme.axes[cones.symmetry_axis], 3.0));
        add_turn(panel, {beyond * end, axis, 0.2, -std::copysign(5.0, cones.body_precession_rad_s)},
                 theme.body_cone, of_spin, builder);
        // Beyond the name of L.
        const double about_momentum = side > 0.0 ? momentum_tip(picture).norm() + 0.24 : 1.22;
        builder.view.curves.push_back(line_between(panel, Eigen::Vector3d::Zero(),
                                                   side * (about_momentum + 0.14) * picture.normal,
                                                   theme.momentum, 2.0));
        add_turn(panel, {side * about_momentum * picture.normal, picture.normal, 0.2, 5.0},
                 theme.space_cone, in_space, builder);
    };
}

double body_in_ellipsoid(const ConstructionPicture& picture) {
    return 0.85 * picture.half_axes.minCoeff();
}

// The body, inside its ellipsoid.
Drawer make_body(const Panel& panel, StageStore& store) {
    const BodyShape shape = body_shape(panel, store);
    const double scale = body_in_ellipsoid(picture_of(panel));
    return [&panel, shape, scale](const FrameInput& instant, ViewBuilder& builder) {
        Eigen::Affine3d turned = Eigen::Affine3d::Identity();
        turned.linear() = scale * picture_of(panel).picture_from_body(instant).toRotationMatrix();
        add_body(shape, turned, false, builder);
    };
}

// At the height of the centre, so far to the left that it is clear of the ellipsoid, whose largest
// half-axis is 1.
Drawer make_body_beside(const Panel& panel, StageStore& store) {
    const BodyShape shape = body_shape(panel, store);
    const std::array<TextBlock, 3> types = set_axis_labels(panel, store);
    return [&panel, shape, types](const FrameInput& instant, ViewBuilder& builder) {
        constexpr double aside = 1.75, reach = 0.5, beyond = 0.16;
        Eigen::Vector3d left = -camera_axes(builder.view.camera).col(0);
        left.z() = 0.0;
        const Eigen::Vector3d middle = aside * left.stableNormalized();
        Eigen::Affine3d placed = Eigen::Affine3d::Identity();
        placed.linear() = reach * picture_of(panel).picture_from_body(instant).toRotationMatrix();
        placed.translation() = middle;
        add_body(shape, placed, false, builder);
        const Eigen::Matrix3d axes = picture_of(panel).principal_axes(instant);
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3d end = (reach * shape.extents[i] + beyond) * axes.col(i);
            const Arrow arrow =
                arrow_between(panel, middle, middle + end, panel.stage->theme.axes[i], 0.8);
            builder.view.arrows.push_back(arrow);
            request_label_beside(panel, arrow.tip, middle, types[static_cast<std::size_t>(i)],
                                 arrow.colour, builder);
        }
    };
}

}  // namespace poinsot
