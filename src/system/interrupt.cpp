#include "system/interrupt.h"

#include <csignal>

#include "error/error.h"

namespace poinsot {

namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void remember_interrupt(int signal_number) {
    interrupted = 1;
    std::signal(signal_number, SIG_DFL);
}

}  // namespace

void watch_for_interrupts() {
    std::signal(SIGINT, remember_interrupt);
    std::signal(SIGTERM, remember_interrupt);
}

void stop_if_interrupted() {
    if (interrupted != 0)
        throw EnvironmentError(
            "interrupted; nothing is under the final name; a film goes on with the same command");
}

}  // namespace poinsot
