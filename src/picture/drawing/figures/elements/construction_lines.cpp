// Elements on the lines of the construction: L through its foot on the plane, ρ to the contact, ω
// and the axis of rotation along it, ∇F, and the distances between them. Rows of the table in
// elements.cpp; picture axes.
#include "drawing/figures/elements/construction_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/label_requests.h"
#include "numerics/smooth_step.h"
#include "shapes/projection.h"
#include "text/languages.h"

namespace poinsot {

namespace {

// Opacity of lines inside of the translucent ellipsoid and beyond the plane: they keep nearly all
// of their hue.
constexpr double seen_through = 0.9;

// A line between two points, and the share of its length at which its label is.
struct LabelledLine {
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to;
    double share = 0.5;
};

// Requests a label on the left of a line, in the line's direction in the picture.
void request_label_beside_line(const Panel& panel, const LabelledLine& line, const TextBlock& type,
                               const LineStyle& colour, ViewBuilder& builder) {
    const Eigen::Vector2d a = project(builder.view, line.from).px;
    const Eigen::Vector2d b = project(builder.view, line.to).px;
    LabelRequest request;
    request.type = type;
    request.anchor_px = a + line.share * (b - a);
    request.away = Eigen::Vector2d((b - a).y(), -(b - a).x()) / (100.0 * panel.px);
    request.gap_px = 7.0 * panel.px;
    request.colour = colour;
    builder.requests.push_back(request);
}

// The camera's right, projected onto the plane; of a camera that lies on its side, the direction in
// the plane across the line of sight.
Eigen::Vector3d right_of(const ViewBuilder& builder) {
    const Eigen::Matrix3d axes = camera_axes(builder.view.camera);
    Eigen::Vector3d right = axes.col(0);
    right.z() = 0.0;
    if (right.norm() < 0.5) right = Eigen::Vector3d::UnitZ().cross(Eigen::Vector3d(axes.col(2)));
    return right.normalized();
}

// A right angle between two directions, unit vectors.
struct RightAngle {
    Eigen::Vector3d at, a, b;
};

// Adds the corner of a square in the angle. Where it is seen edge-on and would be a mere line, it
// fades.
void add_right_angle(const Panel& panel, const RightAngle& angle, const LineStyle& colour,
                     double presence, ViewBuilder& builder) {
    constexpr double side = 0.085;
    const auto& [at, a, b] = angle;
    const Eigen::Vector3d sight = (builder.view.camera.eye - at).stableNormalized();
    const double opened = std::abs(sight.dot(a.cross(b)));
    const double opacity = presence * smooth_step((opened - 0.05) / 0.2);
    if (!(opacity > 0.0)) return;
    const Eigen::Vector3d corner = at + side * (a + b);
    for (const Eigen::Vector3d& leg : {a, b}) {
        Curve line = line_between(panel, at + side * leg, corner, colour, 1.8);
        line.hidden_opacity = 0.7;
        line.opacity *= opacity;
        builder.view.curves.push_back(line);
    }
}

bool shows_plane(const StageContext& stage) {
    return is_shown(stage, "plane") || is_shown(stage, "tangent");
}

}  // namespace

double plane_presence(const Eigen::Vector3d& foot, const Camera& camera) {
    constexpr double glass = 0.38;
    const Eigen::Vector3d from_foot = camera.eye - foot;
    const double sine = foot.stableNormalized().dot(from_foot) / from_foot.norm();
    return 1.0 + (glass - 1.0) * smooth_step(sine / 0.06);
}

double radius_in_view(const Panel& panel, const Eigen::Vector3d& centre, double least,
                      double wanted) {
    View view;
    view.x_px = panel.box.x_px, view.y_px = panel.box.y_px;
    view.width_px = panel.box.width_px, view.height_px = panel.box.height_px;
    view.camera = panel.camera;
    Eigen::Vector3d towards_us = panel.camera.eye - panel.camera.target;
    towards_us.z() = 0.0;
    if (!(towards_us.norm() > 0.0)) return wanted;
    towards_us.normalize();
    const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(towards_us);
    // On a screen, a plane may continue to the left, right and upper edges of the picture.
    const StageOptions& picture = panel.stage->options;
    const bool is_page = is_on_paper(*panel.stage);
    const double unlimited = std::numeric_limits<double>::infinity();
    const double right_px = panel.box.x_px + panel.box.width_px;
    const double bottom_px = panel.box.y_px + panel.box.height_px;
    const double from_px = panel.box.x_px > 0 || is_page ? panel.box.x_px : -unlimited;
    const double to_px = right_px < picture.width_px || is_page ? right_px : unlimited;
    const double top_px = panel.box.y_px > 0 || is_page ? panel.box.y_px : -unlimited;
    const auto is_seen = [&](double radius) {
        constexpr int n_around = 32;
        for (int k = 0; k < n_around; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / n_around;
            // The first point is the nearest, which limits most planes.
            const Eigen::Vector3d rim =
                centre + radius * (std::cos(angle) * towards_us + std::sin(angle) * across);
            const Projected seen = project(view, rim);
            if (!(seen.depth > 0.0 && seen.px.y() < bottom_px && seen.px.y() > top_px &&
                  seen.px.x() > from_px && seen.px.x() < to_px))
                return false;
        }
        return true;
    };
    double seen = 0.0;
    double cut = wanted;
    for (int round = 0; round < 40 && !is_seen(wanted); ++round) {
        const double middle = 0.5 * (seen + cut);
        (is_seen(middle) ? seen : cut) = middle;
    }
    return is_seen(wanted) ? wanted : std::max(seen, least);
}

// L from the centre through the plane, its foot there marked with a right angle.
Drawer make_momentum(const Panel& panel, StageStore& store) {
    const ConstructionPicture& picture = picture_of(panel);
    Arrow arrow = arrow_to(panel, momentum_tip(picture), panel.stage->theme.momentum, 1.15);
    arrow.hidden_opacity = seen_through;
    const TextBlock type = set_label(panel, store, "\\mathbf{L}");
    const bool has_foot = shows_plane(*panel.stage);
    const bool has_plane = is_shown(*panel.stage, "plane");
    const bool has_tangent = is_shown(*panel.stage, "tangent");
    const Dot foot = dot_at(panel, picture.foot(), panel.stage->theme.momentum, 4.0);
    return [&panel, arrow, type, has_foot, has_plane, has_tangent, foot](const FrameInput& instant,
                                                                         ViewBuilder& builder) {
        builder.view.arrows.push_back(arrow);
        // The foot belongs to the plane and fades with it.
        const Timeline& timeline = panel.stage->timeline;
        double presence = 0.0;
        if (has_foot && has_plane) presence = timeline.opacity_of("plane", instant.film_s);
        if (has_foot && has_tangent)
            presence = std::max(presence, timeline.opacity_of("tangent", instant.film_s));
        if (presence > 0.0) {
            Dot here = foot;
            here.at = picture_of(panel).foot(instant);
            here.opacity *= presence;
            // On the side where the plane is visible: away from the camera's right.
            add_right_angle(panel, {here.at, -right_of(builder), -picture_of(panel).normal},
                            arrow.colour, presence, builder);
            builder.view.dots.push_back(here);
        }
        request_label_at_tip(panel, arrow, type, builder);
    };
}

// ω from the centre to the contact, or on from the tip of ρ if ρ is shown as well.
Drawer make_omega(const Panel& panel, StageStore& store) {
    const TextBlock type = set_label(panel, store, "\\boldsymbol{\\omega}");
    // With ρ shown, ω extends beyond its tip; without ρ, ω ends there.
    const bool beyond = is_shown(*panel.stage, "radius");
    return [&panel, type, beyond](const FrameInput& instant, ViewBuilder& builder) {
        const Eigen::Vector3d rho = picture_of(panel).contact(instant);
        Arrow arrow =
            arrow_to(panel, beyond ? spin_axis_end(rho) : rho, panel.stage->theme.omega, 1.15);
        // ρ covers the beginning of ω: of two arrows on one line, either might be in front. While ρ
        // fades in, the tail of ω moves from the centre to the tip of ρ.
        if (beyond) arrow.tail = panel.stage->timeline.opacity_of("radius", instant.film_s) * rho;
        arrow.hidden_opacity = seen_through;
        builder.view.arrows.push_back(arrow);
        // The label is further along the line, away from the contact and the lines that meet there.
        request_label_beside(panel, beyond ? arrow.tip : past_contact(rho), Eigen::Vector3d::Zero(),
                             type, arrow.colour, builder);
        builder.requests.back().side = 1;
    };
}

// The points of the body that are at rest at the instant: the line through centre and contact.
Drawer make_spin_axis(const Panel& panel, StageStore&) {
    // On the side of the contact, ρ and ω lie on the axis and would have its colour in their
    // middle.
    const bool covered = is_shown(*panel.stage, "radius") && is_shown(*panel.stage, "omega");
    return [&panel, covered](const FrameInput& instant, ViewBuilder& builder) {
        const Eigen::Vector3d rho = picture_of(panel).contact(instant);
        const Eigen::Vector3d end = covered ? Eigen::Vector3d::Zero().eval() : past_contact(rho);
        Curve line = line_between(panel, -spin_axis_end(rho), end, panel.stage->theme.omega, 2.0);
        line.hidden_opacity = 0.6;
        builder.view.curves.push_back(line);
    };
}

// The point where ellipsoid and plane touch: the tip of ρ.
Drawer make_contact(const Panel& panel, StageStore&) {
    Dot dot = dot_at(panel, Eigen::Vector3d::Zero(), panel.stage->theme.contact);
    // Drawn over both curves and the ellipsoid, since it lies on them.
    dot.occlusion = Occlusion::none;
    return [&panel, dot](const FrameInput& instant, ViewBuilder& builder) {
        builder.view.dots.push_back(dot);
        builder.view.dots.back().at = picture_of(panel).contact(instant);
    };
}

// ρ = ω/√(2T), from the centre to the contact: F(ρ) = 1.
Drawer make_radius(const Panel& panel, StageStore& store) {
    const TextBlock type = set_label(panel, store, "\\boldsymbol{\\rho}");
    return [&panel, type](const FrameInput& instant, ViewBuilder& builder) {
        const Eigen::Vector3d rho = picture_of(panel).contact(instant);
        const LineStyle& colour = panel.stage->theme.rho;
        // The subject of the picture: in full strength through the body.
        Arrow arrow = arrow_to(panel, rho, colour, 1.3);
        arrow.hidden_opacity = 1.0;
        builder.view.arrows.push_back(arrow);
        request_label_beside_line(panel, {.to = rho}, type, colour, builder);
    };
}

// The plane that touches the ellipsoid at ρ: a patch of the invariable plane.
Drawer make_tangent(const Panel& panel, StageStore& store) {
    static constexpr Phrase words{"tangent plane",  "Tangentialebene", "plan tangent",
                                  "plano tangente", "piano tangente",  "接平面"};
    const TextBlock type =
        store.set(phrase_in(panel.stage->scene.language, words),
                  {.size_px = 0.85 * label_em_px(panel), .mode = TypeMode::text});
    Plane plane;
    plane.radius = 0.9;
    plane.fade_from = 0.9;
    plane.grid_spacing = 0.15;
    plane.grid_px = 0.8 * panel.px;
    plane.colour = panel.stage->theme.plane;
    plane.grid_colour = panel.stage->theme.grid;
    plane.opacity = 0.6;
    return [&panel, plane, type](const FrameInput& instant, ViewBuilder& builder) {
        builder.view.planes.push_back(plane);
        Plane& here = builder.view.planes.back();
        here.centre = picture_of(panel).contact(instant);
        // At the edge of the patch, on the left and towards us.
        const Eigen::Vector3d right = right_of(builder);
        const Eigen::Vector3d away = Eigen::Vector3d::UnitZ().cross(right);
        const Eigen::Vector3d edge = here.centre - 0.85 * plane.radius * (0.6 * right + 0.8 * away);
        request_label_beside(panel, edge, edge + right, type, panel.stage->theme.text, builder);
    };
}

// ∇F at ρ: it points along L, as ∇F = 2 I ρ.
Drawer make_gradient(const Panel& panel, StageStore& store) {
    const TextBlock type = set_label(panel, store, "\\nabla F");
    const bool has_tangent = is_shown(*panel.stage, "tangent");
    return [&panel, type, has_tangent](const FrameInput& instant, ViewBuilder& builder) {
        constexpr double length = 0.55;
        const Eigen::Vector3d rho = picture_of(panel).contact(instant);
        const Eigen::Vector3d& normal = picture_of(panel).normal;
        Arrow arrow =
            arrow_between(panel, rho, rho + length * normal, panel.stage->theme.gradient, 1.1);
        arrow.hidden_opacity = seen_through;
        add_named_arrow(panel, arrow, type, builder);
        // The right angle with the tangent plane, which it fades with.
        if (!has_tangent) return;
        add_right_angle(panel, {rho, right_of(builder), normal}, arrow.colour,
                        panel.stage->timeline.opacity_of("tangent", instant.film_s), builder);
    };
}

// The projection of ρ on L: from the tip of ρ perpendicularly to L, and along L to the centre.
Drawer make_projection(const Panel& panel, StageStore& store) {
    const TextBlock type = set_label(panel, store, "\\boldsymbol{\\rho}\\cdot\\mathbf{L}/L", 0.85);
    const bool has_plane = is_shown(*panel.stage, "plane");
    return [&panel, type, has_plane](const FrameInput& instant, ViewBuilder& builder) {
        const ConstructionPicture& picture = picture_of(panel);
        const LineStyle& colour = panel.stage->theme.rho;
        const Eigen::Vector3d rho = picture.contact(instant);
        const Eigen::Vector3d foot = picture.foot(instant);
        Curve along = line_between(panel, Eigen::Vector3d::Zero(), foot, colour, 9.0);
        along.opacity = 0.55;
        along.hidden_opacity = 0.55;
        Curve across = line_between(panel, rho, foot, colour, 2.4);
        across.hidden_opacity = seen_through;
        for (const Curve& line : {along, across}) builder.view.curves.push_back(line);
        // The right angle on L, unless the plane has its own there.
        const double plane =
            has_plane ? panel.stage->timeline.opacity_of("plane", instant.film_s) : 0.0;
        add_right_angle(panel, {foot, (rho - foot).stableNormalized(), -picture.normal}, colour,
                        1.0 - plane, builder);
        // On the side of L away from ρ.
        request_label_beside_line(panel, {.to = foot, .share = 0.55}, type, panel.stage->theme.text,
                                  builder);
        const Eigen::Vector2d to_rho =
            project(builder.view, rho).px - project(builder.view, foot).px;
        Eigen::Vector2d& away = builder.requests.back().away;
        if (away.dot(to_rho) > 0.0) away = -away;
    };
}

// The plane's distance √(2T)/L from the centre, as a dimension line beside the ellipsoid.
Drawer make_distance(const Panel& panel, StageStore& store) {
    const TextBlock type = set_label(panel, store, "\\sqrt{2T}/L", 0.9);
    return [&panel, type](const FrameInput& instant, ViewBuilder& builder) {
        // To the right of the ellipsoid's largest extent, in the camera's view.
        constexpr double aside = 1.22;
        const Eigen::Vector3d from = aside * right_of(builder);
        const Eigen::Vector3d to = from + picture_of(panel).foot(instant);
        const LineStyle& colour = panel.stage->theme.text;
        // From the centre, and in the plane from the foot of L.
        for (const Eigen::Vector3d& height :
             {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(to - from)}) {
            Curve level = line_between(panel, height, height + 1.06 * from, colour, 1.6);
            level.hidden_opacity = 0.5;
            builder.view.curves.push_back(level);
        }
        const Eigen::Vector3d middle = 0.5 * (from + to);
        for (const Eigen::Vector3d& end : {from, to}) {
            Arrow arrow = arrow_between(panel, middle, end, colour, 0.6);
            arrow.hidden_opacity = seen_through;
            builder.view.arrows.push_back(arrow);
        }
        request_label_beside_line(panel, {.from = from, .to = to}, type, colour, builder);
        // Away from the ellipsoid, for both directions of the line.
        Eigen::Vector2d& away = builder.requests.back().away;
        away.x() = std::abs(away.x());
    };
}

namespace {

// The point at the height of `at` in the picture that stands below or above the point `aside` of
// the centre. `aside` is horizontal in the picture.
Eigen::Vector3d below_or_above(const View& view, const Eigen::Vector3d& at,
                               const Eigen::Vector3d& aside) {
    const Projected here = project(view, at);
    const double off_px = project(view, aside).px.x() - here.px.x();
    return at + off_px * units_per_pixel(view, here.depth) * aside.normalized();
}

}  // namespace

LevelScale::LevelScale(const Panel& panel, StageStore& store)
    : panel_(&panel), types_(set_half_axis_labels(panel, store, 0.9)) {
    distance_ = set_label(panel, store, "\\sqrt{2T}/L", 0.9);
}

double LevelScale::aside(const View& view, const Eigen::Vector3d& right) const {
    constexpr double usual = 1.3, least = 1.08;
    double names_px = 0.0;
    for (const TextBlock& type : types_) names_px = std::max(names_px, type.width_px());
    const Projected end = project(view, (usual + 1.6 * tick) * right);
    const double over_px =
        end.px.x() + 2.0 * gap * panel_->px + names_px - (view.x_px + view.width_px);
    return std::clamp(usual - over_px * units_per_pixel(view, end.depth), least, usual);
}

void LevelScale::add_to(ViewBuilder& builder, const Eigen::Vector3d& half_axes,
                        const Eigen::Vector3d& foot) const {
    const Panel& panel = *panel_;
    const Theme& theme = panel.stage->theme;
    const Eigen::Vector3d right = right_of(builder);
    const Eigen::Vector3d normal = foot.stableNormalized();
    // Upright in the picture, also in perspective.
    const Eigen::Vector3d zero = aside(builder.view, right) * right;
    const auto at = [&](double distance) {
        return below_or_above(builder.view, distance * normal, zero);
    };
    const auto add = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const LineStyle& colour, double width_px) {
        Curve line = line_between(panel, a, b, colour, width_px);
        line.hidden_opacity = seen_through;
        builder.view.curves.push_back(line);
    };
    const auto name = [&](const Eigen::Vector3d& place, double side, const TextBlock& type,
                          const LineStyle& colour) -> LabelRequest& {
        LabelRequest request;
        request.type = type;
        request.anchor_px = project(builder.view, place).px;
        request.away = {side, 0.0};
        request.gap_px = gap * panel.px;
        request.colour = colour;
        return builder.requests.emplace_back(request);
    };
    // The scale begins at the centre's height.
    add(zero - tick * right, zero + tick * right, theme.text, 1.8);
    add(zero, at(half_axes.maxCoeff() + 0.08), theme.text, 1.8);
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d end = at(half_axes[i]) + 1.6 * tick * right;
        add(at(half_axes[i]), end, theme.axes[i], 4.0);
        name(end, 1.0, types_[static_cast<std::size_t>(i)], theme.axes[i]);
    }
    // The plane's own distance. The line at it does not reach the body.
    constexpr double reach = 0.28;
    const Eigen::Vector3d here = at(foot.norm());
    add(here - reach * right, here, theme.contact, 2.4);
    builder.view.dots.push_back(dot_at(panel, here, theme.contact, 5.5));
    // The label is above the line to the foot and beside the scale; it is below that line if
    // another distance's tick is nearer above it, and further left if ticks are near on both sides,
    // where it would seem to name a tick.
    constexpr double beyond = 0.13, preferred = 0.02, level = 0.06;
    const auto free_at = [&](double distance) {
        return (half_axes.array() - distance).abs().minCoeff();
    };
    const double over = free_at(foot.norm() - beyond), below = free_at(foot.norm() + beyond);
    const double along = over + preferred >= below ? -beyond : beyond;
    const double off = std::max(over, below) < level ? 0.6 : 0.22;
    LabelRequest& request =
        name(here - off * right + along * normal, 0.0, distance_, theme.contact);
    request.away = {-0.2, 0.0};  // the label's middle is at the anchor
    const double half_px = 0.5 * distance_.width_px();
    const double scale_px = project(builder.view, here).px.x();
    request.anchor_px.x() = std::min(request.anchor_px.x() + 0.62 * (request.gap_px + half_px),
                                     scale_px - 2.0 * request.gap_px - half_px);
}

