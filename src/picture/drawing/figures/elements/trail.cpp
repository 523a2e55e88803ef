#include "drawing/figures/elements/trail.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "drawing/figures/elements/filled_annulus.h"
#include "drawing/stage/smooth_paths.h"
#include "drawing/stage/stage_context.h"
#include "mechanics/top/heavy_top.h"

namespace poinsot {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// ω turns about L at L/I_min at most; a path is resolved if sampled every half turn at that rate.
double feature_s(const StageContext& stage) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    const double fastest =
        construction.momentum_kg_m2_s() / construction.inertia().moments_kg_m2().minCoeff();
    return fastest > 0.0 ? std::numbers::pi / fastest : 1.0;
}

// An eighth of the mean time of half a turn, on the ellipsoid or about L. For a needle, whose least
// moment does not determine its motion, this is a million times as long as the time above. Zero if
// there is no mean.
double mean_feature_s(const StageContext& stage) {
    if (stage.motion.motion().integrated() != nullptr || !stage.polhode_period_s) return 0.0;
    const double rate_rad_s =
        std::abs(stage.motion.motion().free_constants().mean_advance_rate_rad_s);
    const double half_turn_s = std::min(0.5 * *stage.polhode_period_s,
                                        rate_rad_s > 0.0 ? std::numbers::pi / rate_rad_s : endless);
    return half_turn_s / 8.0;
}

// The length of a fading trail: the scene's, or one period of the polhode or of a top's nutation.
double fading_length_s(const StageContext& stage) {
    if (stage.scene.trail.length_s) return *stage.scene.trail.length_s;
    if (const HeavyTop* top = stage.motion.motion().heavy_top()) {
        const double period_s = top->nutation().period_s;
        return period_s > 0.0 ? period_s : endless;
    }
    return stage.polhode_period_s.value_or(endless);
}

// Most points of a path, and of a herpolhode that has not yet filled its annulus.
constexpr std::size_t most_points = 200'000;
constexpr std::size_t most_annulus_points = 1'000'000;

}  // namespace

Trail::Trail(const StageContext& stage, const std::string& kind, const TimedPath& path,
             std::optional<double> period_s)
    : kind_(kind),
      times_{path.times_s, {}, {}, 0, path.off},
      first_time_s_(stage.options.first_time_s),
      last_time_s_(stage.options.last_time_s),
      period_s_(period_s),
      length_s_(fading_length_s(stage)),
      loops_(stage.options.repeat_s > 0.0) {}

ShownStretch Trail::at(double time_s) const {
    // Wrapped into the period that was sampled from the film's first instant on.
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
    // A growing trail fades at the rate of a complete one.
    if (kind_ == "fading" && shown_s > 0.0 && wanted_s < endless) {
        stretch.fade_points = (stretch.last - stretch.first) * (wanted_s / shown_s);
    }
    return stretch;
}

