// The object panel: the body itself turning in space, with its principal axes, ω and L.
//
// Without torque L stands upright, as in the space panel; otherwise up is the space axis z.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drawing/elements/ghost.h"
#include "drawing/elements/object_shapes.h"
#include "drawing/framing.h"
#include "drawing/marks.h"

namespace poinsot {

namespace {

// Longest arrows along ω and L over the film, beside the body's reach of 1.
constexpr double longest_arrow = 1.45;

// From space axes to the picture's.
Eigen::Quaterniond picture_from_space(const StageData& stage) {
    return stage.rolling ? stage.rolling->picture_from_space : Eigen::Quaterniond::Identity();
}

// ω and L at an instant, picture axes; lengths beside the largest of the film.
class ArrowScale {
 public:
    explicit ArrowScale(const StageData& stage)
        : stage_(&stage), inertia_(stage.motion.motion().problem().inertia.matrix_body()) {
        inertia_ /= inertia_.cwiseAbs().maxCoeff();
        // Where L is kept, ω changes little enough for the state at the start to give the scale.
        constexpr int n = 64;
        for (int k = 0; k <= n; ++k) {
            const double t = stage.film_first_s + (stage.film_last_s - stage.film_first_s) * k / n;
            const Eigen::Vector3d omega = stage.motion.sample(t, omega_alone).state.omega_body;
            omega_most_ = std::max(omega_most_, omega.stableNorm());
            const Eigen::Vector3d momentum = inertia_ * omega;
            momentum_most_ = std::max(momentum_most_, momentum.stableNorm());
        }
    }

    bool turns() const { return omega_most_ > 0.0; }
    Eigen::Vector3d omega_tip(const Instant& instant) const {
        return tip(instant, instant.state.omega_body, omega_most_);
    }
    Eigen::Vector3d momentum_tip(const Instant& instant) const {
        return tip(instant, inertia_ * instant.state.omega_body, momentum_most_);
    }

 private:
    Eigen::Vector3d tip(const Instant& instant, const Eigen::Vector3d& vector_body,
                        double most) const {
        return picture_from_space(*stage_) * (instant.state.space_from_body * vector_body) *
               (longest_arrow / most);
    }

    const StageData* stage_;
    Eigen::Matrix3d inertia_;
    double omega_most_ = 0.0;
    double momentum_most_ = 0.0;
};

// The body as the motion beside turns it, in thin lines: the edges of a box, the principal axes as
// far as the body reaches, and ω. Nothing without one.
Drawer make_ghost_body(Panel& panel, const BodyShape& shape, const ArrowScale& arrows) {
    if (!panel.stage->beside) return [](const Instant&, Sheet&) {};
    panel.shows_beside = true;
    const Colour& grey = panel.stage->theme->ghost;
    std::vector<Curve> lines = shape.edges;
    for (Curve& line : lines) line.colour = grey;
    const Eigen::Matrix3d& axes = panel.stage->scene.body.inertia.body_from_principal();
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d end = axes.col(i) * (shape.extents[i] + 0.22);
        lines.push_back(line_between(panel, Eigen::Vector3d::Zero(), end, grey, 1.6));
    }
    for (Curve& line : lines) line.hidden_opacity = 0.45;
    const SetType type = set_ghost_label(panel, "\\boldsymbol{\\omega}");
    return [&panel, lines, arrows, type](const Instant& instant, Sheet& sheet) {
        Instant beside = instant;
        beside.state = *instant.beside;
        Eigen::Affine3d turned = Eigen::Affine3d::Identity();
        turned.linear() =
            (picture_from_space(*panel.stage) * beside.state.space_from_body).toRotationMatrix();
        for (Curve line : lines) {
            line.placement = turned * line.placement;
            sheet.view.curves.push_back(line);
        }
        if (arrows.turns()) add_ghost_arrow(panel, arrows.omega_tip(beside), type, sheet);
    };
}

}  // namespace

void make_object_panel(Panel& panel) {
    panel.asks = {.attitude = true, .herpolhode = false, .euler_angles = false};
    const StageData& stage = *panel.stage;
    const BodyShape shape = body_shape(panel);
    const ArrowScale arrows(stage);

    // The body in every attitude, and arrows upwards.
    std::vector<Eigen::Vector3d> points = points_of_ellipsoid(Eigen::Matrix3d::Identity());
    if (arrows.turns()) points.emplace_back(0.0, 0.0, longest_arrow);
    aim_around(panel, std::move(points), 0.7 * label_size * panel.type_px + 24.0 * panel.px);

    std::array<SetType, 3> axis_types;
    for (std::size_t i = 0; i < 3; ++i) {
        axis_types[i] = set_label(panel, "\\mathbf{e}_" + std::to_string(i + 1), 0.85);
    }
    const SetType omega_type = set_label(panel, "\\boldsymbol{\\omega}");
    const SetType momentum_type = set_label(panel, "\\mathbf{L}");
    const Drawer ghost = make_ghost_body(panel, shape, arrows);
    panel.draw = [&panel, shape, arrows, axis_types, omega_type, momentum_type, ghost](
                     const Instant& instant, Sheet& sheet) {
        const Theme& theme = *panel.stage->theme;
        const Eigen::Matrix3d attitude =
            (picture_from_space(*panel.stage) * instant.state.space_from_body).toRotationMatrix();
        for (const BodyPart& part : shape.parts) {
            Mesh mesh;
            mesh.geometry = part.geometry;
            mesh.placement.linear() = attitude;
            mesh.colour = part.colour;
            sheet.view.meshes.push_back(mesh);
        }
        Eigen::Affine3d turned = Eigen::Affine3d::Identity();
        turned.linear() = attitude;
        for (Curve edge : shape.edges) {
            edge.placement = turned * edge.placement;
            sheet.view.curves.push_back(edge);
        }
        ghost(instant, sheet);
        const auto add_arrow = [&](const Eigen::Vector3d& tip, const Colour& colour, double weight,
                                   const SetType& type, double turn_rad = 0.0) {
            sheet.view.arrows.push_back(arrow_to(panel, tip, colour, weight));
            wish_at_tip(panel, sheet.view.arrows.back(), type, sheet, turn_rad);
        };
        const Eigen::Matrix3d axes =
            attitude * panel.stage->scene.body.inertia.body_from_principal();
        for (int i = 0; i < 3; ++i) {
            add_arrow(axes.col(i) * (shape.extents[i] + 0.22), theme.axes[i], 0.8,
                      axis_types[static_cast<std::size_t>(i)], axis_label_turn_rad);
        }
        if (!arrows.turns()) return;
        add_arrow(arrows.momentum_tip(instant), theme.momentum, 1.15, momentum_type);
        add_arrow(arrows.omega_tip(instant), theme.omega, 1.15, omega_type, omega_label_turn_rad);
    };
}

}  // namespace poinsot
