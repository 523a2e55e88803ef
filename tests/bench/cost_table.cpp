// cost_table [NAME]: the cost of the exact motion in every regime, compared with stepping: the
// cheapest method, of ours and of Boost.odeint, that keeps the attitude within 1e-6 and 1e-12 rad
// over 100 periods of 60 video frames. With NAME, only the bodies of that name. Processor time,
// medians of five runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "bench/free_bodies.h"
#include "bench/stepping_runners.h"
#include "error/error.h"
#include "mechanics/motion.h"

namespace {

using namespace poinsot;
using namespace poinsot::bench;

constexpr std::size_t frames_a_period = 60;

const std::array<FreeBody, 4> spans{{
    {"generic", {1.0, 2.0, 2.9}, {1.5, 0.3, 0.75}},
    {"near the separatrix", {1.0, 2.0, 3.0}, {1e-3, 1.0, 1e-3}},
    {"symmetric", {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
    {"mild", {2.0, 2.2, 2.5}, {0.3, 0.2, 1.0}},
}};

// Prevents the compiler from removing computations.
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

double ns_an_evaluation(const FreeBody& c, Quantities wanted, double from_s) {
    const Motion motion(problem_of(c));
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
    fmt::print("{:<32}{:>8}{:>12}{:>14}\n", "regime", "exact", "t = 1e12 s", "omega alone");
    for (const FreeBody& c : regimes) {
        fmt::print("{:<32}{:>8.0f}{:>12.0f}{:>14.0f}\n", c.name, ns_an_evaluation(c, all, 0.0),
                   ns_an_evaluation(c, all, 1e12), ns_an_evaluation(c, omega, 0.0));
        std::fflush(stdout);
    }
}

std::vector<double> frame_times(const FreeBody& c) {
    const double period = *Motion(problem_of(c)).free_rotation()->constants().polhode_period_s;
    std::vector<double> times;
    for (int k = 0; k <= 6000; ++k) {
        times.push_back(k * period / static_cast<double>(frames_a_period));
    }
    return times;
}

// The coarsest setting that meets the target, with its cost per frame; or the least error found, if
// no setting meets it within the runner's longest run.
struct Found {
    bool reached = false;
    std::string setting;
    double ns = 0.0;
    double error_rad = INFINITY;
};
Found coarsest(const Runner& runner, const Attitudes& truth, double target) {
    Found best;
    for (int rung = 0; rung < 64; ++rung) {
        const auto setting = runner.setting(rung);
        if (!setting) break;
        const double before = cpu_ns();
        double error_rad = INFINITY;
        try {
            error_rad = worst_error(runner.run(rung), truth);
        } catch (const InputError&) {
            // A step for which an implicit method finds no solution, or that diverges.
        }
        if (error_rad <= target) {
            const double ns = median_ns([&] { sink = runner.run(rung).back()[0]; });
            return {true, *setting, ns / static_cast<double>(truth.size()), error_rad};
        }
        best.error_rad = std::min(best.error_rad, error_rad);
        if (cpu_ns() - before > 1e9 * runner.longest_run_s) break;
    }
    return best;
}

void print_span(const FreeBody& c) {
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

    const std::vector<Runner> runners = runners_for(c, times, frames_a_period);
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
            fmt::print("    no method reaches it\n");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string wanted = argc > 1 ? argv[1] : "";
    if (wanted.empty()) print_regimes();
    for (const FreeBody& c : spans) {
        if (wanted.empty() || wanted == c.name) print_span(c);
    }
    return 0;
}
