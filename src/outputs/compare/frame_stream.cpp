#include "compare/frame_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "encoding/frame_name.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

bool is_film_name(const std::filesystem::path& file) {
    // FFmpeg reads more than poinsot writes.
    const std::string suffix = suffix_of(file);
    return is_written_film_name(file) || suffix == ".mkv" || suffix == ".avi";
}

bool is_sequence_name(const std::filesystem::path& file) {
    return suffix_of(file) == ".png" && has_frame_number(file) &&
           kind_of_file(file) != FileKind::regular;
}

FrameStream::FrameStream(const std::filesystem::path& path) : path_(path) {
    if (!is_sequence_name(path)) {
        film_.emplace(path);
        return;
    }
    numbers_ = frames_there(path);
    if (numbers_.empty())
        throw InputError(
            fmt::format("{}: no picture has such a name; give the name with which the "
                        "sequence was drawn, with # for each digit",
                        printable(path.string())));
    for (std::size_t i = 1; i < numbers_.size(); ++i)
        if (numbers_[i] != numbers_[i - 1] + 1)
            throw InputError(
                fmt::format("{}: this picture of the sequence is missing; draw it again",
                            printable(frame_name(path, numbers_[i - 1] + 1).string())));
}

bool FrameStream::read(StoredPicture& frame) {
    if (film_) return film_->read(frame.image);
    if (next_ == numbers_.size()) return false;
    frame = read_stored_png(frame_name(path_, numbers_[next_++]));
    return true;
}

std::optional<double> FrameStream::time_s() const { return film_ ? film_->time_s() : std::nullopt; }

const VideoInfo* FrameStream::info() const { return film_ ? &film_->info() : nullptr; }

std::optional<FrameRate> FrameStream::rate() const {
    if (!film_) return std::nullopt;
    const FrameRate rate = film_->info().rate;
    if (rate.numerator <= 0 || rate.denominator <= 0) return std::nullopt;
    return rate;
}

std::int64_t FrameStream::n_frames() const {
    return film_ ? film_->info().n_frames : std::ssize(numbers_);
}

std::int64_t FrameStream::frame_pixels() const {
    return film_ ? std::int64_t{film_->info().width_px} * film_->info().height_px : 0;
}

std::filesystem::path FrameStream::file() const {
    return film_ ? path_ : frame_name(path_, numbers_.front());
}

}  // namespace poinsot
