#include "production/session/slow_work_notice.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "system/interrupt.h"

namespace poinsot {

struct SlowWorkNotice::Teller {
    void tell(const std::string& what, double limit_s,
              const std::function<void(const std::string&)>& say);

    std::mutex mutex;
    std::condition_variable ended;
    bool done = false;
    std::atomic<double> estimate_s = 0.0;
    std::atomic<bool> is_over = false;
    std::thread thread;
    EndsAtOnce ends_at_once;
};

SlowWorkNotice::SlowWorkNotice(std::string what, const Task& task, double limit_s) {
    stop_if_interrupted();
    teller_ = std::make_unique<Teller>();
    try {
        teller_->thread = std::thread([teller = teller_.get(), what = std::move(what), limit_s,
                                       say = task.say] { teller->tell(what, limit_s, say); });
    } catch (const std::system_error&) {
        // If no thread can be started, the work is done without messages.
    }
}

SlowWorkNotice::~SlowWorkNotice() {
    {
        const std::lock_guard lock(teller_->mutex);
        teller_->done = true;
    }
    teller_->ended.notify_all();
    if (teller_->thread.joinable()) teller_->thread.join();
}

void SlowWorkNotice::expect(double estimate_s) { teller_->estimate_s = estimate_s; }

bool SlowWorkNotice::is_over() const {
    stop_if_interrupted();
    return teller_->is_over;
}

void SlowWorkNotice::Teller::tell(const std::string& what, double limit_s,
                                  const std::function<void(const std::string&)>& say) {
    using namespace std::chrono_literals;
    const auto started = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex);
    for (auto wait = 1s; !ended.wait_for(lock, wait, [this] { return done; }); wait = 10s) {
        const double spent_s =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
        const double expected_s = estimate_s;
        const std::string of =
            expected_s > 0.0 ? fmt::format(" of about {:.0f}", std::max(expected_s, spent_s)) : "";
        say(fmt::format("{}: {:.0f}{} s", what, spent_s, of));
        if (spent_s > limit_s) is_over = true;
    }
}

}  // namespace poinsot