namespace {

// A path to sample, and the quantities of the motion that its point needs.
struct WantedPath {
    const PathPoint& point;
    Quantities wanted;
    double tolerance = 0.0;
    std::size_t most = most_points;
};

// Samples a path over a stretch of time, and counts its evaluations.
TimedPath sampled(const StageContext& stage, const WantedPath& path, double from_s, double to_s) {
    const double shortest_s = feature_s(stage);
    TimedPath timed = sample_path(path.point, from_s, to_s, shortest_s, path.tolerance, path.most);
    if (std::isinf(timed.off) && mean_feature_s(stage) > shortest_s)
        timed =
            sample_path(path.point, from_s, to_s, mean_feature_s(stage), path.tolerance, path.most);
    stage.motion.count(path.wanted, timed.n_evaluations);
    return timed;
}

// Samples the whole stretch that is drawn or, for a periodic path, one period before the first
// instant and one after it.
TimedPath sampled(const StageContext& stage, const WantedPath& path,
                  std::optional<double> period_s) {
    const StageOptions& options = stage.options;
    if (!period_s) return sampled(stage, path, options.first_time_s, options.last_time_s);
    return sampled(stage, path, options.first_time_s - *period_s, options.first_time_s + *period_s);
}

// Distance of the point at the last instants from its position on the path of one period.
double drift(const StageContext& stage, const PathPoint& point, double period_s) {
    const StageOptions& options = stage.options;
    constexpr int n_looks = 8;
    double farthest = 0.0;
    for (int k = 0; k < n_looks; ++k) {
        const double time_s = options.last_time_s - period_s * k / n_looks;
        const double since_s = time_s - options.first_time_s;
        if (!(since_s > period_s)) break;
        const double again_s = options.first_time_s + std::fmod(since_s, period_s);
        farthest = std::max(farthest, (point(time_s) - point(again_s)).norm());
    }
    return farthest;
}

// The same, without rounding errors that no picture shows.
double seen_drift(const StageContext& stage, const PathPoint& point, double period_s,
                  double tolerance) {
    const double off = drift(stage, point, period_s);
    return off > 1e-6 * tolerance ? off : 0.0;
}

// On the separatrix the contact point comes to rest. Returns the instant after which it stays
// within half of the tolerance of its end; none if that is too late for its path to be sampled.
std::optional<double> resting_s(const StageContext& stage, const PathPoint& point,
                                double tolerance) {
    const StageOptions& options = stage.options;
    const Eigen::Vector3d end = point(options.last_time_s);
    for (double after_s = feature_s(stage); after_s < 0.25 * most_points * 0.25 * feature_s(stage);
         after_s *= 2.0) {
        const double time_s = options.first_time_s + after_s;
        if (!(time_s < options.last_time_s)) break;
        const double from_end = (point(time_s) - end).norm();
        // Before that, it may move away from the same axis.
        const bool comes_near = from_end < (point(time_s - feature_s(stage)) - end).norm();
        if (comes_near && from_end <= 0.5 * tolerance) return time_s;
    }
    return std::nullopt;
}

// Whether the motion's tangents agree with its positions to the last digit; those of a stepped
// motion agree only to its own accuracy.
bool is_smooth(const StageContext& stage) { return stage.motion.motion().integrated() == nullptr; }

// Euler's equations: I ω̇ = Iω × ω, body axes.
Eigen::Vector3d omega_dot_body(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body) {
    const Eigen::Vector3d I = inertia.moments_kg_m2() / inertia.moments_kg_m2().maxCoeff();
    const Eigen::Vector3d omega = inertia.body_from_principal().transpose() * omega_body;
    return inertia.body_from_principal() * I.cwiseProduct(omega).cross(omega).cwiseQuotient(I);
}

// The contact point's path on the plane, in the space axes of the stage's instants. Its velocity is
// −ω̇/√(2T), since ω's component along L is constant.
CurveFlow herpolhode_flow(const StageContext& stage, double time_s) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    const MotionSample sample = stage.motion.motion().sample(
        time_s, {.attitude = true, .herpolhode = true, .euler_angles = false});
    CurveFlow flow{construction.contact_in_plane(sample.herpolhode_space),
                   construction.contact_in_plane(
                       sample.state.space_from_body *
                       omega_dot_body(construction.inertia(), sample.state.omega_body))};
    if (!stage.turns()) return flow;
    // The axes turn at a constant rate: the rotation over the time of one radian gives the axis.
    const Eigen::Vector3d axis =
        stage.turned_from_space(stage.scene.film.start_s + 1.0 / stage.turn_rate_rad_s)
            .vec()
            .normalized();
    const Eigen::Quaterniond turn = stage.turned_from_space(time_s);
    flow.position = turn * flow.position;
    flow.velocity = turn * flow.velocity + stage.turn_rate_rad_s * axis.cross(flow.position);
    return flow;
}

