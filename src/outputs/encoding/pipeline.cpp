#include "encoding/pipeline.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace poinsot {

struct FrameWorkers::Impl {
    struct Job {
        std::int64_t number;
        Image frame;
    };

    // In this destructor, which also runs when a later thread cannot be started.
    ~Impl() {
        {
            const std::lock_guard lock(mutex);
            stopping = true;
        }
        frame_came.notify_all();
    }

    void run(std::size_t worker);
    void give_back(Image& frame);
    void wait_for_room(std::unique_lock<std::mutex>& lock);
    void rethrow() const {
        if (error) std::rethrow_exception(error);
    }

    Work work;
    std::size_t n_unread_at_most = 1;

    std::mutex mutex;  // guards all below
    std::condition_variable frame_came, frame_left;
    std::deque<Job> waiting;
    std::size_t n_unread = 0;  // of the frames passed to put()
    std::vector<Image> spares;
    std::int64_t n_put = 0, n_done = 0;
    bool stopping = false;
    std::exception_ptr error;

    std::vector<std::jthread> threads;  // joined before all other members are destroyed
};

void FrameWorkers::Impl::run(std::size_t worker) {
    std::unique_lock lock(mutex);
    for (;;) {
        frame_came.wait(lock, [&] { return stopping || !waiting.empty(); });
        if (stopping) return;
        Job job = std::move(waiting.front());
        waiting.pop_front();
        // After a failure the remaining frames are dropped, so that no thread waits forever.
        const bool dropped = static_cast<bool>(error);
        lock.unlock();
        bool is_read = false;
        const auto consumed = [&] {
            if (!std::exchange(is_read, true)) give_back(job.frame);
        };
        std::exception_ptr failure;
        try {
            if (!dropped) work(worker, job.number, job.frame, consumed);
        } catch (...) {
            failure = std::current_exception();
        }
        consumed();
        lock.lock();
        if (failure && !error) error = failure;
        ++n_done;
        frame_left.notify_all();
    }
}

void FrameWorkers::Impl::give_back(Image& frame) {
    const std::lock_guard lock(mutex);
    --n_unread;
    if (spares.size() < n_unread_at_most) spares.push_back(std::move(frame));
    frame_left.notify_all();
}

void FrameWorkers::Impl::wait_for_room(std::unique_lock<std::mutex>& lock) {
    frame_left.wait(lock, [&] { return error || n_unread < n_unread_at_most; });
    rethrow();
}

FrameWorkers::FrameWorkers(std::size_t n_workers, std::size_t n_pictures, Work work)
    : impl_(std::make_unique<Impl>()) {
    impl_->work = std::move(work);
    impl_->n_unread_at_most = std::max<std::size_t>(n_pictures, 1);
    // Reserves memory, so that returning a frame, outside any try, allocates none.
    impl_->spares.reserve(impl_->n_unread_at_most);
    for (std::size_t i = 0; i < std::max<std::size_t>(n_workers, 1); ++i)
        impl_->threads.emplace_back([impl = impl_.get(), i] { impl->run(i); });
}

FrameWorkers::~FrameWorkers() = default;

Image FrameWorkers::spare() {
    std::unique_lock lock(impl_->mutex);
    impl_->wait_for_room(lock);
    if (impl_->spares.empty()) return {};
    Image image = std::move(impl_->spares.back());
    impl_->spares.pop_back();
    return image;
}

void FrameWorkers::put(Image&& frame) {
    std::unique_lock lock(impl_->mutex);
    impl_->wait_for_room(lock);
    ++impl_->n_unread;
    impl_->waiting.push_back({impl_->n_put++, std::move(frame)});
    impl_->frame_came.notify_one();
}

void FrameWorkers::drain() {
    std::unique_lock lock(impl_->mutex);
    impl_->frame_left.wait(lock, [&] { return impl_->error || impl_->n_done == impl_->n_put; });
    impl_->rethrow();
}

AsyncSink::AsyncSink(std::unique_ptr<FrameSink> sink, std::size_t n_pictures)
    : sink_(std::move(sink)),
      workers_(std::make_unique<FrameWorkers>(
          1, n_pictures,
          [this](std::size_t, std::int64_t, const Image& frame, const PixelsConsumed& consumed) {
              sink_->write_notifying(frame, consumed);
          })) {}

AsyncSink::~AsyncSink() { workers_.reset(); }

std::int64_t AsyncSink::n_frames_kept() const { return sink_->n_frames_kept(); }

bool AsyncSink::has_frame(std::int64_t frame) const { return sink_->has_frame(frame); }

void AsyncSink::write(const Image& frame) {
    Image copy = workers_->spare();
    copy = frame;
    workers_->put(std::move(copy));
}

void AsyncSink::finish() {
    workers_->drain();
    sink_->finish();
}

Image AsyncSink::spare() { return workers_->spare(); }

void AsyncSink::write_moved(Image&& frame) { workers_->put(std::move(frame)); }

}  // namespace poinsot
