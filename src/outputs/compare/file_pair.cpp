#include "compare/file_pair.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <fstream>
#include <utility>

#include "error/error.h"
#include "image/files/png_files.h"
#include "production/records/record_difference.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace fs = std::filesystem;

void MachineShare::need(std::int64_t n_pixels) {
    constexpr std::int64_t many_pixels = 1 << 24;
    if (n_pixels > many_pixels && alone_.mutex() != nullptr && !alone_.owns_lock()) alone_.lock();
}

void MachineShare::need(const fs::path& png) {
    if (alone_.mutex() == nullptr || kind_of_file(png) != FileKind::regular) return;
    try {
        const PngInfo info = read_png_info(png);
        need(std::int64_t{info.width_px} * info.height_px);
    } catch (const Error&) {
        return;  // reported when it is compared
    }
}

IgnoredRegions::IgnoredRegions(std::vector<IgnoredRegion> regions, const Records& records)
    : regions_(std::move(regions)) {
    for (const IgnoredRegion& region : regions_)
        if (!region.rectangle) names_.push_back(region.text);
    if (names_.empty()) return;
    for (const auto* record : {&records.expected, &records.actual}) {
        if (!*record) continue;
        pictures_.emplace_back(**record);
        first_frames_.push_back(
            (*record)->frames ? (*record)->frame.value_or((*record)->frames->first) : 0);
    }
    if (pictures_.empty())
        throw InputError(fmt::format(
            "neither picture has a record that says where to find {}; ignore a rectangle "
            "instead, as 0,0,100%,10%, or ignore the name only in pictures by poinsot, with "
            "[[pictures]] in {}",
            fmt::join(names_, ", "), compare_file_name));
}

std::vector<PictureRegion> IgnoredRegions::in(int width, int height, std::int64_t frame) {
    std::vector<PictureRegion> all;
    for (const IgnoredRegion& region : regions_)
        if (region.rectangle) all.push_back(region.in(width, height));
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
        const std::vector<PictureRegion> named =
            pictures_[i].regions_of(names_, width, first_frames_[i] + frame, found_);
        all.insert(all.end(), named.begin(), named.end());
    }
    return all;
}

Outcome outcome_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return Outcome::same;
        case Verdict::within_limits:
            return Outcome::within_limits;
        case Verdict::size_differs:
            return Outcome::size;
        case Verdict::depth_differs:
            return Outcome::depth;
        case Verdict::colours_differ:
            return Outcome::colours;
        case Verdict::pixels_differ:
            break;
    }
    return Outcome::pixels;
}

bool is_picture_name(const fs::path& file) { return suffix_of(file) == ".png"; }

std::optional<Record> find_record(const fs::path& file) {
    try {
        return read_record(file);
    } catch (const InputError&) {
        return std::nullopt;  // rendered by another program
    }
}

bool have_same_bytes(const fs::path& a, const fs::path& b) {
    if (kind_of_file(a) != FileKind::regular || kind_of_file(b) != FileKind::regular) return false;
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    if (fs::file_size(a, error) != fs::file_size(b, error) || error) return false;
    // In pieces: films may be larger than memory.
    std::array<std::ifstream, 2> files{std::ifstream(a, std::ios::binary),
                                       std::ifstream(b, std::ios::binary)};
    std::array<std::string, 2> pieces{std::string(1 << 20, '\0'), std::string(1 << 20, '\0')};
    for (;;) {
        for (std::size_t i = 0; i < 2; ++i) {
            files[i].read(pieces[i].data(), std::ssize(pieces[i]));
            pieces[i].resize(static_cast<std::size_t>(files[i].gcount()));
            if (files[i].bad() || !files[i].is_open()) return false;
        }
        if (pieces[0] != pieces[1]) return false;
        if (files[0].eof() || files[1].eof()) return files[0].eof() && files[1].eof();
    }
}

void add_ignored_pixels(ComparedPicture& result) {
    const std::int64_t n = result.measured.n_ignored;
    if (n == 0 || result.reason.empty()) return;
    result.reason += fmt::format("; {} {} ignored ({})", n, n == 1 ? "pixel" : "pixels",
                                 printable(fmt::format("{}", fmt::join(result.ignored, "; "))));
}

void add_record_differences(const Records& records, ComparedPicture& result) {
    if (result.outcome == Outcome::same || !records.expected || !records.actual) return;
    try {
        result.changes = differences_in_words(*records.expected, *records.actual);
    } catch (const InputError&) {
        // The scene of an old record is no TOML for this program.
    }
}

}  // namespace poinsot
