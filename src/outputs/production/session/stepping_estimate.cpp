#include "production/session/stepping_estimate.h"

#include <algorithm>
#include <ctime>
#include <limits>

#include "error/error.h"
#include "mechanics/stepped/integrated_rotation.h"

namespace poinsot {

namespace {

struct TimedProbe {
    double timed_s = std::numeric_limits<double>::infinity();
    double share = 0.0;
};

// The least of three, as a virtual machine counts what its host takes away as time of the thread.
TimedProbe probe_timed(const MotionProblem& problem, std::int64_t most_steps, double (*clock_s)(),
                       double enough_s) {
    TimedProbe least;
    for (int k = 0; k < 3 && !(least.timed_s < enough_s); ++k) {
        const double before_s = clock_s();
        least.share = IntegratedRotation::probe(problem, most_steps).share;
        least.timed_s = std::min(least.timed_s, clock_s() - before_s);
    }
    return least;
}

}  // namespace

double thread_processor_s() {
    timespec now{};
#ifdef CLOCK_THREAD_CPUTIME_ID
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
#else  // in a browser
    clock_gettime(CLOCK_MONOTONIC, &now);
#endif
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double stepping_estimate_s(const MotionProblem& problem, double (*clock_s)()) {
    const Method& method = find_method(problem.method.name);
    const double span_s = problem.last_time_s - problem.first_time_s;
    if (method.make == nullptr || !(span_s > 0.0)) return 0.0;

    // Takes more and more steps from the start until they can be timed. The setup time is not
    // extrapolated, so the timed steps must take much longer than the setup. The largest number of
    // steps takes seconds on any machine and ends the measurement, whatever the clock says.
    constexpr double least_timed_s = 3e-3;
    constexpr double most_setups = 3.0;
    constexpr std::int64_t least_probe = 64;
    constexpr std::int64_t most_probe = 1 << 18;
    // Steps go to both sides of the start, a probe along the longer.
    const double after_s = problem.last_time_s + problem.overshoot_s - problem.start.time_s;
    const double before_s = problem.start.time_s - problem.first_time_s;
    const double both_sides =
        (std::max(after_s, 0.0) + std::max(before_s, 0.0)) / std::max(after_s, before_s);
    try {
        const double setup_s = probe_timed(problem, 0, clock_s, least_timed_s).timed_s;
        const double enough_s = most_setups * setup_s + least_timed_s;
        for (std::int64_t n = least_probe;; n *= 2) {
            const TimedProbe probe = probe_timed(problem, n, clock_s, enough_s);
            if (probe.share >= 1.0 || probe.timed_s >= enough_s || n >= most_probe)
                return setup_s + std::max(0.0, probe.timed_s - setup_s) * both_sides / probe.share;
        }
    } catch (const InputError&) {
        return 0.0;  // said by the one who steps over all of it
    }
}

}  // namespace poinsot
