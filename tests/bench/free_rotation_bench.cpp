// What an instant of the exact free motion costs in every regime, near the start and 1e12 s away,
// and how Boost.odeint and RK4 compare over 100 periods of 60 video frames.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <chrono>
#include <numbers>
#include <string>
#include <vector>

#include "mechanics/free_rotation.h"

namespace {

using namespace poinsot;
using Eigen::Vector3d;

struct Case {
    const char* name;
    Vector3d moments;
    Vector3d omega;
};

const std::array<Case, 8> cases{{
    {"permanent", {1.0, 2.0, 3.0}, {0.0, 0.0, 1.5}},
    {"symmetric", {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
    {"elliptic_about_highest", {1.0, 2.0, 3.0}, {0.1, 0.2, 1.0}},
    {"elliptic_about_lowest", {1.0, 2.0, 3.0}, {1.0, 0.2, 0.1}},
    {"hyperbolic_series", {1.0, 2.0, 3.0}, {0.3, 1.0, 0.2}},
    {"near_separatrix_1e-8", {1.0, 2.0, 3.0}, {1e-8, 1.0, 1e-8}},
    {"near_separatrix_1e-150", {1.0, 2.0, 3.0}, {1e-150, 1.0, 1e-150}},
    {"separatrix", {1.0, 2.0, 2.25}, {0.75, 0.5, 1.0}},
}};

FreeRotation motion_of(const Case& c, Tier tier = Tier::exact) {
    RotationState start;
    start.omega_body = c.omega;
    return {InertiaTensor::from_principal_moments(c.moments), start, tier};
}

void evaluate(benchmark::State& state, const Case& c, Tier tier, Quantities wanted, double from) {
    const FreeRotation motion = motion_of(c, tier);
    double t = from;
    for (auto unused : state) {
        benchmark::DoNotOptimize(motion.sample(t, wanted));
        t += 1.0 / 60.0;
    }
}

void set_up(benchmark::State& state, const Case& c) {
    for (auto unused : state) benchmark::DoNotOptimize(motion_of(c));
}

// ω in body axes and the attitude (w, x, y, z), with their rates.
using Phase = std::array<double, 7>;
struct Equations {
    Vector3d I;
    void operator()(const Phase& x, Phase& rate, double /*time_s*/) const {
        rate[0] = (I[1] - I[2]) / I[0] * x[1] * x[2];
        rate[1] = (I[2] - I[0]) / I[1] * x[2] * x[0];
        rate[2] = (I[0] - I[1]) / I[2] * x[0] * x[1];
        rate[3] = -0.5 * (x[4] * x[0] + x[5] * x[1] + x[6] * x[2]);
        rate[4] = 0.5 * (x[3] * x[0] + x[5] * x[2] - x[6] * x[1]);
        rate[5] = 0.5 * (x[3] * x[1] + x[6] * x[0] - x[4] * x[2]);
        rate[6] = 0.5 * (x[3] * x[2] + x[4] * x[1] - x[5] * x[0]);
    }
};

std::vector<double> frame_times(const Case& c) {
    const double period = motion_of(c).constants().polhode_period_s.value_or(
        20.0 * std::numbers::pi / c.omega.norm());
    std::vector<double> times;
    for (int k = 0; k <= 6000; ++k) times.push_back(k * period / 60.0);
    return times;
}

// Nanoseconds an instant of the exact motion at the same times: the median of nine runs.
double exact_ns(const Case& c, const std::vector<double>& times) {
    std::array<double, 9> runs{};
    for (double& run : runs) {
        const auto before = std::chrono::steady_clock::now();
        const FreeRotation motion = motion_of(c);
        for (const double t : times) benchmark::DoNotOptimize(motion.at(t));
        const std::chrono::duration<double, std::nano> taken =
            std::chrono::steady_clock::now() - before;
        run = taken.count() / static_cast<double>(times.size());
    }
    std::nth_element(runs.begin(), runs.begin() + 4, runs.end());
    return runs[4];
}

double attitude_error(const Case& c, const Phase& x, double time_s) {
    const Eigen::Vector4d exact = motion_of(c).at(time_s).space_from_body.coeffs();
    const Eigen::Vector4d stepped(x[4], x[5], x[6], x[3]);
    return 2.0 * std::min((exact - stepped).norm(), (exact + stepped).norm());
}

// Runs a stepper through all the frames and reports its cost beside the exact motion's.
template <class Run>
void over_100_periods(benchmark::State& state, const Case& c, const Run& run) {
    const std::vector<double> times = frame_times(c);
    const Phase start{c.omega[0], c.omega[1], c.omega[2], 1.0, 0.0, 0.0, 0.0};
    Phase end{};
    double ns = 0.0;
    for (auto unused : state) {
        const auto before = std::chrono::steady_clock::now();
        end = run(start, times);
        const std::chrono::duration<double, std::nano> taken =
            std::chrono::steady_clock::now() - before;
        state.SetIterationTime(1e-9 * taken.count());
        ns += taken.count();
    }
    const double per_frame =
        ns / static_cast<double>(state.iterations()) / static_cast<double>(times.size());
    state.counters["ns_per_frame"] = per_frame;
    state.counters["over_exact"] = per_frame / exact_ns(c, times);
    state.counters["error_rad"] = attitude_error(c, end, times.back());
}

void odeint_dopri5(benchmark::State& state, const Case& c, double tolerance) {
    namespace odeint = boost::numeric::odeint;
    over_100_periods(state, c, [&](const Phase& start, const std::vector<double>& times) {
        auto stepper =
            odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<Phase>());
        stepper.initialize(start, 0.0, times[1]);
        Phase x = start;
        for (const double t : times) {
            while (stepper.current_time() < t) stepper.do_step(Equations{c.moments});
            if (t > 0.0) stepper.calc_state(t, x);
            benchmark::DoNotOptimize(x);
        }
        return x;
    });
}

void rk4(benchmark::State& state, const Case& c, int steps_a_frame) {
    over_100_periods(state, c, [&](const Phase& start, const std::vector<double>& times) {
        boost::numeric::odeint::runge_kutta4<Phase> stepper;
        Phase x = start;
        for (std::size_t k = 1; k < times.size(); ++k) {
            const double step = (times[k] - times[k - 1]) / steps_a_frame;
            for (int n = 0; n < steps_a_frame; ++n) {
                stepper.do_step(Equations{c.moments}, x, times[k - 1] + n * step, step);
            }
            benchmark::DoNotOptimize(x);
        }
        return x;
    });
}

const bool registered = [] {
    const Quantities all{.attitude = true, .herpolhode = true, .euler_angles = false};
    const Quantities attitude{.attitude = true, .herpolhode = false, .euler_angles = false};
    const Quantities omega{.attitude = false, .herpolhode = false, .euler_angles = false};
    for (const Case& c : cases) {
        const std::string name = std::string("free/") + c.name;
        const auto add = [&](const std::string& what, Tier tier, Quantities wanted, double from) {
            benchmark::RegisterBenchmark((name + what).c_str(), evaluate, c, tier, wanted, from);
        };
        add("/exact", Tier::exact, all, 0.0);
        add("/exact_at_1e12_s", Tier::exact, all, 1e12);
        add("/exact_without_herpolhode", Tier::exact, attitude, 0.0);
        add("/exact_omega_alone", Tier::exact, omega, 0.0);
        add("/fast", Tier::fast, all, 0.0);
        benchmark::RegisterBenchmark((name + "/setup").c_str(), set_up, c);
    }
    for (const Case& c : cases) {
        const std::string name = std::string("span/") + c.name;
        for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
            char digits[16];
            std::snprintf(digits, sizeof digits, "%.0e", tolerance);
            benchmark::RegisterBenchmark((name + "/odeint_dopri5_" + digits).c_str(), odeint_dopri5,
                                         c, tolerance)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
        for (const int steps : {1, 16}) {
            benchmark::RegisterBenchmark(
                (name + "/rk4_" + std::to_string(steps) + "_a_frame").c_str(), rk4, c, steps)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
    return true;
}();

}  // namespace
