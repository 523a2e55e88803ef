// Lets long loops check for Ctrl-C, so that they can stop cleanly.
#pragma once

#include <chrono>
#include <functional>

namespace poinsot {

// From this call on, the first SIGINT, SIGTERM or SIGHUP is recorded and does not end the process;
// the second one ends it. An ignored SIGHUP (nohup) stays ignored.
void watch_for_interrupts();

// Throws EnvironmentError if a signal has been received.
void stop_if_interrupted();

// For a host that handles signals itself, such as an interpreter: from this call on,
// watch_for_interrupts() leaves signals alone.
void leave_signals_to_host();

// While an object of this class exists, stop_if_interrupted() also throws on its thread if `stop`
// returns true; it calls `stop` at most every 20 ms. An inner object with a function hides an outer
// one.
class StopsWhen {
 public:
    explicit StopsWhen(std::function<bool()> stop);
    ~StopsWhen();
    StopsWhen(const StopsWhen&) = delete;
    StopsWhen& operator=(const StopsWhen&) = delete;

 private:
    friend void stop_if_interrupted();
    bool asks();

    std::function<bool()> stop_;
    std::chrono::steady_clock::time_point next_{};
    StopsWhen* outer_;
};

// While an object of this class exists in any thread, signals end the process at once: for work
// that does not check.
class EndsAtOnce {
 public:
    EndsAtOnce();
    ~EndsAtOnce();
    EndsAtOnce(const EndsAtOnce&) = delete;
    EndsAtOnce& operator=(const EndsAtOnce&) = delete;
};

}  // namespace poinsot
