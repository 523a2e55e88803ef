#include "system/interrupt.h"

#include <atomic>
#include <csignal>
#include <utility>

#include "error/error.h"

namespace poinsot {

namespace {

volatile std::sig_atomic_t interrupted = 0;
std::atomic<bool> host_handles_signals{false};
thread_local StopsWhen* innermost_of_thread = nullptr;
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
    // The terminal is closed. nohup ignores this signal, so that the program goes on.
    struct sigaction hangup {};
    if (sigaction(SIGHUP, nullptr, &hangup) == 0 && hangup.sa_handler != SIG_IGN)
        std::signal(SIGHUP, remember_interrupt);
}

void stop_if_interrupted() {
    if (interrupted != 0 || (innermost_of_thread != nullptr && innermost_of_thread->asks()))
        throw EnvironmentError(
            "interrupted before the output was finished; run the same command again to continue a "
            "film");
}

void leave_signals_to_host() { host_handles_signals = true; }

StopsWhen::StopsWhen(std::function<bool()> stop)
    : stop_(std::move(stop)), outer_(std::exchange(innermost_of_thread, this)) {}
StopsWhen::~StopsWhen() { innermost_of_thread = outer_; }

bool StopsWhen::asks() {
    if (!stop_) return outer_ != nullptr && outer_->asks();
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return false;
    next_ = now + std::chrono::milliseconds(20);
    return stop_();
}

EndsAtOnce::EndsAtOnce() { ++n_ends_at_once; }
EndsAtOnce::~EndsAtOnce() { --n_ends_at_once; }

}  // namespace poinsot
