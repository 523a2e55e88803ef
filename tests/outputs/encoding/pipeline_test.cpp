// Frames through threads: byte-identical output, reported errors, no lost frames and no deadlock.
#include "encoding/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "encoding/films.h"

namespace poinsot {
namespace {

// Records the red of the first pixel of every frame; fails at a frame if requested.
struct Record {
    std::vector<int> frames;
    bool finished = false;
    int fails_at = -1;
    std::chrono::milliseconds pause{0};
};
class RecordingSink : public FrameSink {
 public:
    explicit RecordingSink(Record& record) : record_(record) {}
    void write(const Image& frame) override {
        std::this_thread::sleep_for(record_.pause);
        const int number = frame.at(0, 0).r;
        if (number == record_.fails_at) throw EnvironmentError("the disk is full");
        record_.frames.push_back(number);
    }
    void finish() override { record_.finished = true; }

 private:
    Record& record_;
};

Image numbered(int number) {
    Image image(4, 2);
    image.set(0, 0, {static_cast<std::uint8_t>(number), 0, 0, 255});
    return image;
}

TEST(AsyncSink, IsByteIdenticalToTheSinkAlone) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.md5"}) {
        const TemporaryFolder folder;
        const OutputPlan plan = small_plan(folder / name, 30);
        write_film(plan);
        const std::string alone = bytes_of(plan.path);
        AsyncSink sink(format_for(plan.path).open(plan));
        for (std::int64_t k = 0; k < plan.n_frames; ++k) {
            if (k % 2) {
                sink.write(frame_of(plan, k));
            } else {
                Image frame = sink.spare();
                frame = frame_of(plan, k);
                sink.write_moved(std::move(frame));
            }
        }
        sink.finish();
        EXPECT_TRUE(bytes_of(plan.path) == alone) << name;
    }
}

TEST(AsyncSink, KeepsTheOrderForSlowSinks) {
    Record record;
    record.pause = std::chrono::milliseconds(1);
    AsyncSink sink(std::make_unique<RecordingSink>(record), 2);
    for (int k = 0; k < 50; ++k) sink.write(numbered(k));
    sink.finish();
    ASSERT_EQ(record.frames.size(), 50u);
    for (int k = 0; k < 50; ++k) EXPECT_EQ(record.frames[static_cast<std::size_t>(k)], k);
    EXPECT_TRUE(record.finished);
}

TEST(AsyncSink, ReturnsMemory) {
    Record record;
    AsyncSink sink(std::make_unique<RecordingSink>(record), 2);
    EXPECT_TRUE(sink.spare().empty());
    sink.write(numbered(1));
    while (sink.spare().empty()) std::this_thread::yield();
    sink.finish();
}

TEST(AsyncSink, ErrorsOfTheSinkAreThrownAndStopIt) {
    Record record;
    record.fails_at = 5;
    AsyncSink sink(std::make_unique<RecordingSink>(record), 2);
    EXPECT_EQ(refusal_message<EnvironmentError>([&] {
                  for (int k = 0; k < 100; ++k) sink.write(numbered(k));
              }),
              "the disk is full");
    EXPECT_EQ(refusal_message<EnvironmentError>([&] { sink.finish(); }), "the disk is full");
    EXPECT_FALSE(record.finished);
    EXPECT_EQ(record.frames.size(), 5u);
}

TEST(AsyncSink, AnErrorOfTheLastFrameIsThrownByFinish) {
    Record record;
    record.fails_at = 0;
    AsyncSink sink(std::make_unique<RecordingSink>(record), 2);
    EXPECT_EQ(refusal_message<EnvironmentError>([&] {
                  sink.write(numbered(0));
                  sink.finish();
              }),
              "the disk is full");
    EXPECT_FALSE(record.finished);
}

TEST(AsyncSink, UnfinishedLeavesNoFile) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.mp4", 30);
    {
        AsyncSink sink(format_for(plan.path).open(plan));
        for (std::int64_t k = 0; k < 20; ++k) sink.write(frame_of(plan, k));
    }
    EXPECT_TRUE(folder.contents().empty());
}

TEST(FrameWorkers, ShareAllFrames) {
    std::vector<std::atomic<int>> seen(200);
    FrameWorkers workers(
        3, 4,
        [&](std::size_t worker, std::int64_t number, const Image& frame, const PixelsConsumed&) {
            EXPECT_LT(worker, 3u);
            EXPECT_EQ(frame.at(0, 0).r, number);
            ++seen[static_cast<std::size_t>(number)];
        });
    for (int k = 0; k < 200; ++k) workers.put(numbered(k));
    workers.drain();
    for (const auto& n : seen) EXPECT_EQ(n, 1);
}

TEST(FrameWorkers, LimitTheNumberOfPictures) {
    std::atomic<int> n_put = 0, n_done = 0, most = 0;
    FrameWorkers workers(2, 3, [&](std::size_t, std::int64_t, const Image&, const PixelsConsumed&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++n_done;
    });
    for (int k = 0; k < 60; ++k) {
        workers.put(numbered(k));
        ++n_put;
        most = std::max(most.load(), n_put - n_done);
    }
    workers.drain();
    // Three are waiting or in work; a count may be late by the two that are ending.
    EXPECT_LE(most, 5);
}

TEST(FrameWorkers, AcceptTheNextFrameOnceOneIsRead) {
    // One picture at a time; the work on the first ends only after the second is put.
    std::mutex mutex;
    std::condition_variable was_put;
    bool second_was_put = false, waited_in_vain = false;
    FrameWorkers workers(
        1, 1, [&](std::size_t, std::int64_t number, const Image&, const PixelsConsumed& consumed) {
            consumed();
            std::unique_lock lock(mutex);
            if (number == 0 &&
                !was_put.wait_for(lock, std::chrono::seconds(20), [&] { return second_was_put; }))
                waited_in_vain = true;
        });
    workers.put(numbered(0));
    Image second = workers.spare();
    EXPECT_FALSE(second.empty());
    workers.put(std::move(second));
    {
        const std::lock_guard lock(mutex);
        second_was_put = true;
    }
    was_put.notify_one();
    workers.drain();
    EXPECT_FALSE(waited_in_vain);
}

TEST(FilmSinks, ReadAPictureBeforeEncodingAndReportOnce) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif", "####.png", "a.md5"}) {
        const TemporaryFolder folder;
        const OutputPlan plan = small_plan(folder / name, 3);
        write_film(plan);
        const auto sink = format_for(folder / (std::string("b") + name))
                              .open(small_plan(folder / (std::string("b") + name), 3));
        for (std::int64_t k = 0; k < 3; ++k) {
            Image frame = frame_of(plan, k);
            int n_told = 0;
            // The next rendering into the same memory must not be visible.
            sink->write_notifying(frame, [&] {
                ++n_told;
                std::fill(frame.bytes().begin(), frame.bytes().end(), std::uint8_t{0});
            });
            EXPECT_EQ(n_told, 1) << name;
        }
        sink->finish();
        const auto first = [&](const char* before) {
            return folder /
                   (before + std::string(name == std::string("####.png") ? "0001.png" : name));
        };
        EXPECT_TRUE(bytes_of(first("")) == bytes_of(first("b"))) << name;
    }
}

}  // namespace
}  // namespace poinsot
