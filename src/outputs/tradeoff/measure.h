// Timing of parts of the program: medians of repeats, processor time of this process.
#pragma once

#include <functional>

namespace poinsot {

// Processor seconds that this process has used, all threads.
double process_cpu_s();

struct Timing {
    double wall_s = 0.0;  // medians over the runs
    double cpu_s = 0.0;
    int n_runs = 0;
};

// Runs `work` until `least_s` seconds have passed and at least `least_runs` times, at most
// `most_runs` times.
Timing timed(const std::function<void()>& work, int least_runs = 3, int most_runs = 25,
             double least_s = 0.05);

}  // namespace poinsot
