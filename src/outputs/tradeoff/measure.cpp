#include "tradeoff/measure.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace poinsot {

namespace {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

double process_cpu_s() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Timing timed(const std::function<void()>& work, int least_runs, int most_runs, double least_s) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> wall;
    std::vector<double> cpu;
    const auto started = Clock::now();
    double spent_s = 0.0;
    while (static_cast<int>(wall.size()) < least_runs ||
           (spent_s < least_s && static_cast<int>(wall.size()) < most_runs)) {
        const auto before = Clock::now();
        const double cpu_before = process_cpu_s();
        work();
        cpu.push_back(process_cpu_s() - cpu_before);
        wall.push_back(std::chrono::duration<double>(Clock::now() - before).count());
        spent_s = std::chrono::duration<double>(Clock::now() - started).count();
    }
    return {median(wall), median(cpu), static_cast<int>(wall.size())};
}

}  // namespace poinsot
