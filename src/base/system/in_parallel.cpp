#include "system/in_parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace poinsot {

void in_parallel(std::size_t n, int n_threads, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::size_t failed = n;  // the least index that threw
    std::exception_ptr error;
    const auto take_turns = [&] {
        for (std::size_t i = next++; i < n; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                // Indices are handed out in order: those before it are done or being worked on.
                next = n;
                if (i < failed) failed = i, error = std::current_exception();
            }
        }
    };
    {
        const std::size_t n_helpers =
            std::min(n, static_cast<std::size_t>(std::max(1, n_threads))) - (n > 0 ? 1 : 0);
        std::vector<std::jthread> helpers;  // joined before anything else goes
        helpers.reserve(n_helpers);
        try {
            for (std::size_t k = 0; k < n_helpers; ++k) helpers.emplace_back(take_turns);
        } catch (const std::system_error&) {
            // If no further thread can be started, those that there are do all the work.
        }
        take_turns();
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace poinsot
