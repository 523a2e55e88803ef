// Work that may take long before drawing starts: an estimate of its time, and messages meanwhile.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "mechanics/motion_problem.h"
#include "production/session/progress_sink.h"
#include "system/interrupt.h"

namespace poinsot {

// During its lifetime it reports the current work after one second and then every ten seconds.
// Ctrl-C ends the process at once, because no open file could be lost. After the time limit, it
// requests a stop through its token.
class SlowWorkNotice {
 public:
    // Throws EnvironmentError if Ctrl-C has come before.
    SlowWorkNotice(std::string what, const ProgressSink& progress,
                   double limit_s = std::numeric_limits<double>::infinity());
    // How long all of it will take, once that is known.
    void expect(double estimate_s) { estimate_s_ = estimate_s; }
    std::stop_token token() const { return stop_.get_token(); }
    ~SlowWorkNotice();
    SlowWorkNotice(const SlowWorkNotice&) = delete;
    SlowWorkNotice& operator=(const SlowWorkNotice&) = delete;

 private:
    void tell(const std::string& what, double limit_s,
              const std::function<void(const std::string&)>& say);

    std::mutex mutex_;
    std::condition_variable ended_;
    bool done_ = false;
    std::atomic<double> estimate_s_ = 0.0;
    std::stop_source stop_;
    std::thread teller_;
    EndsAtOnce ends_at_once_;
};

// Upper limit of the time for stepping; estimates above it are rejected.
inline constexpr double longest_stepping_s = 600.0;

// CPU time of this thread: an estimate does not depend on other load.
double thread_processor_s();

// Estimates the seconds that integrating over a problem's span takes on this machine, by timing a
// few milliseconds of it, with at most a fixed number of steps. Returns 0 for a method without
// steps, and if the method refuses the problem within those steps.
double stepping_estimate_s(const MotionProblem& problem, double (*clock_s)() = thread_processor_s);

}  // namespace poinsot
