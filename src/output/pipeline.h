// Drawing and encoding at once: frames pass through bounded queues to threads that write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "image/image.h"
#include "output/frame_sink.h"

namespace poinsot {

// Hands numbered frames to threads. Used from one thread.
class FrameWorkers {
 public:
    // Called with the worker's index, the frame's number and the frame; one worker sees the frames
    // in order, several share them. May say that the frame is read before all is done with it.
    using Work = std::function<void(std::size_t worker, std::int64_t number, const Image& frame,
                                    const WasRead& was_read)>;

    // At most n_pictures at a time are not read yet, that of spare() among them.
    FrameWorkers(std::size_t n_workers, std::size_t n_pictures, Work work);
    ~FrameWorkers();  // drops what waits
    FrameWorkers(const FrameWorkers&) = delete;
    FrameWorkers& operator=(const FrameWorkers&) = delete;

    // A picture whose memory may be used for the next frame; empty at first. Waits while there are
    // as many as there may be. Throws what any worker threw, from then on at every call.
    Image spare();

    // Waits and throws as spare does.
    void put(Image&& frame);

    // Waits until every frame is done. Throws as put does.
    void drain();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A sink on a thread of its own; the same bytes as without it. Its errors arrive at the next call
// of write() or at finish(). Destroyed unfinished, it leaves what the sink leaves. Two pictures,
// one drawn while the other waits, do: encoders have queues of their own, and more leave the cache.
class AsyncSink : public FrameSink {
 public:
    explicit AsyncSink(std::unique_ptr<FrameSink> sink, std::size_t n_pictures = 2);
    ~AsyncSink() override;

    std::int64_t n_frames_kept() const override;
    bool has_frame(std::int64_t frame) const override;
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
