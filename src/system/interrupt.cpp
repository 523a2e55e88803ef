#include "system/interrupt.h"

#include <atomic>
#include <csignal>

#include "error/error.h"

namespace poinsot {

namespace {

volatile std::sig_atomic_t interrupted = 0;
std::atomic<bool> host_handles_signals{false}, host_asks_to_stop{false};
std::atomic<int> n_ends_at_once{0};
static_assert(std::atomic<int>::is_always_lock_free);  // the signal handler reads it

extern "C" void remember_interrupt(int signal_number) {
    interrupted = 1;
    std::signal(signal_number, SIG_DFL);
    if (n_ends_at_once > 0) std::raise(signal_number);  // delivered when this handler returns
}

}  // namespace

void watch_for_interrupts() {
    if (host_handles_signals) return;
    std::signal(SIGINT, remember_interrupt);
    std::signal(SIGTERM, remember_interrupt);
}

void stop_if_interrupted() {
    if (interrupted != 0 || host_asks_to_stop)
        throw EnvironmentError(
            "interrupted before the output was finished; run the same command again to continue a "
            "film");
}

void leave_signals_to_host() { host_handles_signals = true; }
void request_stop(bool stop) { host_asks_to_stop = stop; }

EndsAtOnce::EndsAtOnce() { ++n_ends_at_once; }
EndsAtOnce::~EndsAtOnce() { --n_ends_at_once; }

}  // namespace poinsot
