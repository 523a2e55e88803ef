#include "drawing/stage/stage_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/stage/accuracy.h"
#include "error/error.h"
#include "numerics/least_turn.h"
#include "numerics/power_of_two.h"

namespace poinsot {

StageContext::StageContext(const Scene& scene_, const Theme& theme_, const Motion& motion_,
                           const StageOptions& options_, const Motion* comparison_)
    : scene(scene_),
      motion(motion_),
      options(options_),
      theme(theme_),
      px(options.line_scale > 0.0 ? options.line_scale : options.height_px / 1080.0),
      curve_px(options.curve_px > 0.0 ? options.curve_px : accuracy_of(scene).curve_px()),
      film_first_s(std::min(scene.film.start_s, options.first_time_s)),
      film_last_s(std::max(film_end_time_s(scene), options.last_time_s)) {
    if (comparison_ != nullptr) comparison.emplace(*comparison_);
    make_construction();
    timeline = Timeline(scene, rolling ? rolling->foot() : Eigen::Vector3d::Zero().eval());
}

void StageContext::make_construction() {
    const MotionProblem& problem = motion.motion().problem();
    if (!rolls(problem.torque) || problem.start.omega_body.isZero(0.0)) return;
    // A second motion would have an L of its own, and no plane in axes that turn with the first.
    if (is_slowed(problem.torque) && comparison) return;
    rolling.emplace(problem, scene.construction.plane);
    if (dissipates(problem.torque)) {
        rolling->dissipates = true;
        rolling->is_slowed = is_slowed(problem.torque);
        if (rolling->is_slowed) check_turning();
        rolling->cones.reset();  // their angles change
        widen_herpolhode();
        return;
    }
    const FreeRotationConstants constants = motion.motion().free_constants();
    polhode_period_s = constants.polhode_period_s;
    if (scene.camera.motion == "co-precessing") turn_rate_rad_s = constants.mean_advance_rate_rad_s;
}

RotationState StageContext::measured_state(const MeasuredRow& row) const {
    if (scene.measured.motion.has_attitude)
        return {row.time_s, row.space_from_body, row.omega_body};
    return {row.time_s, motion.sample(row.time_s, attitude_too).state.space_from_body,
            row.omega_body};
}

// The construction needs a direction of ω: the air must not have stopped the body.
void StageContext::check_turning() const {
    constexpr double slowest = 1e-100;  // as a share of the start: squares are doubles
    const double start = norm_of(motion.motion().problem().start.omega_body);
    for (const double time_s : {options.first_time_s, options.last_time_s}) {
        const double left = norm_of(motion.motion().at(time_s).omega_body) / start;
        if (left > slowest && left < 1.0 / slowest) continue;
        throw InputError(fmt::format(
            "at {} s the drag has left {:.3g} of ω, from which no construction can be drawn; end "
            "the film before, or give smaller rates",
            time_s, left));
    }
}

// Enlarges the herpolhode's radius to the largest component of ρ in the plane over the film.
void StageContext::widen_herpolhode() {
    constexpr int n_looks = 512;
    constexpr Quantities in_plane{.attitude = false, .herpolhode = true, .euler_angles = false};
    for (int k = 0; k <= n_looks; ++k) {
        const double time_s =
            options.first_time_s + (options.last_time_s - options.first_time_s) * k / n_looks;
        const MotionSample sample = motion.motion().sample(time_s, in_plane);
        const Eigen::Vector3d rho =
            rolling->construction.contact_in_plane(sample.herpolhode_space) *
            rolling->rho_growth(sample.state.omega_body);
        rolling->herpolhode_radius =
            std::max(rolling->herpolhode_radius, rho.norm() * rolling->picture_per_rho);
    }
}

FrameInput StageContext::instant_at(const FilmTime& moment, const Quantities& needs,
                                    bool with_comparison) const {
    Quantities wanted = needs;
    if (follows_momentum()) wanted.attitude = true;
    FrameInput instant{motion.sample(moment.time_s, wanted), moment.time_s, moment.film_s};
    if (with_comparison) {
        constexpr Quantities whole_state{
            .attitude = true, .herpolhode = false, .euler_angles = false};
        instant.comparison = comparison->sample(moment.time_s, whole_state).state;
    }
    if (turns() || follows_momentum()) {
        const Eigen::Quaterniond turn =
            follows_momentum() ? turn_of_momentum(instant.state) : turned_from_space(moment.time_s);
        instant.state.space_from_body = turn * instant.state.space_from_body;
        instant.herpolhode_space = turn * instant.herpolhode_space;
        if (instant.comparison) {
            instant.comparison->space_from_body = turn * instant.comparison->space_from_body;
        }
    }
    return instant;
}

Eigen::Quaterniond StageContext::turn_of_momentum(const RotationState& state) const {
    const Eigen::Vector3d along =
        rolling->construction.inertia().matrix_body() * state.omega_body.stableNormalized();
    return least_turn(state.space_from_body * along, rolling->construction.normal_space());
}

Eigen::Quaterniond StageContext::turned_from_space(double time_s) const {
    if (follows_momentum()) return turn_of_momentum(motion.sample(time_s, attitude_too).state);
    const double angle_rad = turn_rate_rad_s * (time_s - scene.film.start_s);
    return Eigen::Quaterniond(Eigen::AngleAxisd(-angle_rad, rolling->construction.normal_space()));
}

double StageContext::quickest_rate_rad_s() const {
    const MotionProblem& problem = motion.motion().problem();
    const double I_least = problem.inertia.moments_kg_m2().minCoeff();
    const Eigen::Vector3d omega =
        problem.inertia.body_from_principal().transpose() * problem.start.omega_body;
    // In units of the least moment, so that T neither overflows nor underflows.
    const Eigen::Vector3d weights = (problem.inertia.moments_kg_m2() / I_least).cwiseSqrt();
    double rate = norm_of(weights.cwiseProduct(omega));
    if (const auto* gravity = std::get_if<Gravity>(&problem.torque)) {
        rate = std::hypot(rate, 2.0 * std::sqrt(std::abs(gravity->mgl_N_m) / I_least));
    }
    return rate;
}

double least_type_px(const StageContext& stage) {
    constexpr double least = 1080.0 / 45.0;
    return stage.options.line_scale > 0.0 ? stage.options.least.type_px
                                          : least * stage.scene.type_scale * stage.px;
}

double px_per_pt(const StageContext& stage) {
    constexpr double slide_height_pt = 540.0;
    return stage.options.px_per_pt > 0.0 ? stage.options.px_per_pt
                                         : stage.options.height_px / slide_height_pt;
}

}  // namespace poinsot
