// Sinks that tools and tests use: nothing at all, and a hash of every frame.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "error/error.h"
#include "output/formats.h"
#include "output/libav_calls.h"
#include "system/atomic_file.h"

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

// One line a frame: its number and the MD5 of its RGBA bytes.
class Md5Sink : public FrameSink {
 public:
    explicit Md5Sink(const OutputPlan& plan) : file_(plan.path), number_(plan.first_frame) {}

    void write(const Image& frame) override {
        const std::string line = fmt::format("{} {}\n", number_++, md5_of(frame.bytes()));
        file_.write({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()});
    }
    void finish() override { file_.commit(); }

 private:
    AtomicFile file_;
    std::int64_t number_;
};

}  // namespace

std::unique_ptr<FrameSink> open_md5(const OutputPlan& plan) {
    return std::make_unique<Md5Sink>(plan);
}

std::unique_ptr<FrameSink> open_null(const OutputPlan&) { return std::make_unique<NullSink>(); }

}  // namespace poinsot