// The contact point's path on the ellipsoid, body axes.
CurveFlow polhode_flow(const StageContext& stage, double time_s) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    const Eigen::Vector3d omega =
        stage.motion.motion().sample(time_s, omega_alone).state.omega_body;
    return {construction.contact_body(omega),
            construction.contact_body(omega_dot_body(construction.inertia(), omega))};
}

}  // namespace

Drawer traversed(Curve curve, Trail trail) {
    return [curve = std::move(curve), trail = std::move(trail)](const FrameInput& instant,
                                                                ViewBuilder& builder) {
        Curve shown = curve;
        trail.at(instant.time_s).apply_to(shown);
        builder.view.curves.push_back(shown);
    };
}

TimedCurve herpolhode_trail(const StageContext& stage, double tolerance, double width) {
    const PoinsotConstruction& construction = stage.rolling->construction;
    const StageOptions& options = stage.options;
    const std::string& kind = stage.scene.trail.herpolhode;
    const bool follows = stage.follows_momentum();
    const Quantities wanted{.attitude = follows, .herpolhode = true, .euler_angles = false};
    const PathPoint point = [&, follows](double t) -> Eigen::Vector3d {
        const MotionSample sample = stage.motion.motion().sample(t, wanted);
        const Eigen::Vector3d& space = sample.herpolhode_space;
        if (stage.rolling->dissipates)
            return construction.contact_in_plane(follows ? stage.turned_from_space(t) * space
                                                         : space) *
                   stage.rolling->rho_growth(sample.state.omega_body);
        return construction.contact_in_plane(stage.turns() ? stage.turned_from_space(t) * space
                                                           : space);
    };
    const auto as_curve = [&](TimedPath path, std::optional<double> period_s) {
        Trail trail(stage, kind, path, period_s);
        TimedCurve timed{std::move(path.points), std::move(trail), path.off};
        if (is_smooth(stage))
            timed.smooth = smooth_path([&stage](double t) { return herpolhode_flow(stage, t); },
                                       std::move(path.times_s));
        return timed;
    };

    auto period_s = options.repeat_s > 0.0 ? std::optional(options.repeat_s) : std::nullopt;
    TimedPath path = sampled(stage, {point, wanted, tolerance}, period_s);
    if (period_s) path.off += seen_drift(stage, point, *period_s, tolerance);
    const bool is_exact = is_smooth(stage) && !stage.rolling->dissipates;
    if (period_s || path.off <= tolerance || !is_exact) return as_curve(std::move(path), period_s);

    // Too many turns to sample all of them. The shown part may be a short stretch,
    const auto kept = [&](double from_s, double to_s, std::size_t most = most_points) {
        path = sampled(stage, {point, wanted, tolerance, most}, from_s, to_s);
        return path.off <= tolerance;
    };
    const double first_shown_s = options.first_shown_s.value_or(options.first_time_s);
    if (kind == "fading") {
        const double from_s = first_shown_s - fading_length_s(stage);
        if (from_s > options.first_time_s && kept(from_s, options.last_time_s))
            return as_curve(std::move(path), {});
    }
    // the path may come to rest,
    if (stage.rolling->polhode.kind() == Polhode::Kind::separatrix) {
        if (const auto to_s = resting_s(stage, point, tolerance))
            if (kept(options.first_time_s, *to_s)) return as_curve(std::move(path), {});
    }
    // it may repeat,
    const double span_s = options.last_time_s - options.first_time_s;
    const double longest_s = 0.05 * most_points * feature_s(stage);
    period_s = retracing_s(stage, span_s, longest_s, tolerance);
    if (period_s) {
        path = sampled(stage, {point, wanted, 0.5 * tolerance}, period_s);
        path.off += seen_drift(stage, point, *period_s, tolerance);
        if (path.off <= tolerance) return as_curve(std::move(path), period_s);
    }
    // or it may fill its annulus.
    const auto annulus = kind == "fading"
                             ? std::nullopt
                             : filled_annulus(stage, point, tolerance, width, most_points);
    if (!annulus || !(span_s >= annulus->filled_after_s)) {
        kept(options.first_time_s, options.last_time_s, most_annulus_points);
        return as_curve(std::move(path), {});
    }
    const bool always = kind == "whole";
    const double filled_s = options.first_time_s + annulus->filled_after_s;
    // A curve of one point if no instant shows it.
    const bool is_shown = !always && first_shown_s < filled_s;
    if (!kept(options.first_time_s, is_shown ? filled_s : options.first_time_s,
              most_annulus_points))
        return as_curve(std::move(path), {});
    TimedCurve timed = as_curve(std::move(path), {});
    timed.annulus = AnnulusFromThen{always ? -endless : filled_s, annulus->points};
    return timed;
}

