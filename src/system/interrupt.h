// Ctrl-C as a question that long loops ask, so that they can stop cleanly.
#pragma once

namespace poinsot {

// From here on SIGINT and SIGTERM are remembered instead of ending the process; a second one ends
// it.
void watch_for_interrupts();

// Throws EnvironmentError if one has come.
void stop_if_interrupted();

// While one lives, in whatever thread, they end the process after all: for work that does not ask.
class EndsAtOnce {
 public:
    EndsAtOnce();
    ~EndsAtOnce();
    EndsAtOnce(const EndsAtOnce&) = delete;
    EndsAtOnce& operator=(const EndsAtOnce&) = delete;
};

}  // namespace poinsot
