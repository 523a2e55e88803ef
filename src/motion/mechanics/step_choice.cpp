#include "mechanics/step_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/methods.h"
#include "mechanics/motion_errors.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

constexpr double finest_tolerance = 5e-14;

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

double span_of(const MotionProblem& problem) {
    return std::max(std::abs(problem.first_time_s), std::abs(problem.last_time_s));
}

// The next finer rung; none after the finest, or if it would take too many steps.
std::optional<MethodChoice> finer_than(const MethodChoice& rung, const MotionProblem& problem,
                                       double most_steps) {
    MethodChoice finer = rung;
    if (rung.step_s) {
        *finer.step_s *= 0.5;
        if (span_of(problem) / *finer.step_s > most_steps) return std::nullopt;
        return finer;
    }
    *finer.tolerance *= 0.1;
    if (!(*finer.tolerance > finest_tolerance)) return std::nullopt;
    return finer;
}

// The steps that an adaptive method took; their number is known only after the integration.
double n_adaptive_steps(const Motion& motion) {
    const IntegratedRotation& stepped = *motion.integrated();
    return stepped.method().takes_step ? 0.0 : static_cast<double>(stepped.counters().n_steps);
}

// The error of a choice with a given step or tolerance: against the exact motion, or else against
// half the step or a tenth of the tolerance. If that tolerance is too small, ten times the
// tolerance is measured against this one: an upper bound.
double error_of(const MotionProblem& problem, const std::optional<Motion>& truth,
                std::span<const double> times, const StopCheck& stop) {
    const auto error = [&](const MotionProblem& coarse, const Motion& fine) {
        return worst_errors(Motion(coarse, stop), fine, times).attitude_rad;
    };
    if (truth) return error(problem, *truth);
    MethodChoice other = problem.method;
    if (other.step_s) *other.step_s *= 0.5;
    if (other.tolerance && *other.tolerance < 10.0 * least_tolerance) {
        *other.tolerance *= 10.0;
        return error(with(problem, other), Motion(problem, stop));
    }
    if (other.tolerance) *other.tolerance *= 0.1;
    return error(problem, Motion(with(problem, other), stop));
}

}  // namespace

MethodChoice coarsest_choice(const MotionProblem& problem) {
    MethodChoice coarsest = problem.method;
    if (find_method(problem.method.name).takes_step) {
        const RotationDynamics dynamics(problem.inertia, problem.torque);
        const Eigen::Vector3d momentum = dynamics.moments_kg_m2().cwiseProduct(
            problem.inertia.body_from_principal().transpose() * problem.start.omega_body);
        const double turn_s =
            2.0 * std::numbers::pi /
            (norm_of(problem.start.omega_body) + dynamics.greatest_friction_turning_rad_s() +
             dynamics.greatest_drag_rate_1_s(momentum, problem.first_time_s, problem.last_time_s));
        coarsest.step_s = std::min(span_of(problem), turn_s / 16.0);
    } else {
        coarsest.tolerance = 1e-4;
    }
    return coarsest;
}

StepChoice choose_step(const MotionProblem& problem, double attitude_tolerance_rad,
                       double most_steps, const StopCheck& stop) {
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
        choice.attitude_rad = error_of(problem, truth, times, stop);
        choice.reached = choice.attitude_rad <= attitude_tolerance_rad;
        return choice;
    }
    constexpr double any_number = std::numeric_limits<double>::infinity();
    choice.method = coarsest_choice(problem);
    Motion motion(with(problem, choice.method), stop);
    // Each rung has half the step or a tenth of the tolerance, and `finer_than` knows the finest.
    while (true) {
        const std::optional<MethodChoice> finer = finer_than(choice.method, problem, most_steps);
        std::optional<Motion> next;  // reference where no exact motion exists
        if (!truth)
            next.emplace(
                with(problem, finer ? *finer : *finer_than(choice.method, problem, any_number)),
                stop);
        choice.attitude_rad = worst_errors(motion, truth ? *truth : *next, times).attitude_rad;
        choice.reached = choice.attitude_rad <= attitude_tolerance_rad;
        const bool ends = !finer || (!truth && !finer_than(*finer, problem, most_steps)) ||
                          n_adaptive_steps(motion) > most_steps;
        if (choice.reached || ends) return choice;
        choice.method = *finer;
        motion = next ? *std::move(next) : Motion(with(problem, *finer), stop);
    }
}

}  // namespace poinsot
