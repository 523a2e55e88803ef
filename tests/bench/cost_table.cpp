// cost_table [NAME]: what the exact motion costs in every regime, and what stepping costs beside
// it: the cheapest method, of our table and of Boost.odeint, that keeps the attitude within 1e-6
// and 1e-12 rad over 100 periods of 60 video frames. With NAME, only the bodies of that name.
// Processor time, medians of five runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <ctime>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "error/error.h"
#include "mechanics/motion.h"

namespace {

using namespace poinsot;
using Eigen::Vector3d;

struct Case {
    const char* name;
    Vector3d moments;
    Vector3d omega;
};

const std::array<Case, 8> regimes{{
    {"permanent", {1.0, 2.0, 3.0}, {0.0, 0.0, 1.5}},
    {"symmetric", {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
    {"elliptic, about the highest", {1.0, 2.0, 3.0}, {0.1, 0.2, 1.0}},
    {"elliptic, about the lowest", {1.0, 2.0, 3.0}, {1.0, 0.2, 0.1}},
    {"elliptic, imaginary series", {1.0, 2.0, 3.0}, {0.3, 1.0, 0.2}},
    {"near the separatrix, 1e-8", {1.0, 2.0, 3.0}, {1e-8, 1.0, 1e-8}},
    {"near the separatrix, 1e-150", {1.0, 2.0, 3.0}, {1e-150, 1.0, 1e-150}},
    {"separatrix", {1.0, 2.0, 2.25}, {0.75, 0.5, 1.0}},
}};

const std::array<Case, 4> spans{{
    {"generic", {1.0, 2.0, 2.9}, {1.5, 0.3, 0.75}},
    {"near the separatrix", {1.0, 2.0, 3.0}, {1e-3, 1.0, 1e-3}},
    {"symmetric", {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
    {"mild", {2.0, 2.2, 2.5}, {0.3, 0.2, 1.0}},
}};

// What keeps the compiler from leaving work out.
volatile double sink = 0.0;

double cpu_ns() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

double median_ns(const std::function<void()>& work) {
    std::array<double, 5> runs{};
    for (double& run : runs) {
        const double before = cpu_ns();
        work();
        run = cpu_ns() - before;
    }
    std::nth_element(runs.begin(), runs.begin() + 2, runs.end());
    return runs[2];
}

MotionProblem problem_of(const Case& c, Tier tier = Tier::exact) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(c.moments);
    problem.start.omega_body = c.omega;
    problem.tier = tier;
    return problem;
}

double ns_an_evaluation(const Case& c, Tier tier, Quantities wanted, double from_s) {
    const Motion motion(problem_of(c, tier));
    constexpr int n = 50'000;
    return median_ns([&] {
               double sum = 0.0;
               for (int k = 0; k < n; ++k) {
                   const MotionSample sample = motion.sample(from_s + k / 60.0, wanted);
                   sum += sample.state.omega_body[0] + sample.state.space_from_body.w() +
                          sample.herpolhode_space[0];
               }
               sink = sum;
           }) /
           n;
}

void print_regimes() {
    const Quantities all{.attitude = true, .herpolhode = true, .euler_angles = false};
    const Quantities omega{.attitude = false, .herpolhode = false, .euler_angles = false};
    fmt::print("ns an evaluation of omega, attitude and herpolhode, from t = 0\n");
    fmt::print("{:<32}{:>8}{:>12}{:>8}{:>14}\n", "regime", "exact", "t = 1e12 s", "fast",
               "omega alone");
    for (const Case& c : regimes) {
        fmt::print("{:<32}{:>8.0f}{:>12.0f}{:>8.0f}{:>14.0f}\n", c.name,
                   ns_an_evaluation(c, Tier::exact, all, 0.0),
                   ns_an_evaluation(c, Tier::exact, all, 1e12),
                   ns_an_evaluation(c, Tier::fast, all, 0.0),
                   ns_an_evaluation(c, Tier::exact, omega, 0.0));
        std::fflush(stdout);
    }
}

// A way to compute the attitude at all times, at the n-th rung of its ladder; empty past its end.
using Attitudes = std::vector<Eigen::Vector4d>;
struct Runner {
    std::string name;
    std::function<std::optional<std::string>(int rung)> setting;
    std::function<Attitudes(int rung)> run;
};

std::vector<double> frame_times(const Case& c) {
    const double period = *Motion(problem_of(c)).free_rotation()->constants().polhode_period_s;
    std::vector<double> times;
    for (int k = 0; k <= 6000; ++k) times.push_back(k * period / 60.0);
    return times;
}

Attitudes attitudes_of(const Motion& motion, const std::vector<double>& times) {
    Attitudes attitudes;
    attitudes.reserve(times.size());
    for (const double t : times) attitudes.push_back(motion.at(t).space_from_body.coeffs());
    return attitudes;
}

Runner runner_of(const Case& c, const std::vector<double>& times, const Method& method, int order) {
    const auto problem_at = [=, &method](int rung) {
        MotionProblem problem = problem_of(c);
        problem.last_time_s = times.back();
        problem.method.name = std::string(method.name);
        if (order > 0) problem.method.order = order;
        if (method.takes_step) problem.method.step_s = times[60] / 8.0 * std::exp2(-0.5 * rung);
        if (method.takes_tolerance) problem.method.tolerance = 1e-3 * std::pow(10.0, -0.5 * rung);
        return problem;
    };
    Runner runner;
    runner.name = order > 0 ? fmt::format("{}-{}", method.name, order) : std::string(method.name);
    runner.setting = [=, &method](int rung) -> std::optional<std::string> {
        const MethodChoice choice = problem_at(rung).method;
        if (method.takes_tolerance && *choice.tolerance < least_tolerance) return std::nullopt;
        return method.takes_step ? fmt::format("step {:.3g} s", *choice.step_s)
                                 : fmt::format("tolerance {:.0e}", *choice.tolerance);
    };
    runner.run = [=](int rung) { return attitudes_of(Motion(problem_at(rung)), times); };
    return runner;
}

// ω in body axes and the attitude (x, y, z, w), with their rates: what a user of Boost.odeint
// writes.
using Numbers = std::array<double, 7>;
struct Equations {
    Vector3d I;
    void operator()(const Numbers& x, Numbers& rate, double /*time_s*/) const {
        rate[0] = (I[1] - I[2]) / I[0] * x[1] * x[2];
        rate[1] = (I[2] - I[0]) / I[1] * x[2] * x[0];
        rate[2] = (I[0] - I[1]) / I[2] * x[0] * x[1];
        rate[3] = 0.5 * (x[6] * x[0] + x[4] * x[2] - x[5] * x[1]);
        rate[4] = 0.5 * (x[6] * x[1] + x[5] * x[0] - x[3] * x[2]);
        rate[5] = 0.5 * (x[6] * x[2] + x[3] * x[1] - x[4] * x[0]);
        rate[6] = -0.5 * (x[3] * x[0] + x[4] * x[1] + x[5] * x[2]);
    }
};
Numbers start_of(const Case& c) { return {c.omega[0], c.omega[1], c.omega[2], 0.0, 0.0, 0.0, 1.0}; }
Eigen::Vector4d attitude_of(const Numbers& x) { return {x[3], x[4], x[5], x[6]}; }

Runner odeint_dopri5(const Case& c, const std::vector<double>& times) {
    const auto tolerance = [](int rung) { return 1e-4 * std::pow(10.0, -0.5 * rung); };
    Runner runner;
    runner.name = "Boost.odeint dopri5";
    runner.setting = [=](int rung) -> std::optional<std::string> {
        if (tolerance(rung) < 1e-15) return std::nullopt;
        return fmt::format("tolerance {:.0e}", tolerance(rung));
    };
    runner.run = [=](int rung) {
        namespace odeint = boost::numeric::odeint;
        auto stepper = odeint::make_dense_output(tolerance(rung), tolerance(rung),
                                                 odeint::runge_kutta_dopri5<Numbers>());
        Numbers x = start_of(c);
        stepper.initialize(x, 0.0, times[1]);
        Attitudes attitudes{attitude_of(x)};
        attitudes.reserve(times.size());
        for (std::size_t k = 1; k < times.size(); ++k) {
            while (stepper.current_time() < times[k]) stepper.do_step(Equations{c.moments});
            stepper.calc_state(times[k], x);
            attitudes.push_back(attitude_of(x));
        }
        return attitudes;
    };
    return runner;
}

Runner odeint_rk4(const Case& c, const std::vector<double>& times) {
    Runner runner;
    runner.name = "Boost.odeint rk4";
    runner.setting = [](int rung) { return fmt::format("{} steps a frame", rung + 1); };
    runner.run = [=](int rung) {
        boost::numeric::odeint::runge_kutta4<Numbers> stepper;
        Numbers x = start_of(c);
        const int n_steps = rung + 1;
        Attitudes attitudes{attitude_of(x)};
        attitudes.reserve(times.size());
        for (std::size_t k = 1; k < times.size(); ++k) {
            const double step_s = (times[k] - times[k - 1]) / n_steps;
            for (int n = 0; n < n_steps; ++n) {
                stepper.do_step(Equations{c.moments}, x, times[k - 1] + n * step_s, step_s);
            }
            attitudes.push_back(attitude_of(x));
        }
        return attitudes;
    };
    return runner;
}

// The largest angle between two attitudes, in rad.
double worst_error(const Attitudes& a, const Attitudes& b) {
    double worst = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double apart = 2.0 * std::min((a[k] - b[k]).norm(), (a[k] + b[k]).norm());
        worst = std::isfinite(apart) ? std::max(worst, apart) : INFINITY;
    }
    return worst;
}

// The coarsest rung that meets the target, with its cost a frame; or, where no rung does within
// 0.3 s of processor time, the least error found.
struct Found {
    bool reached = false;
    std::string setting;
    double ns = 0.0;
    double error_rad = INFINITY;
};
Found coarsest(const Runner& runner, const Attitudes& truth, double target) {
    constexpr double longest_run_ns = 3e8;
    Found best;
    for (int rung = 0; rung < 64; ++rung) {
        const auto setting = runner.setting(rung);
        if (!setting) break;
        const double before = cpu_ns();
        double error_rad = INFINITY;
        try {
            error_rad = worst_error(runner.run(rung), truth);
        } catch (const InputError&) {
            // A step that an implicit method finds no solution for, or that blows up.
        }
        if (error_rad <= target) {
            const double ns = median_ns([&] { sink = runner.run(rung).back()[0]; });
            return {true, *setting, ns / static_cast<double>(truth.size()), error_rad};
        }
        best.error_rad = std::min(best.error_rad, error_rad);
        if (cpu_ns() - before > longest_run_ns) break;
    }
    return best;
}

void print_span(const Case& c) {
    const std::vector<double> times = frame_times(c);
    const Motion exact(problem_of(c));
    const Attitudes truth = attitudes_of(exact, times);
    const double exact_ns = median_ns([&] {
                                const Motion motion(problem_of(c));
                                sink = attitudes_of(motion, times).back()[0];
                            }) /
                            static_cast<double>(times.size());
    fmt::print("\n{}: 6000 frames over 100 periods of {:.3g} s; exact {:.0f} ns a frame\n", c.name,
               times[60], exact_ns);

    std::vector<Runner> runners{odeint_dopri5(c, times), odeint_rk4(c, times)};
    for (const Method& method : methods()) {
        if (method.make == nullptr) continue;
        for (const int order : method.orders) {
            runners.push_back(runner_of(c, times, method, method.orders.size() > 1 ? order : 0));
        }
    }
    for (const double target : {1e-6, 1e-12}) {
        fmt::print("  within {:.0e} rad\n", target);
        double cheapest_ns = INFINITY;
        std::string cheapest = "no method";
        for (const Runner& runner : runners) {
            const Found found = coarsest(runner, truth, target);
            if (!found.reached) {
                fmt::print("    {:<22}does not reach it; least error {:.1e}\n", runner.name,
                           found.error_rad);
            } else {
                fmt::print("    {:<22}{:<20}{:>9.0f} ns{:>9.1f} times exact, error {:.1e}\n",
                           runner.name, found.setting, found.ns, found.ns / exact_ns,
                           found.error_rad);
                if (found.ns < cheapest_ns) cheapest_ns = found.ns, cheapest = runner.name;
            }
            std::fflush(stdout);
        }
        if (std::isfinite(cheapest_ns)) {
            fmt::print("    cheapest: {}; exact costs {:.2f} of it\n", cheapest,
                       exact_ns / cheapest_ns);
        } else {
            fmt::print("    no method reaches it within 0.3 s\n");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string wanted = argc > 1 ? argv[1] : "";
    if (wanted.empty()) print_regimes();
    for (const Case& c : spans) {
        if (wanted.empty() || wanted == c.name) print_span(c);
    }
    return 0;
}
