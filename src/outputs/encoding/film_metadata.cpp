#include "encoding/film_metadata.h"

#include <algorithm>
#include <cctype>

#include "encoding/video_reader.h"

namespace poinsot {

namespace {

// Matroska and WebM return names in capitals.
bool same_name(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

}  // namespace

std::string film_metadata(const std::filesystem::path& film) {
    const VideoReader reader(film);
    // A GIF has one comment and no names.
    for (const auto& [name, text] : reader.info().texts)
        // FFmpeg writes the target of a tag in front, if the file names it (RFC 9559,
        // §5.1.8.1.1.2).
        if (same_name(name, metadata_name) ||
            same_name(name, "MOVIE/" + std::string(metadata_name)) ||
            (reader.info().container == "gif" && same_name(name, "comment")))
            return text;
    return "";
}

}  // namespace poinsot
