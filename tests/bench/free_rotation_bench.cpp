// The cost of an instant of the exact free motion in every regime, near the start and 1e12 s away,
// and of its setup.
#include <benchmark/benchmark.h>

#include <string>

#include "bench/free_bodies.h"
#include "mechanics/free/free_rotation.h"

namespace {

using namespace poinsot;
using namespace poinsot::bench;

FreeRotation motion_of(const FreeBody& c) {
    const MotionProblem problem = problem_of(c);
    return {problem.inertia, problem.start};
}

void evaluate(benchmark::State& state, const FreeBody& c, Quantities wanted, double from) {
    const FreeRotation motion = motion_of(c);
    double t = from;
    for (auto unused : state) {
        benchmark::DoNotOptimize(motion.sample(t, wanted));
        t += 1.0 / 60.0;
    }
}

void set_up(benchmark::State& state, const FreeBody& c) {
    for (auto unused : state) benchmark::DoNotOptimize(motion_of(c));
}

const bool registered = [] {
    const Quantities all{.attitude = true, .herpolhode = true, .euler_angles = false};
    const Quantities attitude{.attitude = true, .herpolhode = false, .euler_angles = false};
    const Quantities omega{.attitude = false, .herpolhode = false, .euler_angles = false};
    for (const FreeBody& c : regimes) {
        const std::string name = std::string("free/") + c.name;
        const auto add = [&](const std::string& what, Quantities wanted, double from) {
            benchmark::RegisterBenchmark((name + what).c_str(), evaluate, c, wanted, from);
        };
        add("/exact", all, 0.0);
        add("/exact_at_1e12_s", all, 1e12);
        add("/exact_without_herpolhode", attitude, 0.0);
        add("/exact_omega_alone", omega, 0.0);
        benchmark::RegisterBenchmark((name + "/setup").c_str(), set_up, c);
    }
    return true;
}();

}  // namespace
