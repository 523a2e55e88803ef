// Work that may take long before anything is drawn: how long it will take, and a word meanwhile.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "mechanics/motion_problem.h"
#include "production/telling.h"
#include "system/interrupt.h"

namespace poinsot {

// While it lives, what is being done is told after a second and then every ten. Ctrl-C ends the
// process at once, as nothing is open yet that would be lost.
class Patience {
 public:
    // Throws EnvironmentError if Ctrl-C has come before.
    Patience(std::string what, double estimate_s, const Telling& telling);
    ~Patience();
    Patience(const Patience&) = delete;
    Patience& operator=(const Patience&) = delete;

 private:
    void tell(const std::string& what, double estimate_s,
              const std::function<void(const std::string&)>& say);

    std::mutex mutex_;
    std::condition_variable ended_;
    bool done_ = false;
    std::thread teller_;
    EndsAtOnce ends_at_once_;
};

// Stepping may take so long; more is refused beforehand.
inline constexpr double longest_stepping_s = 600.0;

// Of this thread alone: what a busy machine gives to others does not lengthen an estimate.
double own_processor_s();

// The seconds that stepping over a problem's span will take here, from a few thousandths of a
// second of it by a clock. 0 for a method that does not step, and for what the method refuses.
double stepping_estimate_s(const MotionProblem& problem, double (*clock_s)() = own_processor_s);

}  // namespace poinsot
