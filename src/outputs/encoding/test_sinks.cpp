// Sinks for tools and tests: one discards all frames, one writes a hash of every frame.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "encoding/formats.h"
#include "encoding/frame_log.h"
#include "encoding/libav_calls.h"
#include "error/error.h"
#include "system/files/atomic_file.h"

namespace poinsot {

namespace {

class NullSink : public FrameSink {
 public:
    void write(const Image&) override {}
    void finish() override {}
};

std::string md5_of(std::span<const std::uint8_t> bytes) {
    std::array<std::uint8_t, 16> digest{};
    av_md5_sum(digest.data(), bytes.data(), bytes.size());
    std::string text;
    for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
    return text;
}

// One line per frame: its number and the MD5 of its RGBA bytes.
std::string line_of(std::int64_t number, const Image& frame) {
    return fmt::format("{} {}\n", number, md5_of(frame.bytes()));
}

std::span<const std::uint8_t> bytes_of(const std::string& line) {
    return {reinterpret_cast<const std::uint8_t*>(line.data()), line.size()};
}

class Md5Sink : public FrameSink {
 public:
    explicit Md5Sink(const OutputPlan& plan) : file_(plan.path), number_(plan.first_frame) {}

    void write(const Image& frame) override { file_.write(bytes_of(line_of(number_++, frame))); }
    void finish() override { file_.commit(); }

 private:
    AtomicFile file_;
    std::int64_t number_;
};

// A part of such a file: one entry per line.
class Md5PartSink : public FrameSink {
 public:
    explicit Md5PartSink(const OutputPlan& plan)
        : log_(plan, "MD5 of RGBA", 1),
          n_kept_(log_.n_entries()),
          number_(first_number(plan) + n_kept_) {}

    std::int64_t n_frames_kept() const override { return n_kept_; }
    void write(const Image& frame) override { log_.append(bytes_of(line_of(number_++, frame))); }
    void finish() override { log_.become_part(); }

 private:
    FrameLog log_;
    std::int64_t n_kept_;
    std::int64_t number_;
};

}  // namespace

std::unique_ptr<FrameSink> open_md5(const OutputPlan& plan) {
    if (plan.part) return std::make_unique<Md5PartSink>(plan);
    return std::make_unique<Md5Sink>(plan);
}

void join_md5(FrameEntries& entries, const OutputPlan& plan) {
    AtomicFile file(plan.path);
    for (std::int64_t k = 0; k < entries.n_entries(); ++k) file.write(entries.read(k));
    file.commit();
}

std::unique_ptr<FrameSink> open_null(const OutputPlan&) { return std::make_unique<NullSink>(); }

}  // namespace poinsot
