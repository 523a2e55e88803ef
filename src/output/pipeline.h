// Drawing and encoding at once: frames pass through bounded queues to threads that write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "image/image.h"
#include "output/frame_sink.h"

namespace poinsot {

// Hands numbered frames to threads, at most n_waiting at a time. Used from one thread.
class FrameWorkers {
 public:
    // Called with the worker's index, the frame's number and the frame; one worker sees the frames
    // in order, several share them.
    using Work = std::function<void(std::size_t worker, std::int64_t number, const Image& frame)>;

    FrameWorkers(std::size_t n_workers, std::size_t n_waiting, Work work);
    ~FrameWorkers();  // drops what waits
    FrameWorkers(const FrameWorkers&) = delete;
    FrameWorkers& operator=(const FrameWorkers&) = delete;

    // A picture whose memory may be used for the next frame; empty at first.
    Image spare();

    // Waits while the queue is full. Throws what any worker threw, from then on at every call.
    void put(Image&& frame);

    // Waits until every frame is done. Throws as put does.
    void drain();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A sink on a thread of its own; the same bytes as without it. Its errors arrive at the next call
// of write() or at finish(). Destroyed unfinished, it leaves what the sink leaves.
class AsyncSink : public FrameSink {
 public:
    explicit AsyncSink(std::unique_ptr<FrameSink> sink, std::size_t n_waiting = 4);
    ~AsyncSink() override;

    std::int64_t n_frames_kept() const override;
    void write(const Image& frame) override;  // copies
    void finish() override;

    // Without a copy: spare(), draw into it, write_moved().
    Image spare();
    void write_moved(Image&& frame);

 private:
    std::unique_ptr<FrameSink> sink_;
    std::unique_ptr<FrameWorkers> workers_;
};

}  // namespace poinsot
