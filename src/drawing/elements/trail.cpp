#include "drawing/elements/trail.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "drawing/elements/smooth_paths.h"

namespace poinsot {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// ω turns about L at most at L/I_min; half a turn at that rate is surely one piece of a path.
double feature_s(const StageData& stage) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    const double fastest =
        construction.momentum_kg_m2_s() / construction.inertia().moments_kg_m2().minCoeff();
    return fastest > 0.0 ? std::numbers::pi / fastest : 1.0;
}

}  // namespace

Trail::Trail(const StageData& stage, const std::string& kind, const TimedPath& path,
             std::optional<double> period_s)
    : kind_(kind),
      times_{path.times_s, {}, 0, path.off},
      first_time_s_(stage.options.first_time_s),
      last_time_s_(stage.options.last_time_s),
      period_s_(period_s),
      length_s_(stage.scene.trail.length_s.value_or(stage.polhode_period_s.value_or(endless))),
      loops_(stage.options.loop_s > 0.0) {}

ShownStretch Trail::at(double time_s) const {
    // Within the period that was sampled after the film's first instant.
    double end_s = time_s;
    if (period_s_) {
        const double since_s = std::fmod(time_s - first_time_s_, *period_s_);
        end_s = first_time_s_ + (since_s < 0.0 ? since_s + *period_s_ : since_s);
    }
    const double most_s = period_s_.value_or(endless);
    if (kind_ == "whole" || (loops_ && kind_ == "history")) {
        const double whole_end_s = period_s_ ? first_time_s_ + *period_s_ : last_time_s_;
        return {times_.index_at(first_time_s_), times_.index_at(whole_end_s), 0.0, false, true};
    }

    const double run_s = loops_ ? most_s : std::max(0.0, time_s - first_time_s_);
    const double wanted_s = std::min(kind_ == "fading" ? length_s_ : endless, most_s);
    const double shown_s = std::min(wanted_s, run_s);
    const bool all = !period_s_ && shown_s >= run_s;
    ShownStretch stretch{times_.index_at(all ? first_time_s_ : end_s - shown_s),
                         times_.index_at(end_s), 0.0, true, all && kind_ != "fading"};
    // A trail that is still growing fades at the pace of a whole one.
    if (kind_ == "fading" && shown_s > 0.0 && wanted_s < endless) {
        stretch.fade_points = (stretch.last - stretch.first) * (wanted_s / shown_s);
    }
    return stretch;
}

namespace {

// Samples a path over what its trail needs, and counts what that took.
TimedPath sampled(const StageData& stage, const std::function<Eigen::Vector3d(double)>& point,
                  std::optional<double> period_s, const Quantities& wanted, double tolerance) {
    const StageOptions& options = stage.options;
    TimedPath path =
        period_s ? sample_path(point, options.first_time_s - *period_s,
                               options.first_time_s + *period_s, feature_s(stage), tolerance)
                 : sample_path(point, options.first_time_s, options.last_time_s, feature_s(stage),
                               tolerance);
    stage.motion.count(wanted, path.n_evaluations);
    return path;
}

// Whether the motion has tangents that belong to its positions to the last digit: a stepped one has
// them to its own accuracy.
bool is_smooth(const StageData& stage) { return stage.motion.motion().integrated() == nullptr; }

// Euler's equations: I ω̇ = Iω × ω, body axes.
Eigen::Vector3d omega_dot_body(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body) {
    const Eigen::Vector3d I = inertia.moments_kg_m2() / inertia.moments_kg_m2().maxCoeff();
    const Eigen::Vector3d omega = inertia.body_from_principal().transpose() * omega_body;
    return inertia.body_from_principal() * I.cwiseProduct(omega).cross(omega).cwiseQuotient(I);
}

// The contact point's path on the plane, in the space axes that the stage's instants are given in.
// −ω̇/√(2T) is how fast it runs, for ω's component along L does not change.
CurveFlow herpolhode_flow(const StageData& stage, double time_s) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    const MotionSample sample = stage.motion.motion().sample(
        time_s, {.attitude = true, .herpolhode = true, .euler_angles = false});
    CurveFlow flow{construction.contact_in_plane(sample.herpolhode_space),
                   construction.contact_in_plane(
                       sample.state.space_from_body *
                       omega_dot_body(construction.inertia(), sample.state.omega_body))};
    if (!stage.turns()) return flow;
    // The axes turn at one rate: after the time of one radian by the axis and that angle.
    const Eigen::Vector3d axis =
        stage.turned_from_space(stage.scene.film.start_s + 1.0 / stage.turn_rate_rad_s)
            .vec()
            .normalized();
    const Eigen::Quaterniond turn = stage.turned_from_space(time_s);
    flow.position = turn * flow.position;
    flow.velocity = turn * flow.velocity + stage.turn_rate_rad_s * axis.cross(flow.position);
    return flow;
}

// The same on the ellipsoid, body axes.
CurveFlow polhode_flow(const StageData& stage, double time_s) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    const Eigen::Vector3d omega =
        stage.motion.motion().sample(time_s, omega_alone).state.omega_body;
    return {construction.contact_body(omega),
            construction.contact_body(omega_dot_body(construction.inertia(), omega))};
}

}  // namespace

TimedCurve herpolhode_trail(const StageData& stage, double tolerance) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    constexpr Quantities wanted{.attitude = false, .herpolhode = true, .euler_angles = false};
    const auto point = [&](double t) -> Eigen::Vector3d {
        const MotionSample sample = stage.motion.motion().sample(t, wanted);
        const Eigen::Vector3d& space = sample.herpolhode_space;
        if (stage.rolling->dissipates)
            return construction.contact_in_plane(space) *
                   stage.rolling->rho_growth(sample.state.omega_body);
        return construction.contact_in_plane(stage.turns() ? stage.turned_from_space(t) * space
                                                           : space);
    };
    const auto period_s =
        stage.options.loop_s > 0.0 ? std::optional(stage.options.loop_s) : std::nullopt;
    TimedPath path = sampled(stage, point, period_s, wanted, tolerance);
    Trail trail(stage, stage.scene.trail.herpolhode, path, period_s);
    TimedCurve timed{std::move(path.points), std::move(trail), path.off};
    if (is_smooth(stage))
        timed.smooth = smooth_path([&stage](double t) { return herpolhode_flow(stage, t); },
                                   std::move(path.times_s));
    return timed;
}

TimedCurve polhode_trail(const StageData& stage, double tolerance) {
    const auto point = [&](double t) {
        return stage.rolling->contact_body(
            stage.motion.motion().sample(t, omega_alone).state.omega_body);
    };
    // What a stepped method does with ω need not come back.
    const bool returns = stage.motion.motion().integrated() == nullptr;
    const auto period_s = returns ? stage.polhode_period_s : std::nullopt;
    TimedPath path = sampled(stage, point, period_s, omega_alone, tolerance);
    Trail trail(stage, stage.scene.trail.polhode, path, period_s);
    TimedCurve timed{std::move(path.points), std::move(trail), path.off};
    if (is_smooth(stage))
        timed.smooth = smooth_path([&stage](double t) { return polhode_flow(stage, t); },
                                   std::move(path.times_s));
    return timed;
}

}  // namespace poinsot
