// PNG stills and numbered PNG sequences.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "encoding/film_metadata.h"
#include "encoding/formats.h"
#include "encoding/frame_name.h"
#include "encoding/pipeline.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_xxh64.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/files/free_space.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// The texts of a frame's picture: its record with the frame number and the hash of its pixels.
std::map<std::string, std::string> texts_of(const OutputPlan& plan, std::int64_t frame,
                                            const Image& image) {
    if (plan.metadata.empty()) return {};
    return {{metadata_name, text_of(plan, {.frame = frame, .pixels = pixels_xxh64(image)})}};
}

// Parts of one sequence may be written concurrently.
std::filesystem::path lock_path_of(const OutputPlan& plan) {
    return aside_path_of(
        plan.path,
        plan.part ? fmt::format(".{}-of-{}.part", plan.part->number, plan.part->n_parts) : ".part");
}

// Before anything is drawn: throws as check_aside does for the temporary file of any frame, and for
// a pipe or device with the name of a frame.
void check_places_of_frames(const std::filesystem::path& pattern) {
    const std::filesystem::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
    constexpr std::string_view suffix = ".part";
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error);
         !error && at != std::filesystem::directory_iterator(); at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (is_frame_of(name, pattern) && kind_of_file(at->path()) == FileKind::special)
            throw InputError(
                fmt::format("{}: {}", printable(at->path().string()), in_words(FileKind::special)));
        if (!name.starts_with('.') || !name.ends_with(suffix)) continue;
        const std::string frame = name.substr(1, name.size() - 1 - suffix.size());
        if (is_frame_of(frame, pattern)) check_aside(pattern.parent_path() / frame);
    }
}

// Writes as many frames at a time as there are threads. Each frame is written atomically, so an
// interrupted sequence leaves complete frames, and another run can continue it.
class PngSequenceSink : public FrameSink {
 public:
    explicit PngSequenceSink(const OutputPlan& plan)
        : plan_(plan),
          lock_(plan.path, lock_path_of(plan)),
          first_number_(first_number(plan)),
          encoders_(static_cast<std::size_t>(plan.encoder_threads > 0 ? plan.encoder_threads
                                                                      : usual_threads)),
          there_(frames_that_are_there()) {
        check_places_of_frames(plan_.path);
        // A killed run may have left temporary files of frames that are now kept.
        for (const std::int64_t k : there_)
            remove_left_aside(frame_name(plan_.path, first_number_ + k));
        workers_ = std::make_unique<FrameWorkers>(
            encoders_.size(), n_pictures,
            [this](std::size_t worker, std::int64_t number, const Image& frame,
                   const PixelsConsumed&) { write_one(encoders_[worker], number, frame); });
    }

    std::int64_t n_frames_kept() const override { return frame_of(0); }
    bool has_frame(std::int64_t frame) const override {
        return std::binary_search(there_.begin(), there_.end(), frame);
    }

    void write(const Image& frame) override {
        Image copy = workers_->spare();
        copy = frame;
        workers_->put(std::move(copy));
    }

    void finish() override {
        workers_->drain();
        lock_.discard();
    }

 private:
    static constexpr int usual_threads = 2;
    static constexpr std::size_t n_pictures = 4;

    void write_one(PngEncoder& encoder, std::int64_t number, const Image& frame) const {
        const std::int64_t frame_number = first_number_ + frame_of(number);
        encoder.set_texts(texts_of(plan_, frame_number, frame));
        const auto contents = encoder.encode(frame);
        write_whole(frame_name(plan_.path, frame_number), contents);
        if (number == 0)
            check_free_space(plan_.path, contents.size(), 1,
                             plan_.n_frames - static_cast<std::int64_t>(there_.size()));
    }

    // Number of the n-th written frame, counted from the plan's first.
    std::int64_t frame_of(std::int64_t n) const {
        for (const std::int64_t frame : there_) {
            if (frame > n) break;
            ++n;
        }
        return n;
    }

    // The frames that an earlier run has left.
    std::vector<std::int64_t> frames_that_are_there() const {
        if (!plan_.resume || plan_.metadata.empty()) return {};
        std::vector<std::int64_t> frames = frames_there(plan_.path);
        for (std::int64_t& frame : frames) frame -= first_number_;
        std::erase_if(frames, [this](std::int64_t k) {
            return k < 0 || k >= plan_.n_frames || !is_there(k);
        });
        return frames;
    }

    // Whether a frame of an earlier run is complete, of the same plan, has its original pixels, and
    // has its original number.
    bool is_there(std::int64_t k) const {
        try {
            PngInfo info;
            const Image image = read_png(frame_name(plan_.path, first_number_ + k), &info);
            return info.n_bytes_behind == 0 &&
                   info.texts == texts_of(plan_, first_number_ + k, image) &&
                   image.width() == plan_.width_px && image.height() == plan_.height_px;
        } catch (const Error&) {
            return false;
        }
    }

    OutputPlan plan_;
    AtomicFile lock_;  // never committed: its temporary file marks this sequence as being written
    std::int64_t first_number_;
    std::vector<PngEncoder> encoders_;
    std::vector<std::int64_t> there_;  // in order, counted from the plan's first
    std::unique_ptr<FrameWorkers> workers_;
};

class PngStillSink : public FrameSink {
 public:
    explicit PngStillSink(const OutputPlan& plan) : plan_(plan), file_(plan.path) {}

    void write(const Image& frame) override {
        if (written_)
            throw InputError(
                fmt::format("{} holds one picture; put #### into its name for a sequence",
                            plan_.path.string()));
        PngOptions options;
        options.texts = texts_of(plan_, plan_.first_frame, frame);
        file_.write(encode_png(frame, options));
        written_ = true;
    }
    void finish() override { file_.commit(); }

 private:
    OutputPlan plan_;
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
