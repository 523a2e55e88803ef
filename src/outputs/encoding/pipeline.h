// Concurrent rendering and encoding: frames pass through bounded queues to writing threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "encoding/frame_sink.h"
#include "image/image.h"

namespace poinsot {

// Distributes numbered frames to threads. Used from one thread.
class FrameWorkers {
 public:
    // Called with the worker's index, the frame's number and the frame; a single worker gets the
    // frames in order, several workers share them. May report that the frame is read before its
    // work ends.
    using Work = std::function<void(std::size_t worker, std::int64_t number, const Image& frame,
                                    const PixelsConsumed& consumed)>;

    // At most n_pictures are unread at a time, including that of spare().
    FrameWorkers(std::size_t n_workers, std::size_t n_pictures, Work work);
    ~FrameWorkers();  // drops waiting frames
    FrameWorkers(const FrameWorkers&) = delete;
    FrameWorkers& operator=(const FrameWorkers&) = delete;

    // Returns a picture whose memory may be used for the next frame; empty at first. Waits while
    // n_pictures are unread. Rethrows a worker's exception, from then on at every call.
    Image spare();

    // Passes a frame on. Waits and throws as spare does.
    void put(Image&& frame);

    // Waits until every frame is done. Throws as put does.
    void drain();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A sink on its own thread; its output is byte-identical to that of the sink alone. Errors of the
// sink are thrown by the next write() or by finish(). Destroyed unfinished, it leaves the same
// files as the sink. Two pictures suffice, one rendered while the other waits: encoders have their
// own queues, and more pictures do not fit into the CPU cache.
class AsyncSink : public FrameSink {
 public:
    explicit AsyncSink(std::unique_ptr<FrameSink> sink, std::size_t n_pictures = 2);
    ~AsyncSink() override;

    std::int64_t n_frames_kept() const override;
    bool has_frame(std::int64_t frame) const override;
    void write(const Image& frame) override;  // copies
    void finish() override;

    // Writing without a copy: call spare(), render into it, then write_moved().
    Image spare();
    void write_moved(Image&& frame);

 private:
    std::unique_ptr<FrameSink> sink_;
    std::unique_ptr<FrameWorkers> workers_;
};

}  // namespace poinsot
