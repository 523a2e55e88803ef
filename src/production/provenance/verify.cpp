#include "production/provenance/verify.h"

#include <fmt/format.h>

#include <optional>
#include <system_error>

#include "image/files/png_files.h"
#include "output/film_end.h"
#include "output/film_packets.h"
#include "production/provenance/page_text.h"
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

}  // namespace

Verification verify(const std::filesystem::path& file, const Record& record) {
    const bool is_picture = suffix_of(file) == ".png";
    const bool is_page = is_vector_name(file);
    const std::string& then = is_page ? record.page : is_picture ? record.pixels : record.packets;
    if (!record.sealed || then.empty())
        return {Verified::cannot_be,
                "its record has no hash (older versions wrote none), so it cannot be verified"};
    bool same = false;
    std::string behind;
    if (is_page) {
        const VectorText page = read_vector_text(file);
        same = page.page_hash == then;
        if (!page.is_last) behind = "something was appended to its end";
    } else if (is_picture) {
        const PngInfo info = read_png_info(file);
        same = info.width_px == record.width_px && info.height_px == record.height_px &&
               pixels_xxh64_of(file) == then;
        behind = bytes_behind(info.n_bytes_behind);
    } else {
        same = packet_hash_of(file) == then;
        const auto end = same ? end_of_film(file) : std::nullopt;
        if (same && !end)
            return {Verified::cannot_be,
                    "its pictures match its record, but its container does not tell where the file "
                    "ends, so it cannot be verified"};
        const std::uintmax_t n_bytes = std::filesystem::file_size(file);
        if (same && *end > n_bytes) behind = "its end is missing";
        if (same && *end < n_bytes) behind = bytes_behind(n_bytes - *end);
    }
    if (same && !behind.empty())
        return {Verified::no, fmt::format("{}; the file was changed after it was written", behind)};
    if (same) return {Verified::yes, "unchanged, record and pictures"};
    return {Verified::no,
            fmt::format("its {} its record; the file was changed after it was written",
                        is_page      ? "page does not match"
                        : is_picture ? "pixels do not match"
                                     : "pictures do not match")};
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
