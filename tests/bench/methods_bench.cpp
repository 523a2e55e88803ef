// The cost of the methods: a step of each, an evaluation of the heavy top, and a video frame at a
// given accuracy over 100 periods, compared with the exact motion.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mechanics/motion.h"
#include "mechanics/stepped/integrated_rotation.h"
#include "mechanics/top/heavy_top.h"

namespace {

using namespace poinsot;

// A flipping motion, of moments (1,2,3) near the middle axis, or a mild one.
MotionProblem body(bool flipping) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(
        flipping ? Eigen::Vector3d(1.0, 2.0, 3.0) : Eigen::Vector3d(2.0, 2.2, 2.5));
    problem.start.omega_body =
        flipping ? Eigen::Vector3d(0.1, 1.0, 0.1) : Eigen::Vector3d(0.3, 0.2, 1.0);
    return problem;
}

constexpr int n_periods = 100;
constexpr int frames_a_period = 60;

std::vector<double> frame_times(const MotionProblem& problem) {
    const double period =
        FreeRotation(problem.inertia, problem.start).constants().polhode_period_s.value();
    std::vector<double> times;
    for (int k = 0; k <= n_periods * frames_a_period; ++k) {
        times.push_back(k * period / frames_a_period);
    }
    return times;
}

double worst_attitude_error(const MotionProblem& problem, const std::vector<double>& times) {
    const IntegratedRotation stepped(problem);
    MotionProblem exact_problem = problem;
    exact_problem.method = {};
    const Motion exact(exact_problem);
    double worst = 0.0;
    for (std::size_t k = 0; k < times.size(); k += 10) {
        const Eigen::Vector4d a = stepped.at(times[k]).space_from_body.coeffs();
        const Eigen::Vector4d b = exact.at(times[k]).space_from_body.coeffs();
        worst = std::max(worst, 2.0 * std::min((a - b).norm(), (a + b).norm()));
    }
    return worst;
}

// The coarsest setting of a ladder that meets the target; false if none does within the ladder.
bool choose_setting(MotionProblem& problem, const Method& method, double target,
                    const std::vector<double>& times) {
    problem.last_time_s = times.back();
    problem.method.name = std::string(method.name);
    const double period = times[frames_a_period];
    constexpr int n_rungs = 20;
    for (int rung = 0; rung < n_rungs; ++rung) {
        if (method.takes_step) {
            problem.method.step_s = period / 16.0 * std::pow(2.0, -0.5 * rung);
        } else {
            const double tolerance = std::pow(10.0, -3.0 - 0.55 * rung);
            if (tolerance < least_tolerance) return false;
            problem.method.tolerance = tolerance;
        }
        try {
            if (worst_attitude_error(problem, times) <= target) return true;
        } catch (const std::exception&) {
            continue;  // too long a step for an implicit method
        }
    }
    return false;
}

void frame_by_method(benchmark::State& state, const Method& method, bool flipping, double target) {
    MotionProblem problem = body(flipping);
    const std::vector<double> times = frame_times(problem);
    if (method.make != nullptr && !choose_setting(problem, method, target, times)) {
        state.SkipWithError("does not reach this accuracy");
        return;
    }
    for (auto unused : state) {
        const Motion motion(problem);
        for (const double t : times) benchmark::DoNotOptimize(motion.at(t));
    }
    const auto n_frames = static_cast<double>(times.size());
    state.counters["per_frame"] = benchmark::Counter(
        n_frames, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    if (problem.method.step_s) state.counters["step_s"] = *problem.method.step_s;
    if (problem.method.tolerance) state.counters["tolerance"] = *problem.method.tolerance;
}

void one_step(benchmark::State& state, const Method& method) {
    const MotionProblem problem = body(true);
    MethodStart start{.dynamics = RotationDynamics(problem.inertia, problem.torque),
                      .state = {},
                      .order = method.orders.back(),
                      .step_s = 0.05,
                      .tolerance = default_tolerance};
    start.state.momentum = problem.start.omega_body.cwiseProduct(problem.inertia.moments_kg_m2());
    const Propagator propagator = method.make(start);
    StepNode node;
    node.step_s = start.step_s;
    node.state = start.state;
    StepCounters counters;
    for (auto unused : state) {
        node = propagator.next(node, counters);
        benchmark::DoNotOptimize(node);
    }
}

const HeavyTopProblem wavy{.moment_axial_kg_m2 = 0.5,
                           .mgl_N_m = 1.0,
                           .theta_rad = 0.7,
                           .phi_dot_rad_s = 0.35,
                           .omega3_rad_s = 8.0};
const HeavyTopProblem near_vertical{.moment_axial_kg_m2 = 0.5,
                                    .mgl_N_m = 1.0,
                                    .theta_rad = 1e-6,
                                    .phi_dot_rad_s = 2.0,
                                    .omega3_rad_s = 2.5};

void heavy_top_at(benchmark::State& state, const HeavyTopProblem& problem) {
    const HeavyTop top(problem);
    double t = 0.0;
    for (auto unused : state) {
        benchmark::DoNotOptimize(top.at(t));
        t += 0.037;
    }
}

void heavy_top_setup(benchmark::State& state) {
    for (auto unused : state) benchmark::DoNotOptimize(HeavyTop(wavy));
}

const bool registered = [] {
    benchmark::RegisterBenchmark("heavy_top/setup", heavy_top_setup);
    benchmark::RegisterBenchmark("heavy_top/at/wavy", heavy_top_at, wavy);
    benchmark::RegisterBenchmark("heavy_top/at/near_vertical", heavy_top_at, near_vertical);
    for (const Method& method : methods()) {
        if (method.make != nullptr) {
            const std::string name = "step/" + std::string(method.name);
            benchmark::RegisterBenchmark(name.c_str(), one_step, method);
        }
    }
    for (const bool flipping : {true, false}) {
        for (const double target : {1e-3, 1e-6, 1e-9, 1e-12}) {
            for (const Method& method : methods()) {
                char digits[16];
                std::snprintf(digits, sizeof digits, "%.0e", target);
                const std::string name = std::string("frame/") +
                                         (flipping ? "flipping/" : "mild/") + digits + "/" +
                                         std::string(method.name);
                benchmark::RegisterBenchmark(name.c_str(), frame_by_method, method, flipping,
                                             target)
                    ->Unit(benchmark::kMillisecond);
            }
        }
    }
    return true;
}();

}  // namespace
