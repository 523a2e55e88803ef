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

// While it lives, what is being done is told after a second and then every ten. Ctrl-C ends the
// process at once, as nothing is open yet that would be lost. What looks at its token is asked to
// stop when the limit is over.
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

// The seconds that stepping over a problem's span will take here, from a few thousandths of a
// second of it by a clock, and from a counted number of steps at most. 0 for a method that does not
// step, and for what the method refuses within those steps.
double stepping_estimate_s(const MotionProblem& problem, double (*clock_s)() = thread_processor_s);

}  // namespace poinsot
