#include "drawing/elements/figure_elements.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "drawing/elements/object_shapes.h"
#include "drawing/marks.h"
#include "error/error.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

const ConstructionPicture& picture_of(const Panel& panel) { return *panel.stage->rolling; }

// ρ, the point of the ellipsoid that ω pierces: opposite to the contact.
Eigen::Vector3d pierced(const Panel& panel, const Instant& instant) {
    return -picture_of(panel).contact(instant);
}

// A label beside the middle part of a line, on its left as it runs on the picture.
void wish_beside_line(const Panel& panel, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      double share, const SetType& type, const Colour& colour, Sheet& sheet) {
    const Eigen::Vector2d a = project(sheet.view, from).px;
    const Eigen::Vector2d b = project(sheet.view, to).px;
    LabelWish wish;
    wish.type = type;
    wish.anchor_px = a + share * (b - a);
    wish.away = Eigen::Vector2d((b - a).y(), -(b - a).x()) / (100.0 * panel.px);
    wish.gap_px = 7.0 * panel.px;
    wish.colour = colour;
    sheet.wishes.push_back(wish);
}

// An arc with an arrow's head at its end: a rate about an axis, right-handed for positive angles.
struct Turn {
    Eigen::Vector3d centre, axis;  // the axis is a unit vector
    double radius = 0.2;
    double angle_rad = 5.0;
};

void add_turn(const Panel& panel, const Turn& turn, const Colour& colour, const SetType& type,
              Sheet& sheet) {
    const Eigen::Vector3d from = turn.axis.unitOrthogonal();
    const Eigen::Vector3d towards = turn.axis.cross(from);
    sheet.view.curves.push_back(
        arc_about(panel, turn.centre, from, towards, turn.radius, turn.angle_rad, colour, 3.2));
    const auto at = [&](double angle) {
        return Eigen::Vector3d(turn.centre +
                               turn.radius * (std::cos(angle) * from + std::sin(angle) * towards));
    };
    // The head follows the arc's end; its shaft hides in the arc.
    const double head = std::copysign(0.45, turn.angle_rad);
    Arrow arrow = arrow_between(panel, at(turn.angle_rad - 0.2 * head),
                                at(turn.angle_rad + 0.8 * head), colour, 0.85);
    arrow.shaft_px = 3.2 * panel.px;
    sheet.view.arrows.push_back(arrow);
    // Its name stands to the right, where neither axis nor arrow runs.
    const Eigen::Vector3d right = camera_axes(sheet.view.camera).col(0);
    wish_beside(panel, turn.centre + 1.1 * turn.radius * right, turn.centre, type, colour, sheet);
}

}  // namespace

Drawer make_given_axes(Panel& panel) {
    const std::array<SetType, 3> types{set_label(panel, "x", 0.85), set_label(panel, "y", 0.85),
                                       set_label(panel, "z", 0.85)};
    return [&panel, types](const Instant& instant, Sheet& sheet) {
        const Eigen::Matrix3d axes =
            picture_of(panel).picture_from_body(instant).toRotationMatrix();
        for (int i = 0; i < 3; ++i) {
            Arrow arrow = arrow_to(panel, 1.25 * axes.col(i), panel.stage->theme->potential, 0.65);
            arrow.opacity = 0.85;
            sheet.view.arrows.push_back(arrow);
            wish_at_tip(panel, arrow, types[static_cast<std::size_t>(i)], sheet);
        }
    };
}

Drawer make_half_axes(Panel& panel) {
    std::array<SetType, 3> types;
    for (std::size_t i = 0; i < 3; ++i) {
        types[i] = set_label(panel, fmt::format("1/\\sqrt{{I_{}}}", i + 1), 0.8);
    }
    return [&panel, types](const Instant& instant, Sheet& sheet) {
        const Eigen::Matrix3d axes = picture_of(panel).principal_axes(instant);
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3d end = axes.col(i) * picture_of(panel).half_axes[i];
            const Colour& colour = panel.stage->theme->axes[i];
            Curve line = line_between(panel, Eigen::Vector3d::Zero(), end, colour, 5.0);
            line.hidden_opacity = 0.75;
            sheet.view.curves.push_back(line);
            sheet.view.dots.push_back(dot_at(panel, end, colour, 5.0));
            // At its end: beside its middle it would crowd with the name of ρ.
            wish_beside(panel, end, Eigen::Vector3d::Zero(), types[static_cast<std::size_t>(i)],
                        panel.stage->theme->text, sheet);
        }
    };
}

Drawer make_radius(Panel& panel) {
    const SetType type = set_label(panel, "\\boldsymbol{\\rho}");
    return [&panel, type](const Instant& instant, Sheet& sheet) {
        const Eigen::Vector3d rho = pierced(panel, instant);
        const Colour& colour = panel.stage->theme->contact;
        Arrow arrow = arrow_to(panel, rho, colour, 1.3);
        arrow.hidden_opacity = 0.8;
        sheet.view.arrows.push_back(arrow);
        sheet.view.dots.push_back(dot_at(panel, rho, colour, 5.5));
        wish_beside_line(panel, Eigen::Vector3d::Zero(), rho, 0.6, type, colour, sheet);
    };
}

