#include "cli/still_writer.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace poinsot {

void StillWriter::write(const std::filesystem::path& path, Image&& picture, PngOptions&& png,
                        std::string&& words) {
    finish();
    words_ = std::move(words);
    // Where no thread can be had, finish() writes.
    written_ = std::async([path, picture = std::move(picture), png = std::move(png)] {
        write_png(path, picture, png);
    });
}

void StillWriter::finish() {
    if (!written_.valid()) return;
    written_.get();
    fmt::print(stderr, "{}", words_);
}

}  // namespace poinsot
