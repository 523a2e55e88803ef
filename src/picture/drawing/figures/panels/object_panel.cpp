// The object panel: the body rotating in space, with its principal axes, ω, L and the torque.
//
// Without torque L is up or, if a panel shows the construction, in the same direction as there;
// with torque the space axis z is up.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawing/figures/elements/elements.h"
#include "drawing/figures/elements/ghost.h"
#include "drawing/figures/elements/inertial_forces.h"
#include "drawing/figures/elements/object_shapes.h"
#include "drawing/figures/elements/user_marks.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/framing.h"
#include "drawing/stage/label_requests.h"
#include "mechanics/torque.h"
#include "numerics/power_of_two.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

// Longest arrows along L and ω over the film, in units of the body's reach: different, so that
// their tips are apart if both arrows lie on one line.
constexpr double longest_arrow = 1.45;
constexpr double longest_omega = 1.22;
// Length of the principal axes beyond the body.
constexpr double axis_beyond = 0.22;

// ω and L at an instant, picture axes; lengths relative to the largest of the film.
class ArrowScale {
 public:
    explicit ArrowScale(const StageContext& stage)
        : stage_(&stage), inertia_(stage.motion.motion().problem().inertia.matrix_body()) {
        inertia_ /= inertia_.cwiseAbs().maxCoeff();
        // With L conserved, ω varies so little that the state at the start determines the scale.
        constexpr int n = 64;
        for (int k = 0; k <= n; ++k) {
            const double t = stage.film_first_s + (stage.film_last_s - stage.film_first_s) * k / n;
            const Eigen::Vector3d omega = stage.motion.sample(t, omega_alone).state.omega_body;
            omega_most_ = std::max(omega_most_, norm_of(omega));
            const Eigen::Vector3d momentum = inertia_ * omega;
            momentum_most_ = std::max(momentum_most_, norm_of(momentum));
        }
    }

    bool turns() const { return omega_most_ > 0.0; }
    Eigen::Vector3d omega_tip(const FrameInput& instant) const {
        return tip(instant, instant.state.omega_body, omega_most_) *
               (longest_omega / longest_arrow);
    }
    Eigen::Vector3d momentum_tip(const FrameInput& instant) const {
        return tip(instant, inertia_ * instant.state.omega_body, momentum_most_);
    }

 private:
    Eigen::Vector3d tip(const FrameInput& instant, const Eigen::Vector3d& vector_body,
                        double most) const {
        return object_from_space(*stage_) * (instant.state.space_from_body * vector_body) *
               (longest_arrow / most);
    }

    const StageContext* stage_;
    Eigen::Matrix3d inertia_;
    double omega_most_ = 0.0;
    double momentum_most_ = 0.0;
};

// The torque N, picture axes, relative to the largest of the film.
class TorqueScale {
 public:
    explicit TorqueScale(const StageContext& stage)
        : stage_(&stage),
          body_from_principal_(stage.motion.motion().problem().inertia.body_from_principal()),
          dynamics_(stage.motion.motion().problem().inertia,
                    stage.motion.motion().problem().torque),
          most_N_m_(dynamics_.has_torque() ? dynamics_.greatest_torque_N_m() : 0.0) {
        if (!is_slowed(dynamics_.torque())) return;
        constexpr int n = 64;
        for (int k = 0; k <= n; ++k) {
            const double t = stage.film_first_s + (stage.film_last_s - stage.film_first_s) * k / n;
            most_N_m_ =
                std::max(most_N_m_, torque_body(stage.motion.sample(t, attitude_too).state).norm());
        }
    }

    bool acts() const { return most_N_m_ > 0.0; }
    Eigen::Vector3d along(const RotationState& state) const {
        constexpr double length = 1.0;
        return object_from_space(*stage_) * (state.space_from_body * torque_body(state)) *
               (length / most_N_m_);
    }

 private:
    Eigen::Vector3d torque_body(const RotationState& state) const {
        StepState step;
        step.momentum = dynamics_.moments_kg_m2().cwiseProduct(body_from_principal_.transpose() *
                                                               state.omega_body);
        step.time_s = state.time_s;
        step.space_from_principal =
            state.space_from_body * Eigen::Quaterniond(body_from_principal_);
        return body_from_principal_ * dynamics_.torque_on(step);
    }

    const StageContext* stage_;
    Eigen::Matrix3d body_from_principal_;
    RotationDynamics dynamics_;
    double most_N_m_;
};