Drawer make_tangent(Panel& panel) {
    Plane plane;
    plane.radius = 0.75;
    plane.fade_from = 0.6;
    plane.grid_spacing = 0.15;
    plane.grid_px = 0.8 * panel.px;
    plane.colour = panel.stage->theme->plane;
    plane.grid_colour = panel.stage->theme->grid;
    plane.opacity = 0.45;
    return [&panel, plane](const Instant& instant, Sheet& sheet) {
        sheet.view.planes.push_back(plane);
        sheet.view.planes.back().centre = pierced(panel, instant);
    };
}

Drawer make_gradient(Panel& panel) {
    const SetType type = set_label(panel, "\\nabla F");
    return [&panel, type](const Instant& instant, Sheet& sheet) {
        constexpr double length = 0.55;
        const Eigen::Vector3d rho = pierced(panel, instant);
        const Arrow arrow = arrow_between(panel, rho, rho + length * Eigen::Vector3d::UnitZ(),
                                          panel.stage->theme->energy, 1.1);
        sheet.view.arrows.push_back(arrow);
        wish_at_tip(panel, arrow, type, sheet);
    };
}

Drawer make_distance(Panel& panel) {
    const SetType type = set_label(panel, "\\sqrt{2T}/L", 0.9);
    return [&panel, type](const Instant&, Sheet& sheet) {
        // On the right of the ellipsoid's largest reach, as the camera sees it.
        constexpr double aside = 1.22;
        Eigen::Vector3d right = camera_axes(sheet.view.camera).col(0);
        right.z() = 0.0;
        const Eigen::Vector3d top = aside * right.normalized();
        const Eigen::Vector3d bottom =
            top - picture_of(panel).plane_distance * Eigen::Vector3d::UnitZ();
        const Colour& colour = panel.stage->theme->text;
        Curve level = line_between(panel, Eigen::Vector3d::Zero(), 1.06 * top, colour, 1.6);
        level.dash_px = 7.0 * panel.px;
        level.hidden_opacity = 0.5;
        sheet.view.curves.push_back(level);
        const Eigen::Vector3d middle = 0.5 * (top + bottom);
        for (const Eigen::Vector3d& end : {top, bottom}) {
            Arrow arrow = arrow_between(panel, middle, end, colour, 0.7);
            arrow.occlusion = Occlusion::none;
            sheet.view.arrows.push_back(arrow);
        }
        wish_beside_line(panel, bottom, top, 0.5, type, colour, sheet);
        // Its left is towards the ellipsoid; the label stands on the other side.
        sheet.wishes.back().away *= -1.0;
    };
}

Drawer make_precession(Panel& panel) {
    if (!picture_of(panel).cones) {
        throw InputError(
            "show: precession needs a body with exactly two equal moments; leave it out");
    }
    const RollingCones cones = *picture_of(panel).cones;
    const int across = cones.symmetry_axis == 0 ? 2 : 1;
    const SetType in_body = set_label(panel, "\\Omega", 0.9);
    const SetType in_space = set_label(panel, fmt::format("L/I_{}", across), 0.85);
    return [&panel, cones, in_body, in_space](const Instant& instant, Sheet& sheet) {
        const ConstructionPicture& picture = picture_of(panel);
        const Theme& theme = *panel.stage->theme;
        // The side of the symmetry axis that ω leans to.
        const Eigen::Vector3d axis = picture.principal_axes(instant).col(cones.symmetry_axis);
        const double beyond = picture.half_axes[cones.symmetry_axis] + 0.62 * axis_overhang;
        Curve stem =
            line_between(panel, Eigen::Vector3d::Zero(), (beyond + 0.5 * axis_overhang) * axis,
                         theme.axes[cones.symmetry_axis], 3.0);
        sheet.view.curves.push_back(stem);
        add_turn(panel, {beyond * axis, axis, 0.2, std::copysign(5.0, cones.body_precession_rad_s)},
                 theme.body_cone, in_body, sheet);
        add_turn(
            panel,
            {0.86 * momentum_length * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), 0.2, 5.0},
            theme.space_cone, in_space, sheet);
    };
}

Drawer make_body(Panel& panel) {
    const BodyShape shape = body_shape(panel);
    // It stays within the ellipsoid in every direction.
    const double scale = 0.85 * picture_of(panel).half_axes.minCoeff();
    return [&panel, shape, scale](const Instant& instant, Sheet& sheet) {
        Eigen::Affine3d turned = Eigen::Affine3d::Identity();
        turned.linear() = scale * picture_of(panel).picture_from_body(instant).toRotationMatrix();
        for (const BodyPart& part : shape.parts) {
            Mesh mesh;
            mesh.geometry = part.geometry;
            mesh.placement = turned;
            mesh.colour = part.colour;
            mesh.casts_shadow = false;
            sheet.view.meshes.push_back(mesh);
        }
        for (Curve edge : shape.edges) {
            edge.placement = turned * edge.placement;
            sheet.view.curves.push_back(edge);
        }
    };
}

}  // namespace poinsot
