#include "production/records/verify.h"

#include <fmt/format.h>

#include <optional>
#include <system_error>

#include "encoding/film_end.h"
#include "encoding/film_file_hash.h"
#include "encoding/film_packets.h"
#include "encoding/video_reader.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "production/records/page_text.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"

namespace poinsot {

namespace {

// Describes bytes appended to a file; empty if there are none.
std::string bytes_behind(std::uintmax_t n_bytes) {
    if (n_bytes == 0) return "";
    return fmt::format("{} follow{} its end",
                       n_bytes == 1 ? "a byte" : fmt::format("{} bytes", n_bytes),
                       n_bytes == 1 ? "s" : "");
}

// Whether a film is unchanged besides its pictures' packets: times, order, rotation, shape,
// colours, index and captions. A GIF has its own in its packets.
enum class Rest { unchanged, changed, unknown };

Rest rest_of(const std::filesystem::path& film, const Record& record) {
    if (record.file.empty()) return begins_with(film, "GIF") ? Rest::unchanged : Rest::unknown;
    return file_hash_of(film, record.text) == record.file ? Rest::unchanged : Rest::changed;
}

// The known difference between what a player shows and what was recorded, in words.
std::string shown_otherwise(const std::filesystem::path& film, const Record& record) {
    try {
        const VideoInfo info = VideoReader(film).info();
        if (info.display != upright) return ": it is shown turned or mirrored";
        if (info.width_px != record.width_px || info.height_px != record.height_px)
            return fmt::format(": it has {}×{} pixels", info.width_px, info.height_px);
        if (info.pixel_width != info.pixel_height) return ": it is shown stretched";
    } catch (const Error&) {
        return ": it cannot be played";
    }
    return ", such as times, colours or captions";
}

Verification verify_film(const std::filesystem::path& film, const Record& record) {
    const auto changed = [](std::string_view what) {
        return Verification{Verified::no,
                            fmt::format("{}; the file was changed after it was written", what)};
    };
    if (packet_hash_of(film) != record.packets)
        return changed("its pictures do not match its record");
    const auto end = end_of_film(film);
    const std::uintmax_t n_bytes = std::filesystem::file_size(film);
    if (end && *end > n_bytes) return changed("its end is missing");
    if (end && *end < n_bytes) return changed(bytes_behind(n_bytes - *end));
    switch (rest_of(film, record)) {
        case Rest::unchanged:
            return {Verified::yes, "unchanged, record and pictures"};
        case Rest::changed:
            return {Verified::no,
                    fmt::format("its record and its coded pictures are unchanged, but other data "
                                "are not{}; the file was changed after it was written, or another "
                                "program wrote it again",
                                shown_otherwise(film, record))};
        case Rest::unknown:
            break;
    }
    return {Verified::cannot_be,
            "its record and its coded pictures are unchanged, but whether its times, rotation, "
            "colours and captions are cannot be verified: its record has no hash of them (older "
            "versions wrote none, nor do browsers that write straight to disk)"};
}

}  // namespace

Verification verify(const std::filesystem::path& file, const Record& record) {
    const bool is_picture = suffix_of(file) == ".png";
    const bool is_page = is_vector_name(file);
    const std::string& then = is_page ? record.page : is_picture ? record.pixels : record.packets;
    if (!record.sealed || then.empty())
        return {Verified::cannot_be,
                "its record has no hash (older versions wrote none), so it cannot be verified"};
    if (!is_page && !is_picture) return verify_film(file, record);
    bool same = false;
    std::string behind;
    if (is_page) {
        const VectorText page = read_vector_text(file);
        same = page.page_hash == then;
        if (!page.is_last) behind = "something was appended to its end";
    } else {
        const PngInfo info = read_png_info(file);
        same = info.width_px == record.width_px && info.height_px == record.height_px &&
               pixels_xxh64_of(file) == then;
        behind = bytes_behind(info.n_bytes_behind);
    }
    if (same && !behind.empty())
        return {Verified::no, fmt::format("{}; the file was changed after it was written", behind)};
    if (same) return {Verified::yes, "unchanged, record and pictures"};
    return {Verified::no,
            fmt::format("its {} its record; the file was changed after it was written",
                        is_page ? "page does not match" : "pixels do not match")};
}

bool is_quickly_verified(const std::filesystem::path& file, const Record& record) {
    constexpr std::uintmax_t few_bytes = 1 << 24;
    constexpr std::int64_t few_pixels = 1 << 24;
    std::error_code error;
    const std::uintmax_t n_bytes = std::filesystem::file_size(file, error);
    return !error && n_bytes <= few_bytes &&
           std::int64_t{record.width_px} * record.height_px <= few_pixels;
}

}  // namespace poinsot
