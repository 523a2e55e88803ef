#include "mechanics/stepped/integrated_rotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "error/error.h"
#include "mechanics/euler_angles.h"

namespace poinsot {

namespace {

constexpr double steps_a_turn = 200.0;

// The default step: a 200th of the shortest turn that the motion can make within the span.
double default_step_s(const RotationDynamics& dynamics, const Eigen::Vector3d& momentum,
                      double span_s, double drag_rate_1_s) {
    const double torque = dynamics.greatest_torque_N_m();
    const double least_moment = dynamics.moments_kg_m2().minCoeff();
    // A pendulum's rate under gravity; under a constant torque the rate that the body can reach.
    const bool swings = has_weight(dynamics.torque());
    const double gained =
        swings ? 2.0 * std::sqrt(torque / least_moment) : torque * span_s / least_moment;
    const double rate = dynamics.greatest_free_omega(momentum) + gained +
                        dynamics.greatest_friction_turning_rad_s() + drag_rate_1_s;
    const double step = 2.0 * std::numbers::pi / (steps_a_turn * rate);
    return std::isfinite(step) && step < span_s ? step : span_s;
}

void require_finite(const RotationState& start) {
    if (!start.omega_body.allFinite()) {
        throw InputError("the angular velocity at the start is not finite; give finite numbers");
    }
    const Eigen::Vector4d& q = start.space_from_body.coeffs();
    if (!q.allFinite() || q.isZero(0.0)) {
        throw InputError(
            "the attitude at the start is not a rotation; give a quaternion other than "
            "zero");
    }
}

}  // namespace

MethodStart IntegratedRotation::prepare(const MotionProblem& problem) {
    method_ = &check_method(problem.method, problem.inertia, problem.torque);
    inertia_ = problem.inertia;
    start_time_s_ = problem.start.time_s;
    first_time_s_ = std::min(problem.first_time_s, problem.start.time_s);
    last_time_s_ = std::max(problem.last_time_s, problem.start.time_s);
    overshoot_s_ = problem.overshoot_s;
    if (method_->make == nullptr) {
        throw InputError("method \"exact\" does not step; name a method that does");
    }
    require_finite(problem.start);
    const double span_s = last_time_s_ - first_time_s_;
    if (!std::isfinite(span_s)) {
        throw InputError("the time span of a stepped motion must be finite");
    }

    MethodStart start{.dynamics = RotationDynamics(problem.inertia, problem.torque),
                      .state = {},
                      .order = problem.method.order.value_or(method_->orders.back()),
                      .step_s = 0.0,
                      .tolerance = problem.method.tolerance.value_or(default_tolerance)};
    const Eigen::Matrix3d& body_from_principal = inertia_.body_from_principal();
    const Eigen::Vector3d omega = body_from_principal.transpose() * problem.start.omega_body;
    start.state.momentum = omega.cwiseProduct(inertia_.moments_kg_m2());
    start.state.space_from_principal = problem.start.space_from_body.normalized();
    if (!inertia_.body_axes_are_principal()) {
        start.state.space_from_principal =
            (start.state.space_from_principal * Eigen::Quaterniond(body_from_principal))
                .normalized();
    }

    start.state.time_s = problem.start.time_s;
    const double drag_rate_1_s = start.dynamics.greatest_drag_rate_1_s(
        start.state.momentum, first_time_s_, last_time_s_ + overshoot_s_);
    if (!std::isfinite(drag_rate_1_s))
        throw InputError(
            "the rates of the drag leave the range of double-precision numbers; give smaller rates "
            "or a smaller growth");

    step_s_ = problem.method.step_s.value_or(
        default_step_s(start.dynamics, start.state.momentum, span_s, drag_rate_1_s));
    if (problem.method.step_s && span_s > 0.0 && step_s_ > span_s) {
        throw InputError(
            fmt::format("step_s is {} s, longer than the {} s to be covered; give a shorter one",
                        step_s_, span_s));
    }
    // Friction that turns the body farther in a step is not followed by it: explicit methods are
    // unstable then, and T between the ends of a step would not fall steadily.
    const double friction_rad = step_s_ * start.dynamics.greatest_friction_turning_rad_s();
    if (method_->takes_step && span_s > 0.0 && !(friction_rad <= 1.0)) {
        throw InputError(fmt::format(
            "friction turns the body by {:.3g} rad in a step of {} s, and by 1 rad at most it can "
            "be stepped; give a step_s of at most {:.3g} s",
            friction_rad, step_s_, step_s_ / friction_rad));
    }

    // Nor is drag followed that slows the body by more than its speed in a step.
    const double slowed = step_s_ * drag_rate_1_s;
    if (method_->takes_step && span_s > 0.0 && !(slowed <= 1.0)) {
        throw InputError(fmt::format(
            "the drag slows the body by {:.3g} of its speed in a step of {} s, and by 1 at most it "
            "can be stepped; give a step_s of at most {:.3g} s",
            slowed, step_s_, step_s_ / slowed));
    }

    start.step_s = step_s_;
    return start;
}

IntegratedRotation::IntegratedRotation(const MotionProblem& problem, const StopCheck& stop) {
    MethodStart start = prepare(problem);
    const double span_s = last_time_s_ - first_time_s_;
    if (method_->takes_step && span_s / step_s_ > max_steps) {
        throw InputError(
            fmt::format("step_s of {} s needs {:.3g} steps for {} s; give at least {} s", step_s_,
                        span_s / step_s_, span_s, span_s / max_steps));
    }
    // The steps beyond the end are also computed only once, not for each instant there.
    cover(forward_, start, last_time_s_ + overshoot_s_ - start_time_s_, stop);
    start.step_s = -step_s_;
    cover(backward_, start, first_time_s_ - start_time_s_, stop);
}

SteppingProbe IntegratedRotation::probe(const MotionProblem& problem, std::int64_t most_steps) {
    IntegratedRotation motion;
    MethodStart start = motion.prepare(problem);
    const double after_s = motion.last_time_s_ + motion.overshoot_s_ - motion.start_time_s_;
    const double before_s = motion.start_time_s_ - motion.first_time_s_;
    const double length_s = std::max(after_s, before_s);
    if (before_s > after_s) start.step_s = -start.step_s;
    const Propagator propagator = motion.method_->make(start);
    StepNode node;
    node.step_s = start.step_s;
    node.state = start.state;
    SteppingProbe probe;
    while (probe.n_steps < most_steps && std::abs(node.time_s) < length_s) {
        node = motion.advanced(propagator, node);
        ++probe.n_steps;
    }
    probe.share = length_s > 0.0 ? std::min(1.0, std::abs(node.time_s) / length_s) : 1.0;
    return probe;
}

// NaN does not advance.
void IntegratedRotation::require_advance(const StepNode& node, const StepNode& next) const {
    if (std::abs(next.time_s) > std::abs(node.time_s)) return;
    throw InputError(
        fmt::format("method \"{}\" needs steps so short that the time of {} s does not advance; "
                    "give a slower motion, weaker torque or larger tolerance",
                    method_->name, start_time_s_ + node.time_s));
}

StepNode IntegratedRotation::advanced(const Propagator& propagator, const StepNode& node) {
    StepNode next = propagator.next(node, counters_);
    require_advance(node, next);
    if (!next.state.momentum.allFinite()) {
        throw InputError(fmt::format(
            "method \"{}\" overflows at t = {} s with a step of {} s; give {}", method_->name,
            start_time_s_ + next.time_s, std::abs(node.step_s),
            method_->takes_step ? "a shorter one" : "a slower motion or a weaker torque"));
    }
    return next;
}

// Steps to the end and stores every stride-th state; if there are too many, every second one is
// dropped.
void IntegratedRotation::cover(Branch& branch, const MethodStart& start, double end_s,
                               const StopCheck& stop) {
    branch.propagator = method_->make(start);
    StepNode node;
    node.step_s = start.step_s;
    node.state = start.state;
    // Reserves all memory at once, which costs nothing until it is written to; in a growing vector
    // the system would clear twice the memory, in every run.
    constexpr auto most = static_cast<double>(max_kept_states);
    const double n_expected = end_s == 0.0          ? 1.0
                              : method_->takes_step ? end_s / start.step_s + 2.0
                                                    : most;
    branch.kept.reserve(static_cast<std::size_t>(std::min(n_expected, most)));
    branch.kept.push_back(node);
    std::int64_t stride = 1;
    while (std::abs(node.time_s) < std::abs(end_s)) {
        node = advanced(branch.propagator, node);
        constexpr std::int64_t steps_between_looks = 1024;
        if (node.index % steps_between_looks == 0 && stop && stop())
            throw InputError(
                fmt::format("stepping by {} had come to t = {:g} s when its time was over; give a "
                            "larger step or "
                            "tolerance, a shorter film, or method = \"exact\"",
                            method_->name, start_time_s_ + node.time_s));
        if (static_cast<double>(node.index) > max_steps) {
            throw InputError(
                fmt::format("method \"{}\" needs more than {:.0e} steps; shorten the "
                            "time span or give a larger tolerance",
                            method_->name, max_steps));
        }
        if (node.index % stride != 0) continue;
        if (branch.kept.size() == max_kept_states) {
            stride *= 2;
            for (std::size_t i = 0; 2 * i < branch.kept.size(); ++i) {
                branch.kept[i] = branch.kept[2 * i];
            }
            branch.kept.resize((branch.kept.size() + 1) / 2);
            if (node.index % stride != 0) continue;
        }
        branch.kept.push_back(node);
    }
}

RotationState IntegratedRotation::at(double time_s, StepCounters& counters) const {
    // A frame's time may exceed the span by the rounding of k/fps.
    const double slack = 1e-9 * (last_time_s_ - first_time_s_);
    if (!(time_s >= first_time_s_ - slack && time_s <= last_time_s_ + overshoot_s_ + slack)) {
        throw InputError(
            fmt::format("t = {} s lies outside the {} s to {} s that method \"{}\" has "
                        "stepped through",
                        time_s, first_time_s_, last_time_s_, method_->name));
    }
    const double elapsed_s = time_s - start_time_s_;
    const Branch& branch = elapsed_s < 0.0 ? backward_ : forward_;
    const double distance = std::abs(elapsed_s);
    const auto after = std::upper_bound(
        branch.kept.begin(), branch.kept.end(), distance,
        [](double wanted, const StepNode& node) { return wanted < std::abs(node.time_s); });
    StepNode node = *std::prev(after);
    while (true) {
        // The end of a fixed step is known without taking the step.
        if (method_->takes_step &&
            std::abs(static_cast<double>(node.index + 1) * step_s_) > distance) {
            break;
        }
        if (std::abs(node.time_s) == distance) break;
        const StepNode next = branch.propagator.next(node, counters);
        if (std::abs(next.time_s) > distance) break;
        require_advance(node, next);
        node = next;
    }
    const StepState found = branch.propagator.within(node, elapsed_s, counters);

    RotationState state;
    state.time_s = time_s;
    const Eigen::Vector3d omega = found.momentum.cwiseQuotient(inertia_.moments_kg_m2());
    if (inertia_.body_axes_are_principal()) {
        state.space_from_body = found.space_from_principal;
        state.omega_body = omega;
    } else {
        const Eigen::Matrix3d& body_from_principal = inertia_.body_from_principal();
        state.space_from_body =
            found.space_from_principal * Eigen::Quaterniond(body_from_principal).conjugate();
        state.omega_body = body_from_principal * omega;
    }
    return state;
}

RotationState IntegratedRotation::at(double time_s) const {
    StepCounters unused;
    return at(time_s, unused);
}

MotionSample IntegratedRotation::sample(double time_s, Quantities wanted) const {
    MotionSample sample;
    sample.state = at(time_s);
    const Eigen::Quaterniond attitude = sample.state.space_from_body;
    if (wanted.herpolhode) {
        const Eigen::Vector3d momentum = inertia_.matrix_body() * sample.state.omega_body;
        sample.herpolhode_space =
            attitude * omega_across_momentum(momentum, sample.state.omega_body);
    }
    if (wanted.euler_angles) sample.euler = euler_angles_of(attitude);
    if (!wanted.attitude) sample.state.space_from_body = Eigen::Quaterniond::Identity();
    return sample;
}

}  // namespace poinsot