double herpolhode_width_px(const Panel& panel, double annulus_px) {
    const StageContext& stage = *panel.stage;
    const double usual_px = 4.0 * stage.theme.herpolhode_weight;
    if (!is_on_paper(stage) || stage.rolling->dissipates) return usual_px;
    // In its annulus the turns are on average this far apart.
    const double span_s =
        std::max(stage.options.last_time_s - stage.options.first_time_s, stage.options.repeat_s);
    const double rate_rad_s = stage.motion.motion().free_constants().mean_advance_rate_rad_s;
    const double n_turns = std::abs(rate_rad_s) * span_s / (2.0 * std::numbers::pi);
    const double apart_px = annulus_px / std::max(n_turns, 1.0);
    constexpr double share = 0.75;
    const double least_px = std::min(stage.options.least.line_px / panel.px, usual_px);
    return std::clamp(share * apart_px / panel.px, least_px, usual_px);
}

void add_on_grid(const Panel& panel, const Curve& curve, View& view) {
    constexpr double edge_px = 2.0, edge_opacity = 0.85;
    Curve edge = curve;
    edge.width_px += 2.0 * edge_px * panel.px;
    edge.dash_px = edge.gap_px = 0.0;
    edge.colour = panel.stage->theme.halo;
    edge.opacity *= edge_opacity;
    edge.hidden = HiddenStyle::absent;
    edge.name = {"herpolhode", 0, "edge"};
    view.curves.push_back(edge);
    view.curves.push_back(curve);
}

TimedCurve polhode_trail(const StageContext& stage, double tolerance, const BodyMap& map) {
    const PathPoint point = [&](double t) -> Eigen::Vector3d {
        const Eigen::Vector3d at = stage.rolling->contact_body(
            stage.motion.motion().sample(t, omega_alone).state.omega_body);
        return map ? map(at) : at;
    };
    const std::string& kind = stage.scene.trail.polhode;
    // By a stepped method, ω need not be periodic.
    const auto period_s = is_smooth(stage) ? stage.polhode_period_s : std::nullopt;
    TimedPath path = sampled(stage, {point, omega_alone, tolerance}, period_s);
    // The whole curve is the same at all times; its last stretch is not.
    if (period_s && kind == "fading") path.off += seen_drift(stage, point, *period_s, tolerance);
    const bool may_rest = stage.rolling->polhode.kind() == Polhode::Kind::separatrix &&
                          is_smooth(stage) && !stage.rolling->dissipates;
    if (!(path.off <= tolerance) && may_rest) {
        if (const auto to_s = resting_s(stage, point, tolerance))
            path =
                sampled(stage, {point, omega_alone, tolerance}, stage.options.first_time_s, *to_s);
    }
    Trail trail(stage, kind, path, period_s);
    TimedCurve timed{std::move(path.points), std::move(trail), path.off};
    if (is_smooth(stage) && !map)
        timed.smooth = smooth_path([&stage](double t) { return polhode_flow(stage, t); },
                                   std::move(path.times_s));
    return timed;
}

}  // namespace poinsot