// The scale of distances for the motion's own plane.
Drawer make_levels(const Panel& panel, StageStore& store) {
    const LevelScale levels(panel, store);
    return [&panel, levels](const FrameInput& instant, ViewBuilder& builder) {
        levels.add_to(builder, picture_of(panel).half_axes, picture_of(panel).foot(instant));
    };
}

// ω × r of points of the ellipsoid along an arc on the camera's side, from the contact, where it is
// zero, to the other end of the axis of rotation. The arc is rotated about the axis out of the
// plane of the line of sight, in which it would cover the axis.
Drawer make_velocity(const Panel& panel, StageStore& store) {
    const TextBlock type =
        set_label(panel, store, "\\mathbf{v} = \\boldsymbol{\\omega}\\times\\mathbf{r}", 0.85);
    const TextBlock rest_type = set_label(panel, store, "\\mathbf{v} = 0", 0.85);
    return [&panel, type, rest_type](const FrameInput& instant, ViewBuilder& builder) {
        const ConstructionPicture& picture = picture_of(panel);
        const Eigen::Vector3d rho = picture.contact(instant);
        const Eigen::Vector3d axis = rho.stableNormalized();
        const Eigen::Vector3d towards_eye = builder.view.camera.eye;
        const double aside_rad = 35.0 * std::numbers::pi / 180.0;
        const Eigen::Vector3d facing =
            Eigen::AngleAxisd(aside_rad, axis) *
            (towards_eye - towards_eye.dot(axis) * axis).stableNormalized();
        const Eigen::Vector3d sideways = axis.cross(facing);

        // Intersections of rays from the centre with the ellipsoid.
        const Eigen::Matrix3d axes = picture.principal_axes(instant);
        const auto surface = [&](double angle) {
            const Eigen::Vector3d along = std::cos(angle) * axis + std::sin(angle) * facing;
            const Eigen::Vector3d scaled =
                (axes.transpose() * along).cwiseQuotient(picture.half_axes);
            return Eigen::Vector3d(along / scaled.norm());
        };
        // The subject of a picture of rolling, in a colour that the figure has nowhere else.
        const LineStyle& colour = panel.stage->theme.mark;
        constexpr int n = 9;
        constexpr double per_distance = 0.42;
        constexpr int named = n / 2;
        for (int k = 1; k < n; ++k) {
            const Eigen::Vector3d point = surface(std::numbers::pi * k / n);
            const double distance = (point - point.dot(axis) * axis).norm();
            Arrow arrow = arrow_between(panel, point, point + per_distance * distance * sideways,
                                        colour, 1.1);
            arrow.hidden_opacity = 0.8;
            builder.view.arrows.push_back(arrow);
            builder.view.dots.push_back(dot_at(panel, point, colour, 4.0));
            if (k == named) request_label_at_tip(panel, arrow, type, builder);
        }
        // Beyond the contact, as seen from the foot of L, and clear of the curves: at the end of a
        // leader.
        request_label_beside(panel, rho, picture.foot(instant) - 0.5 * picture.normal, rest_type,
                             colour, builder);
        LabelRequest& rest = builder.requests.back();
        rest.away = Eigen::Vector2d(rest.away.x() < 0.0 ? -0.85 : 0.85, 0.53);
        rest.gap_px = 44.0 * panel.px;
    };
}

}  // namespace poinsot
