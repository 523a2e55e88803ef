#include "library/production/drawing_thread.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "error/error.h"
#include "system/interrupt.h"

namespace poinsot::library {

namespace {

constexpr const char* stopped_before = "stopped before the picture was begun";

bool operator==(const ContextChoice& a, const ContextChoice& b) {
    return a.backend == b.backend && a.portability == b.portability;
}

// Work that waits or runs, and what it has told so far. The queue's mutex guards it.
struct Job {
    ContextChoice choice;
    const DrawingWork* work = nullptr;
    bool is_begun = false, is_done = false;
    std::atomic<bool> stops = false;
    std::exception_ptr error{};
    std::vector<std::string> lines{};
    std::int64_t n_done = 0, n_frames = 0;
};

// Whether a process from which this one was forked had begun to draw: the threads of Mesa's
// renderer, which are started once, do not exist in this process.
std::atomic<bool> lost_the_renderer{false};
std::atomic<bool> has_drawn{false};

class Queue {
 public:
    void run(Job& job, const Watch& watch);
    void end();

 private:
    void start();
    void draw_jobs();
    void draw_one(Job& job, std::optional<LazyRenderer>& renderer, ContextChoice& open);
    Task task_of(Job& job);
    // Hands on what the job has told since the last call, without the lock.
    void tell(std::unique_lock<std::mutex>& lock, Job& job, const Watch& watch);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job*> waiting_;
    std::thread thread_;
    Job* drawn_ = nullptr;
    bool ends_ = false;  // the thread is asked to end
};

// Never destroyed: at the end of the program, the thread may be waiting. Replaced after a fork.
std::atomic<Queue*> queue_of_process{nullptr};
std::mutex queue_is_made;

void forget_the_parents_queue() {
    queue_of_process = nullptr;
    if (!has_drawn) return;
    lost_the_renderer = true;
    // At exit, Mesa would join its threads, and crash; handlers run in reverse order, so that this
    // one comes first.
    on_exit(
        [](int status, void*) {
            std::fflush(nullptr);
            _exit(status);
        },
        nullptr);
}

Queue& queue() {
    if (Queue* const there = queue_of_process) return *there;
    static const int registered = [] {
        // A fork waits until no other thread makes the queue.
        return pthread_atfork([] { queue_is_made.lock(); }, [] { queue_is_made.unlock(); },
                              [] {
                                  queue_is_made.unlock();
                                  forget_the_parents_queue();
                              });
    }();
    if (registered != 0) throw EnvironmentError("too little memory to start drawing");
    const std::lock_guard lock(queue_is_made);
    if (queue_of_process == nullptr) queue_of_process = new Queue;
    return *queue_of_process;
}

Task Queue::task_of(Job& job) {
    const auto change = [this](auto edit) {
        const std::lock_guard lock(mutex_);
        edit();
        changed_.notify_all();
    };
    Task task;
    task.say = [&job, change](const std::string& line) {
        change([&] { job.lines.push_back(line); });
    };
    task.begin = [&job, change](const std::string&, std::int64_t n_frames) {
        change([&] { job.n_done = 0, job.n_frames = n_frames; });
    };
    // The caller looks at it from time to time.
    task.done = [this, &job](std::int64_t n_done) {
        const std::lock_guard lock(mutex_);
        job.n_done = n_done;
    };
    task.stop = [&job] { return job.stops.load(); };
    return task;
}

void Queue::draw_one(Job& job, std::optional<LazyRenderer>& renderer, ContextChoice& open) {
    const Task task = task_of(job);
    const StopsWhen stops(task.stop);
    try {
        if (renderer && !(open == job.choice)) renderer.reset();
        if (!renderer) {
            renderer.emplace(job.choice);
            open = job.choice;
        }
        (*job.work)(*renderer, task);
    } catch (...) {
        job.error = std::current_exception();
    }
}

void Queue::draw_jobs() {
    std::optional<LazyRenderer> renderer;
    ContextChoice open;
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
        if (ends_) return;
        Job& job = *waiting_.front();
        waiting_.pop_front();
        job.is_begun = true;
        drawn_ = &job;
        lock.unlock();
        draw_one(job, renderer, open);
        lock.lock();
        drawn_ = nullptr;
        job.is_done = true;
        changed_.notify_all();
    }
}

void Queue::tell(std::unique_lock<std::mutex>& lock, Job& job, const Watch& watch) {
    const std::vector<std::string> lines = std::exchange(job.lines, {});
    const std::int64_t n_done = job.n_done, n_frames = job.n_frames;
    lock.unlock();
    if (watch.say)
        for (const std::string& line : lines) watch.say(line);
    if (watch.frames && n_frames > 0) watch.frames(n_done, n_frames);
    lock.lock();
}

void Queue::start() {
    try {
        thread_ = std::thread([this] { draw_jobs(); });
    } catch (const std::system_error& error) {
        throw EnvironmentError(std::string("cannot start the thread that draws: ") + error.what());
    }
}

void Queue::run(Job& job, const Watch& watch) {
    std::exception_ptr fault;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !ends_; });
    if (!thread_.joinable()) start();
    waiting_.push_back(&job);
    changed_.notify_all();
    while (!job.is_done) {
        // Short work needs no look at the caller's functions.
        changed_.wait_for(lock, std::chrono::milliseconds(20));
        if (job.is_done) break;
        if (fault) continue;  // the work was asked to stop
        bool stop = false;
        try {
            tell(lock, job, watch);
            lock.unlock();
            stop = watch.stop && watch.stop();
            lock.lock();
        } catch (...) {
            if (!lock.owns_lock()) lock.lock();
            if (!fault) fault = std::current_exception();
            stop = true;
        }
        if (!stop || job.is_done) continue;
        if (!job.is_begun) {
            std::erase(waiting_, &job);
            if (fault) std::rethrow_exception(fault);
            throw EnvironmentError(stopped_before);
        }
        job.stops = true;
    }
    if (!fault && !job.error) tell(lock, job, watch);
    if (fault) std::rethrow_exception(fault);
    if (job.error) std::rethrow_exception(job.error);
}

void Queue::end() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !ends_; });
    if (!thread_.joinable()) return;
    ends_ = true;
    if (drawn_ != nullptr) drawn_->stops = true;
    for (Job* const job : waiting_) {
        job->error = std::make_exception_ptr(EnvironmentError(stopped_before));
        job->is_done = true;
    }
    waiting_.clear();
    changed_.notify_all();
    lock.unlock();
    thread_.join();
    lock.lock();
    ends_ = false;
    changed_.notify_all();
}

}  // namespace

void draw(const ContextChoice& choice, const Watch& watch, const DrawingWork& work) {
    if (lost_the_renderer)
        throw EnvironmentError(
            "this process was forked from one that had drawn pictures, and the threads of Mesa's "
            "renderer do not exist in it; start it by spawn, as "
            "multiprocessing.get_context(\"spawn\") does, or draw only in the forked processes");
    leave_signals_to_host();
    has_drawn = true;
    Job job;
    job.choice = choice;
    job.work = &work;
    queue().run(job, watch);
}

void stop_drawing() {
    if (Queue* const there = queue_of_process) there->end();
}

}  // namespace poinsot::library
