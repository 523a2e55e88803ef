// Lets long loops check for Ctrl-C, so that they can stop cleanly.
#pragma once

namespace poinsot {

// From this call on, the first SIGINT or SIGTERM is recorded and does not end the process; the
// second one ends it.
void watch_for_interrupts();

// Throws EnvironmentError if a signal has been received.
void stop_if_interrupted();

// For a host that handles signals itself, such as an interpreter: from this call on,
// watch_for_interrupts() leaves signals alone. request_stop(true) then makes stop_if_interrupted()
// throw in every thread, until request_stop(false).
void leave_signals_to_host();
void request_stop(bool stop);

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
