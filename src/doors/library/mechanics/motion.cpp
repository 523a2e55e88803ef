#include "library/poinsot/motion.h"

#include <cmath>
#include <string>
#include <utility>

#include "error/error.h"
#include "library/mechanics/motion_access.h"
#include "mechanics/regime_sentence.h"

namespace poinsot::library {

namespace {

Physicality physicality_of(const MotionOptions& options) {
    return options.allow_unphysical ? Physicality::waived : Physicality::required;
}

MotionProblem problem_of(const InertiaTensor& inertia, const MotionOptions& options) {
    if (!std::isfinite(options.first_time_s) || !std::isfinite(options.last_time_s))
        throw InputError("first_time_s and last_time_s must be finite numbers");
    MotionProblem problem;
    problem.inertia = inertia;
    problem.method = {options.method, options.step_s, options.tolerance, options.order};
    problem.first_time_s = options.first_time_s;
    problem.last_time_s = options.last_time_s;
    return problem;
}

poinsot::Motion free_or_driven(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
                               const MotionOptions& options) {
    MotionProblem problem = problem_of(inertia, options);
    problem.start.omega_body = omega_body;
    problem.start.space_from_body = options.start_attitude;
    problem.torque = options.torque;
    if (auto* gravity = std::get_if<Gravity>(&problem.torque)) gravity->arm_body.stableNormalize();
    return poinsot::Motion(problem, options.stop);
}

State state_of(const MotionSample& sample) {
    return {.time_s = sample.state.time_s,
            .omega_body = sample.state.omega_body,
            .space_from_body = sample.state.space_from_body,
            .herpolhode_space = sample.herpolhode_space};
}

constexpr Quantities state_quantities{.attitude = true, .herpolhode = true};

// Both list the same regimes in the same order.
Regime public_regime(poinsot::Regime regime) { return static_cast<Regime>(regime); }
static_assert(static_cast<int>(poinsot::Regime::integrated) ==
              static_cast<int>(Regime::integrated));

}  // namespace

Motion MotionAccess::of(poinsot::Motion motion) {
    return Motion(std::make_shared<const Motion::Impl>(Motion::Impl{std::move(motion)}));
}

Motion::Motion(std::shared_ptr<const Impl> inside) : impl_(std::move(inside)) {}

Motion::Motion(const Eigen::Vector3d& moments_kg_m2, const Eigen::Vector3d& omega_body_rad_s,
               const MotionOptions& options)
    : Motion(MotionAccess::of(free_or_driven(
          InertiaTensor::from_principal_moments(moments_kg_m2, physicality_of(options)),
          omega_body_rad_s, options))) {}

Motion Motion::with_tensor(const Eigen::Matrix3d& tensor_kg_m2,
                           const Eigen::Vector3d& omega_body_rad_s, const MotionOptions& options) {
    return MotionAccess::of(
        free_or_driven(InertiaTensor::from_matrix(tensor_kg_m2, physicality_of(options)),
                       omega_body_rad_s, options));
}

Motion Motion::heavy_top(double moment_transverse_kg_m2, double moment_axial_kg_m2, double mgl_N_m,
                         const TopStart& start, const MotionOptions& options) {
    const Eigen::Vector3d moments(moment_transverse_kg_m2, moment_transverse_kg_m2,
                                  moment_axial_kg_m2);
    MotionProblem problem = problem_of(
        InertiaTensor::from_principal_moments(moments, physicality_of(options)), options);
    problem.start = start_of(HeavyTopProblem{.moment_transverse_kg_m2 = moment_transverse_kg_m2,
                                             .moment_axial_kg_m2 = moment_axial_kg_m2,
                                             .mgl_N_m = mgl_N_m,
                                             .theta_rad = start.theta_rad,
                                             .theta_dot_rad_s = start.theta_dot_rad_s,
                                             .phi_dot_rad_s = start.phi_dot_rad_s,
                                             .omega3_rad_s = start.omega3_rad_s});
    problem.top_start = {start.theta_rad, start.theta_dot_rad_s, start.phi_dot_rad_s,
                         start.omega3_rad_s};
    problem.torque = Gravity{.mgl_N_m = mgl_N_m};
    return MotionAccess::of(poinsot::Motion(problem, options.stop));
}

State Motion::at(double time_s) const {
    return state_of(impl_->motion.sample(time_s, state_quantities));
}

void Motion::at(std::span<const double> times_s, std::span<State> states) const {
    if (times_s.size() != states.size())
        throw InputError("at: there are " + std::to_string(times_s.size()) + " times and " +
                         std::to_string(states.size()) + " states; give as many of both");
    for (std::size_t i = 0; i < times_s.size(); ++i) states[i] = at(times_s[i]);
}

EulerAngles Motion::euler_angles(double time_s) const {
    const poinsot::EulerAngles euler =
        impl_->motion.sample(time_s, {.attitude = true, .euler_angles = true}).euler;
    return {euler.theta_rad, euler.phi_rad, euler.psi_rad};
}

Regime Motion::regime() const { return public_regime(impl_->motion.regime()); }

std::string Motion::regime_sentence() const { return poinsot::regime_sentence(impl_->motion); }

Eigen::Vector3d Motion::moments_kg_m2() const {
    return impl_->motion.problem().inertia.moments_kg_m2();
}

Eigen::Matrix3d Motion::body_from_principal() const {
    return impl_->motion.problem().inertia.body_from_principal();
}

Constants Motion::constants() const {
    if (!std::holds_alternative<poinsot::NoTorque>(impl_->motion.problem().torque))
        throw InputError(
            "constants: T and L are not constant under a torque; a heavy symmetric top has "
            "top_constants");
    const FreeRotationConstants constants = impl_->motion.free_constants();
    // ω stays where it is: the polhode is a point.
    const poinsot::MotionProblem& problem = impl_->motion.problem();
    const Eigen::Vector3d omega =
        problem.inertia.body_from_principal().transpose() * problem.start.omega_body;
    const Eigen::Vector3d momentum = problem.inertia.moments_kg_m2().cwiseProduct(omega);
    const bool steady = omega.cross(momentum).isZero(0.0);
    return {.kinetic_energy_J = constants.kinetic_energy_J,
            .momentum_kg_m2_s = constants.momentum_kg_m2_s,
            .momentum_space = constants.momentum_space,
            .encircled_axis = steady ? std::nullopt : std::optional<int>(constants.encircled_axis),
            .modulus = constants.modulus,
            .polhode_period_s = constants.polhode_period_s,
            .advance_per_period_rad = constants.advance_per_period_rad,
            .precession_rad_s = constants.mean_advance_rate_rad_s,
            .least_herpolhode_rad_s = constants.least_herpolhode_radius_rad_s,
            .greatest_herpolhode_rad_s = constants.greatest_herpolhode_radius_rad_s};
}

TopConstants Motion::top_constants() const {
    const auto top = impl_->motion.closed_form_of_top();
    if (!top)
        throw InputError(
            "top_constants: the body is not a heavy symmetric top; a free body has constants");
    const TopInvariants& kept = top->invariants();
    const TopNutation& nutation = top->nutation();
    return {.p_phi_kg_m2_s = kept.p_phi_kg_m2_s,
            .p_psi_kg_m2_s = kept.p_psi_kg_m2_s,
            .energy_J = kept.energy_J,
            .theta_min_rad = nutation.theta_min_rad,
            .theta_max_rad = nutation.theta_max_rad,
            .nutation_period_s = nutation.period_s,
            .precession_rad_s = nutation.precession_rate_rad_s};
}

std::string_view name_of(Regime regime) {
    return poinsot::name_of(static_cast<poinsot::Regime>(regime));
}

}  // namespace poinsot::library
