#include "drawing/figures/elements/inertial_forces.h"

#include <algorithm>

#include "drawing/figures/elements/element_rows.h"
#include "drawing/figures/elements/object_shapes.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/label_requests.h"
#include "error/error.h"
#include "mechanics/inertial_force.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// Length of the longest centrifugal force of the film, in units of the body's reach.
constexpr double longest_force = 1.0;

}  // namespace

InertialForces::InertialForces(const StageContext& stage, double reach_m)
    : stage_(&stage), reach_m_(reach_m) {
    const MotionProblem& problem = stage.motion.motion().problem();
    if (stage.scene.body.given != BodySpec::Given::masses)
        throw InputError(
            "show: inertial-forces needs a body of point masses; give it as [[body.masses]], or "
            "leave this element out");
    if (has_friction(problem.torque))
        throw InputError(
            "show: inertial-forces cannot show a body with internal friction; leave the element or "
            "the friction out");
    // Instants that are close enough for the short flips of a long film.
    constexpr int n = 1024;
    double most_N = 0.0;
    for (int k = 0; k <= n; ++k) {
        const double t = stage.film_first_s + (stage.film_last_s - stage.film_first_s) * k / n;
        const Eigen::Vector3d omega = stage.motion.sample(t, omega_alone).state.omega_body;
        for (const PointMass& mass : stage.scene.body.masses)
            most_N = std::max(
                most_N,
                norm_of(inertial_force(mass, omega, Eigen::Vector3d::Zero()).centrifugal_N));
    }
    if (most_N > 0.0) per_N_ = longest_force / most_N;
}

std::vector<InertialForces::Arrows> InertialForces::at(const RotationState& state) const {
    const Eigen::Vector3d rate = angular_acceleration(stage_->motion.motion().problem(), state);
    std::vector<Arrows> arrows;
    for (const PointMass& mass : stage_->scene.body.masses) {
        const InertialForce force = inertial_force(mass, state.omega_body, rate);
        Arrows arrow;
        arrow.mass = mass.at_m / reach_m_;
        arrow.centrifugal_tip = arrow.mass + per_N_ * force.centrifugal_N;
        arrow.euler_tip = arrow.centrifugal_tip + per_N_ * force.euler_N;
        arrows.push_back(arrow);
    }
    return arrows;
}

// The inertial forces in the axes of the body, which turns: at each mass the centrifugal force, and
// from its tip the Euler force.
Drawer make_inertial_forces(const Panel& panel, StageStore& store) {
    const InertialForces forces(*panel.stage, body_shape(panel, store).reach_m);
    const TextBlock centrifugal =
        set_label(panel, store,
                  "-m\\boldsymbol{\\omega}\\times(\\boldsymbol{\\omega}\\times\\mathbf{r})", 0.8);
    const TextBlock euler =
        set_label(panel, store, "-m\\dot{\\boldsymbol{\\omega}}\\times\\mathbf{r}", 0.8);
    return [&panel, forces, centrifugal, euler](const FrameInput& instant, ViewBuilder& builder) {
        const Theme& theme = panel.stage->theme;
        const Eigen::Matrix3d attitude =
            (object_from_space(*panel.stage) * instant.state.space_from_body).toRotationMatrix();
        // Shorter arrows are no longer than their heads are wide.
        const double least = 12.0 * panel.px * panel.units_per_px;
        const auto add = [&](const Eigen::Vector3d& tail, const Eigen::Vector3d& tip,
                             const LineStyle& ink, double weight, bool is_named,
                             const TextBlock& name) {
            if (!((tip - tail).norm() > least)) return;
            Arrow arrow = arrow_between(panel, attitude * tail, attitude * tip, ink, weight);
            arrow.hidden_opacity = 0.35;
            builder.view.arrows.push_back(arrow);
            if (is_named) request_label_at_tip(panel, arrow, name, builder);
        };
        // The names are at the arrows of the first mass, so that they do not jump.
        bool is_first = true;
        for (const InertialForces::Arrows& of_mass : forces.at(instant.state)) {
            add(of_mass.mass, of_mass.centrifugal_tip, theme.torque, 1.6, is_first, centrifugal);
            add(of_mass.centrifugal_tip, of_mass.euler_tip, theme.potential, 1.2, is_first, euler);
            is_first = false;
        }
    };
}

}  // namespace poinsot
