// PNG stills and numbered PNG sequences.
#include <fmt/format.h>

#include <algorithm>

#include "error/error.h"
#include "image/atomic_file.h"
#include "image/png.h"
#include "output/formats.h"
#include "output/frame_name.h"

namespace poinsot {

namespace {

PngOptions options_for(const OutputPlan& plan) {
    PngOptions options;
    if (!plan.metadata.empty()) options.texts["poinsot"] = plan.metadata;
    return options;
}

// Each frame is whole under its own name as soon as write() returns.
class PngSequenceSink : public FrameSink {
 public:
    explicit PngSequenceSink(const OutputPlan& plan)
        : plan_(plan), options_(options_for(plan)), lock_(plan.path) {}

    void write(const Image& frame) override {
        write_png(frame_name(plan_.path, plan_.first_frame + n_written_), frame, options_);
        ++n_written_;
    }
    void finish() override {}

 private:
    OutputPlan plan_;
    PngOptions options_;
    AtomicFile lock_;  // never committed: its file aside says that this sequence is being written
    std::int64_t n_written_ = 0;
};

class PngStillSink : public FrameSink {
 public:
    explicit PngStillSink(const OutputPlan& plan)
        : plan_(plan), options_(options_for(plan)), file_(plan.path) {}

    void write(const Image& frame) override {
        if (written_)
            throw InputError(
                fmt::format("{} holds one picture; put #### into its name for a sequence",
                            plan_.path.string()));
        file_.write(encode_png(frame, options_));
        written_ = true;
    }
    void finish() override { file_.commit(); }

 private:
    OutputPlan plan_;
    PngOptions options_;
    AtomicFile file_;
    bool written_ = false;
};

}  // namespace

std::unique_ptr<FrameSink> open_png_sequence(const OutputPlan& plan) {
    return std::make_unique<PngSequenceSink>(plan);
}

std::unique_ptr<FrameSink> open_png_still(const OutputPlan& plan) {
    return std::make_unique<PngStillSink>(plan);
}

}  // namespace poinsot
