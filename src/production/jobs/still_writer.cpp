#include "production/jobs/still_writer.h"

#include <utility>

#include "image/files/png_files.h"

namespace poinsot {

void StillWriter::write(OutputPlace&& place, Image&& picture, PngOptions&& png,
                        std::function<void()>&& written) {
    finish();
    written_ = std::move(written);
    place_.emplace(std::move(place));
    // If no thread can be started, finish() writes.
    writing_ = std::async([path = place_->path(), picture = std::move(picture),
                           png = std::move(png)] { write_png(path, picture, png); });
}

void StillWriter::finish() {
    if (!writing_.valid()) return;
    writing_.get();
    place_.reset();
    written_();
}

}  // namespace poinsot
