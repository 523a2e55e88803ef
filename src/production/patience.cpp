#include "production/patience.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <system_error>
#include <utility>

#include "error/error.h"
#include "mechanics/stepped/integrated_rotation.h"

namespace poinsot {

Patience::Patience(std::string what, double estimate_s, const Telling& telling) {
    stop_if_interrupted();
    try {
        teller_ = std::thread([this, what = std::move(what), estimate_s, say = telling.say] {
            tell(what, estimate_s, say);
        });
    } catch (const std::system_error&) {
        // Where no thread can be had, the work is done without a word.
    }
}

Patience::~Patience() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    ended_.notify_all();
    if (teller_.joinable()) teller_.join();
}

void Patience::tell(const std::string& what, double estimate_s,
                    const std::function<void(const std::string&)>& say) {
    using namespace std::chrono_literals;
    const auto started = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex_);
    for (auto wait = 1s; !ended_.wait_for(lock, wait, [this] { return done_; }); wait = 10s) {
        const double spent_s =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
        const std::string of =
            estimate_s > 0.0 ? fmt::format(" of about {:.0f}", std::max(estimate_s, spent_s)) : "";
        say(fmt::format("{}: {:.0f}{} s", what, spent_s, of));
    }
}

namespace {

// The least of three, as a virtual machine counts what its host takes away as time of the thread.
double stepping_s(const MotionProblem& problem, double (*clock_s)(), double enough_s) {
    double least_s = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3 && !(least_s < enough_s); ++k) {
        const double before_s = clock_s();
        const IntegratedRotation stepped(problem);
        least_s = std::min(least_s, clock_s() - before_s);
    }
    return least_s;
}

}  // namespace

double own_processor_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double stepping_estimate_s(const MotionProblem& problem, double (*clock_s)()) {
    const Method& method = find_method(problem.method.name);
    const double span_s = problem.last_time_s - problem.first_time_s;
    if (method.make == nullptr || !(span_s > 0.0)) return 0.0;

    // Longer and longer parts from the start on, until one can be timed. The first is so short that
    // it takes what setting up does; that is not multiplied, and what is must be well over it.
    constexpr double least_timed_s = 3e-3;
    constexpr double most_setups = 3.0;
    const double least_span_s =
        std::max(std::ldexp(span_s, -40), problem.method.step_s.value_or(0.0));
    MotionProblem part = problem;
    part.first_time_s = 0.0;
    part.overshoot_s = 0.0;
    double setup_s = 0.0;
    for (double part_s = least_span_s;; part_s *= 2.0) {
        part.last_time_s = std::min(part_s, span_s);
        double timed_s = 0.0;
        try {
            timed_s = stepping_s(part, clock_s, most_setups * setup_s + least_timed_s);
        } catch (const InputError&) {
            return 0.0;  // said by the one who steps over all of it
        }
        if (part.last_time_s >= span_s) return timed_s;
        if (part_s == least_span_s) {
            setup_s = timed_s;
        } else if (timed_s >= most_setups * setup_s + least_timed_s) {
            return setup_s + (timed_s - setup_s) * (span_s / part.last_time_s);
        }
    }
}

}  // namespace poinsot
