#include "production/stills/still_writer.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "image/files/png_files.h"

namespace poinsot {

void StillWriter::write(OutputPlace&& place, Image&& picture, PngOptions&& png,
                        std::function<void()>&& written) {
    finish();
    written_ = std::move(written);
    place_.emplace(std::move(place));
    // If no thread can be started, finish() writes. libstdc++ 12 has then moved the function away
    // already if it may; it copies this one.
    struct Still {
        std::filesystem::path path;
        Image picture;
        PngOptions png;
    };
    const auto still =
        std::make_shared<const Still>(Still{place_->path(), std::move(picture), std::move(png)});
    const auto write = [still] { write_png(still->path, still->picture, still->png); };
    writing_ = std::async(write);
}

void StillWriter::finish() {
    if (!writing_.valid()) return;
    writing_.get();
    place_.reset();
    written_();
}

}  // namespace poinsot