// The torque's arrow, if there is a torque: slightly to the left of the fixed point, because it may
// be parallel to ω or L.
Drawer make_torque(const Panel& panel, StageStore& store, const TorqueScale& torque) {
    if (!torque.acts()) return [](const FrameInput&, ViewBuilder&) {};
    const TextBlock type = set_label(panel, store, "\\mathbf{N}");
    return [&panel, torque, type](const FrameInput& instant, ViewBuilder& builder) {
        constexpr double aside = 0.16;
        const Eigen::Vector3d tail = -aside * camera_axes(builder.view.camera).col(0);
        Arrow arrow = arrow_between(panel, tail, tail + torque.along(instant.state),
                                    panel.stage->theme.torque, 1.15);
        arrow.hidden_opacity = 0.85;
        add_named_arrow(panel, arrow, type, builder, -omega_label_turn_rad);
    };
}

// The body of the comparison motion in thin lines: the edges of a box, the principal axes up to the
// body's surface, and ω. Empty without one.
Drawer make_ghost_body(Panel& panel, StageStore& store, const BodyShape& shape,
                       const ArrowScale& arrows) {
    if (!panel.stage->comparison) return [](const FrameInput&, ViewBuilder&) {};
    panel.shows_comparison = true;
    const LineStyle& grey = panel.stage->theme.ghost;
    std::vector<Curve> lines = shape.edges;
    for (Curve& line : lines) line.colour = grey;
    const Eigen::Matrix3d& axes = panel.stage->scene.body.inertia.body_from_principal();
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d end = axes.col(i) * (shape.extents[i] + axis_beyond);
        lines.push_back(line_between(panel, Eigen::Vector3d::Zero(), end, grey, 1.6));
    }
    for (Curve& line : lines) line.hidden_opacity = 0.45;
    const TextBlock type = set_ghost_label(panel, store, "\\boldsymbol{\\omega}");
    return [&panel, lines, arrows, type](const FrameInput& instant, ViewBuilder& builder) {
        FrameInput comparison = instant;
        comparison.state = *instant.comparison;
        Eigen::Affine3d turned = Eigen::Affine3d::Identity();
        turned.linear() =
            (object_from_space(*panel.stage) * comparison.state.space_from_body).toRotationMatrix();
        for (Curve line : lines) {
            line.placement = turned * line.placement;
            builder.view.curves.push_back(line);
        }
        if (arrows.turns()) add_ghost_arrow(panel, arrows.omega_tip(comparison), type, builder);
    };
}

// Marks on a body of this reach.
Drawer make_marks(Panel& panel, StageStore& store, double reach_m) {
    const StageContext& stage = *panel.stage;
    return make_user_marks(
        panel, store,
        [&stage, reach_m](const MarkSpec& mark,
                          const RotationState& state) -> std::optional<Eigen::Vector3d> {
            if (mark.on != "body") return std::nullopt;
            return object_from_space(stage) *
                   (state.space_from_body * (on_body_m(stage.scene, mark) / reach_m));
        });
}

