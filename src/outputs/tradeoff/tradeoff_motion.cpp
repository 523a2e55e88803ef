// Speed versus accuracy of the methods, for one scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "error/error.h"
#include "mechanics/methods.h"
#include "mechanics/motion_errors.h"
#include "numerics/power_of_two.h"
#include "tradeoff/measure.h"
#include "tradeoff/tradeoff.h"

namespace poinsot {

namespace {

// Largest cost of a run of one setting; finer settings of the same method are then omitted.
constexpr double longest_run_s = 0.25;

MotionProblem with_method(const MotionProblem& problem, const MethodChoice& choice) {
    MotionProblem changed = problem;
    changed.method = choice;
    return changed;
}

// The reference motion, with its name.
std::pair<Motion, std::string> truth_of(const MotionProblem& problem) {
    if (can_solve(find_method("exact"), problem.inertia, problem.torque)) {
        return {Motion(with_method(problem, {"exact", {}, {}, {}})), "exact"};
    }
    return {Motion(with_method(problem, {"dopri5", {}, least_tolerance, {}})),
            fmt::format("dopri5 at tolerance {:g}", least_tolerance)};
}

std::vector<MethodChoice> ladder(const Method& method, double turn_s, double span_s) {
    if (method.make == nullptr) return {{std::string(method.name), {}, {}, {}}};
    std::vector<MethodChoice> choices;
    if (method.takes_tolerance && !method.takes_step) {
        for (double tolerance = 1e-3; tolerance > 5e-14; tolerance *= 0.1) {
            choices.push_back({std::string(method.name), {}, tolerance, {}});
        }
        return choices;
    }
    const std::vector<int> orders =
        method.orders.size() > 1 ? std::vector<int>(method.orders.begin(), method.orders.end())
                                 : std::vector<int>{0};
    for (const int order : orders) {
        for (double step_s = turn_s / 4.0; step_s > turn_s / 20000.0; step_s *= 0.5) {
            if (step_s > span_s) continue;
            MethodChoice choice{std::string(method.name), step_s, {}, {}};
            if (order > 0) choice.order = order;
            choices.push_back(choice);
        }
    }
    return choices;
}

MotionTrade measure(const MotionProblem& problem, const MethodChoice& choice, const Motion& truth,
                    std::span<const double> times, double px_per_rad, int& n_runs) {
    // The cost is that of a film: constructing the motion and evaluating it at every frame in
    // order.
    double sink = 0.0;
    const Timing timing = timed(
        [&] {
            const Motion motion(with_method(problem, choice));
            for (const double time_s : times) sink += motion.at(time_s).space_from_body.w();
        },
        3, 15, 0.03);
    n_runs = std::min(n_runs, timing.n_runs);

    const Motion motion(with_method(problem, choice));
    const MotionErrors errors = worst_errors(motion, truth, times);
    const auto n = static_cast<double>(times.size());
    MotionTrade row;
    row.method = choice.order ? fmt::format("{}-{}", choice.name, *choice.order) : choice.name;
    row.setting = choice.step_s      ? fmt::format("step {:.3g} s", *choice.step_s)
                  : choice.tolerance ? fmt::format("tolerance {:.0e}", *choice.tolerance)
                                     : "";
    row.ns_a_frame = timing.cpu_s / n * 1e9 + 0.0 * sink;
    const IntegratedRotation* stepped = motion.integrated();
    row.evaluations_a_frame =
        stepped != nullptr ? static_cast<double>(stepped->counters().n_right_hand_sides) / n : 1.0;
    row.attitude_rad = errors.attitude_rad;
    if (is_free(problem.torque)) {
        row.energy = errors.energy_relative;
        row.momentum = errors.momentum_relative;
    }
    row.displacement_px = errors.attitude_rad * px_per_rad;
    return row;
}

}  // namespace

MotionTrades trade_motion(const Session& session, const FilmPlan& film, double px_per_rad) {
    const MotionProblem& problem = session.motion.problem();
    const auto [truth, truth_name] = truth_of(problem);

    std::vector<double> times;
    for (std::int64_t frame = 0; frame < film.n_frames; ++frame) {
        times.push_back(film.time_of(frame));
    }
    const double turn_s = 2.0 * std::numbers::pi / norm_of(problem.start.omega_body);
    const double span_s = std::max(std::abs(problem.first_time_s), std::abs(problem.last_time_s));

    MotionTrades trades;
    trades.truth = truth_name;
    trades.n_frames = film.n_frames;
    trades.n_runs = 1000;
    for (const Method& method : methods()) {
        if (!can_solve(method, problem.inertia, problem.torque)) continue;
        std::string too_slow;
        for (const MethodChoice& choice : ladder(method, turn_s, span_s)) {
            const std::string series = fmt::format("{}-{}", choice.name, choice.order.value_or(0));
            if (series == too_slow) continue;
            // A setting that the method does not support for this scene has no row.
            try {
                trades.rows.push_back(
                    measure(problem, choice, truth, times, px_per_rad, trades.n_runs));
            } catch (const InputError&) {
                continue;
            }
            const double run_s =
                trades.rows.back().ns_a_frame * 1e-9 * static_cast<double>(film.n_frames);
            if (run_s > longest_run_s || trades.rows.back().attitude_rad < 2e-15) too_slow = series;
        }
    }
    mark_front(trades.rows, &MotionTrade::ns_a_frame, &MotionTrade::attitude_rad);
    return trades;
}

}  // namespace poinsot
