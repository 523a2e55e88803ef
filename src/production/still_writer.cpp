#include "production/still_writer.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "text/say.h"

namespace poinsot {

void StillWriter::write(OutputPlace&& place, Image&& picture, PngOptions&& png,
                        std::string&& words) {
    finish();
    words_ = std::move(words);
    place_.emplace(std::move(place));
    // Where no thread can be had, finish() writes.
    written_ = std::async([path = place_->path(), picture = std::move(picture),
                           png = std::move(png)] { write_png(path, picture, png); });
}

void StillWriter::finish() {
    if (!written_.valid()) return;
    written_.get();
    place_.reset();
    say(words_);
}

}  // namespace poinsot