// The extreme points of the body, its axes and the arrows over the film, sampled at their own
// instants; with a comparison motion, for all attitudes.
std::vector<Eigen::Vector3d> points_to_frame(const StageContext& stage, const BodyShape& shape,
                                             const ArrowScale& arrows, const TorqueScale& torque) {
    if (stage.comparison) {
        std::vector<Eigen::Vector3d> points = points_of_ellipsoid(Eigen::Matrix3d::Identity());
        const bool down =
            stage.rolling &&
            (object_from_space(stage) * stage.rolling->construction.normal_space()).z() < 0.0;
        if (arrows.turns()) points.emplace_back(0.0, 0.0, down ? -longest_arrow : longest_arrow);
        return points;
    }
    std::optional<InertialForces> forces;
    if (is_shown(stage, "inertial-forces")) forces.emplace(stage, shape.reach_m);
    std::vector<Eigen::Vector3d> body;
    for (const BodyPart& part : shape.parts)
        for (const Eigen::Vector3f& corner : part.geometry->positions)
            body.emplace_back(corner.cast<double>());
    body = outermost(body);
    const Eigen::Matrix3d& axes = stage.scene.body.inertia.body_from_principal();
    for (int i = 0; i < 3; ++i) body.emplace_back(axes.col(i) * (shape.extents[i] + axis_beyond));

    std::vector<Eigen::Vector3d> points;
    constexpr int n_looks = 128;
    // Instants of a golden-ratio sequence, which is in phase with no rotation of the body.
    constexpr double golden = 0.6180339887498949;
    for (int k = 0; k <= n_looks; ++k) {
        FrameInput instant;
        const double part = k * golden - std::floor(k * golden);
        instant.time_s = stage.film_first_s + (stage.film_last_s - stage.film_first_s) * part;
        instant.state = stage.motion
                            .sample(instant.time_s,
                                    {.attitude = true, .herpolhode = false, .euler_angles = false})
                            .state;
        const Eigen::Quaterniond turn = object_from_space(stage) * instant.state.space_from_body;
        for (const Eigen::Vector3d& point : body) points.emplace_back(turn * point);
        if (forces)
            for (const InertialForces::Arrows& arrow : forces->at(instant.state))
                for (const Eigen::Vector3d& tip : {arrow.centrifugal_tip, arrow.euler_tip})
                    points.emplace_back(turn * tip);
        if (torque.acts()) points.push_back(torque.along(instant.state));
        if (!arrows.turns()) continue;
        points.push_back(arrows.momentum_tip(instant));
        points.push_back(arrows.omega_tip(instant));
    }
    return outermost(points);
}

}  // namespace

void make_object_panel(Panel& panel, StageStore& store) {
    panel.needs = {.attitude = true, .herpolhode = false, .euler_angles = false};
    const StageContext& stage = *panel.stage;
    const BodyShape shape = body_shape(panel, store);
    const ArrowScale arrows(stage);
    const Drawer elements = make_shown_elements(panel, store, uses_forces);

    const TorqueScale torque_scale(stage);
    const auto margin = [&panel](double names_em) {
        return names_em * label_em_px(panel) + 24.0 * panel.px;
    };
    std::vector<Eigen::Vector3d> points = points_to_frame(stage, shape, arrows, torque_scale);
    if (is_shown(stage, "inertial-forces"))
        // The names of forces are long.
        aim_around(panel, std::move(points),
                   Margins{margin(4.6), margin(1.0), margin(0.7) + panel.header_px, margin(0.7)});
    else
        aim_around(panel, std::move(points), margin(0.7));

    const std::array<TextBlock, 3> axis_types = set_axis_labels(panel, store);
    const TextBlock omega_type = set_label(panel, store, "\\boldsymbol{\\omega}");
    const TextBlock momentum_type = set_label(panel, store, "\\mathbf{L}");
    const Drawer ghost = make_ghost_body(panel, store, shape, arrows);
    const Drawer torque = make_torque(panel, store, torque_scale);
    const Drawer marks = make_marks(panel, store, shape.reach_m);
    panel.draw = [&panel, shape, arrows, axis_types, omega_type, momentum_type, ghost, torque,
                  elements, marks](const FrameInput& instant, ViewBuilder& builder) {
        const Theme& theme = panel.stage->theme;
        const Eigen::Matrix3d attitude =
            (object_from_space(*panel.stage) * instant.state.space_from_body).toRotationMatrix();
        Eigen::Affine3d turned = Eigen::Affine3d::Identity();
        turned.linear() = attitude;
        add_body(shape, turned, true, builder);
        name_shapes("body", builder);
        ghost(instant, builder);
        name_shapes("ghost", builder);
        torque(instant, builder);
        name_shapes("torque", builder);
        elements(instant, builder);
        marks(instant, builder);
        name_shapes("marks", builder);
        const Eigen::Matrix3d axes =
            attitude * panel.stage->scene.body.inertia.body_from_principal();
        const Eigen::Vector3d lengths = shape.extents.array() + axis_beyond;
        add_principal_axes(panel, axes * lengths.asDiagonal(), 0.8, axis_types, builder,
                           axis_label_turn_rad);
        name_shapes("axes", builder);
        if (!arrows.turns()) return;
        add_named_arrow(panel, arrow_to(panel, arrows.momentum_tip(instant), theme.momentum, 1.15),
                        momentum_type, builder);
        name_shapes("momentum", builder);
        add_named_arrow(panel, arrow_to(panel, arrows.omega_tip(instant), theme.omega, 1.15),
                        omega_type, builder, omega_label_turn_rad);
        name_shapes("omega", builder);
    };
}

}  // namespace poinsot
