#include "mechanics/step_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/methods.h"
#include "mechanics/motion_errors.h"

namespace poinsot {

namespace {

// Instants at which errors are measured: they grow with time, so the ends count most.
std::vector<double> instants(const MotionProblem& problem) {
    constexpr int n = 96;
    std::vector<double> times;
    for (int k = 0; k <= n; ++k) {
        times.push_back(problem.first_time_s +
                        (problem.last_time_s - problem.first_time_s) * k / n);
    }
    return times;
}

MotionProblem with(const MotionProblem& problem, const MethodChoice& method) {
    MotionProblem changed = problem;
    changed.method = method;
    return changed;
}

MethodChoice exact_choice() {
    MethodChoice choice;
    choice.name = "exact";
    return choice;
}

// The rungs, coarse to fine.
std::vector<MethodChoice> ladder(const MotionProblem& problem, const Method& method,
                                 double most_steps, double finest_tolerance) {
    std::vector<MethodChoice> rungs;
    MethodChoice rung = problem.method;
    if (!method.takes_step) {
        for (double tolerance = 1e-4; tolerance > finest_tolerance || rungs.empty();
             tolerance *= 0.1) {
            rung.tolerance = tolerance;
            rungs.push_back(rung);
        }
        return rungs;
    }
    const double span_s = std::max(std::abs(problem.first_time_s), std::abs(problem.last_time_s));
    const double turn_s = 2.0 * std::numbers::pi / problem.start.omega_body.stableNorm();
    double step_s = std::min(span_s, turn_s / 16.0);
    for (; span_s / step_s <= most_steps || rungs.empty(); step_s *= 0.5) {
        rung.step_s = step_s;
        rungs.push_back(rung);
    }
    return rungs;
}

// The error of a choice that names its step or tolerance: against the truth, or else against half
// the step or a tenth of the tolerance. Where no tolerance is finer, ten times this one is measured
// against it: an upper bound.
double error_of(const MotionProblem& problem, const std::optional<Motion>& truth,
                std::span<const double> times) {
    const auto error = [&](const MotionProblem& coarse, const Motion& fine) {
        return worst_errors(Motion(coarse), fine, times).attitude_rad;
    };
    if (truth) return error(problem, *truth);
    MethodChoice other = problem.method;
    if (other.step_s) *other.step_s *= 0.5;
    if (other.tolerance && *other.tolerance < 10.0 * least_tolerance) {
        *other.tolerance *= 10.0;
        return error(with(problem, other), Motion(problem));
    }
    if (other.tolerance) *other.tolerance *= 0.1;
    return error(problem, Motion(with(problem, other)));
}

}  // namespace

MethodChoice coarsest_choice(const MotionProblem& problem) {
    return ladder(problem, find_method(problem.method.name), 0.0, 1.0).front();
}

StepChoice choose_step(const MotionProblem& problem, double attitude_tolerance_rad,
                       double most_steps, double finest_tolerance) {
    StepChoice choice{problem.method, 0.0, true};
    const Method& method = find_method(problem.method.name);
    const bool given = problem.method.step_s || problem.method.tolerance;
    const bool still =
        problem.start.omega_body.isZero(0.0) || problem.first_time_s == problem.last_time_s;
    if (method.make == nullptr || still) return choice;

    const std::vector<double> times = instants(problem);
    std::optional<Motion> truth;
    if (can_solve(find_method("exact"), problem.inertia, problem.torque)) {
        truth.emplace(with(problem, exact_choice()));
    }
    if (given) {
        choice.attitude_rad = error_of(problem, truth, times);
        choice.reached = choice.attitude_rad <= attitude_tolerance_rad;
        return choice;
    }
    const std::vector<MethodChoice> rungs = ladder(problem, method, most_steps, finest_tolerance);
    choice.reached = false;
    for (std::size_t i = 0; i < rungs.size() && !choice.reached; ++i) {
        if (!truth && i + 1 == rungs.size()) break;
        const Motion motion(with(problem, rungs[i]));
        choice.method = rungs[i];
        choice.attitude_rad =
            truth ? worst_errors(motion, *truth, times).attitude_rad
                  : worst_errors(motion, Motion(with(problem, rungs[i + 1])), times).attitude_rad;
        choice.reached = choice.attitude_rad <= attitude_tolerance_rad;
    }
    return choice;
}

}  // namespace poinsot
